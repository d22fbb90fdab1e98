#pragma once
/// Drawing (SVG) of curves over the number of nodes. The horizontal axis is logarithmic, the vertical one logarithmic
/// or linear.

#include <string>
#include <utility>
#include <vector>

namespace pdr::bench::scale {

struct Curve {
    std::string name;
    std::vector<std::pair<double, double>> points;  ///< nodes and value; points that the axes cannot show are left out
    bool dashed = false;                            ///< true: claimed or simulated values beside predicted ones
    std::size_t colour = 0;                         ///< index of the colour; curves of one way share it
};

struct Plot {
    std::string title;   ///< title of the vertical axis: "frames per second"
    bool share = false;  ///< true: values from 0 to 1 on a linear axis; false: logarithmic
    std::vector<Curve> curves;
};

std::string svg(const Plot& plot);

}  // namespace pdr::bench::scale
