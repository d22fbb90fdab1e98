#pragma once
/// A measurement as a view shows it.

#include <QString>
#include <cstdint>
#include <vector>

#include "render/base/portable.h"

namespace pdr::ui {

/// What is drawn between the places of a mark.
enum class MarkShape {
    path,     ///< lines from each place to the next; nothing at a single one
    lines,    ///< a line from every other place to the next
    ball,     ///< a ball about the first place that reaches as far as the second
    ellipse,  ///< an ellipse about the first place through the second, which reaches as far aside as the third
    polygon,  ///< lines from each place to the next, and from the last to the first
};

/// Returns whether a mark of that shape lies in one slice.
constexpr bool isFlat(MarkShape shape) {
    return shape == MarkShape::ellipse || shape == MarkShape::polygon;
}

struct ShownMark {
    std::uint64_t id = 0;
    MarkShape shape = MarkShape::path;
    std::vector<dvec3> placesMm;  ///< in the patient (LPS) [mm]
    QString text;                 ///< "42.3 ± 0.5 mm"; empty while it is being drawn
    bool selected = false;
    bool operator==(const ShownMark&) const = default;
};

}  // namespace pdr::ui
