#pragma once
/// An event that changed how fast the error falls: a render node joined or was lost.

#include <QString>
#include <vector>

namespace pdr::ui {

struct PlotEvent {
    double seconds = 0;  ///< rendering time, as in ErrorPoint
    QString text;        ///< "gpu-07 was lost: the connection was cut"
    bool joined = true;  ///< false: the node was lost, and the curve falls more slowly
    bool operator==(const PlotEvent&) const = default;
};
using PlotEvents = std::vector<PlotEvent>;

}  // namespace pdr::ui
