#pragma once
/// Something that changed how fast the error falls: a render node came or went.

#include <QString>
#include <vector>

namespace pdr::ui {

struct PlotEvent {
    double seconds = 0;  ///< of rendering, as in ErrorPoint
    QString text;        ///< "gpu-07 was lost: the connection was cut"
    bool joined = true;  ///< false: it was lost, and the curve falls more slowly
    bool operator==(const PlotEvent&) const = default;
};
using PlotEvents = std::vector<PlotEvent>;

}  // namespace pdr::ui
