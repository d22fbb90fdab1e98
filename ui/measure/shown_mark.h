#pragma once
/// A measurement as a view shows it.

#include <QString>
#include <cstdint>
#include <vector>

#include "render/base/portable.h"

namespace pdr::ui {

struct ShownMark {
    std::uint64_t id = 0;
    std::vector<dvec3> placesMm;  ///< in the patient (LPS) [mm], joined by lines in their order
    QString text;                 ///< "42.3 ± 0.5 mm"; empty while it is being drawn
    bool selected = false;
    bool operator==(const ShownMark&) const = default;
};

}  // namespace pdr::ui
