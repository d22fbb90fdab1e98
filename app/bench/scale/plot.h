#pragma once
/// A drawing (SVG) of curves over the number of nodes, both axes logarithmic or the height linear.

#include <string>
#include <utility>
#include <vector>

namespace pdr::bench::scale {

struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;  ///< nodes, value; those that the axes cannot show are left out
    bool dashed = false;                            ///< what is claimed or played beside what is foretold
    std::size_t colour = 0;                         ///< curves of one thing share it
};

struct Plot {
    std::string title;   ///< of the height: "frames per second"
    bool share = false;  ///< values from 0 to 1, linear; else logarithmic
    std::vector<Curve> curves;
};

std::string svg(const Plot& plot);

}  // namespace pdr::bench::scale
