#pragma once
/// The parts of a patient that an image shows. The choice is stored; the mask that it yields for a scan is not
/// (scene/visible_mask.h).

#include "render/segment/labels.h"

namespace pdr {

struct Visible {
    segment::Labels shown;   ///< the parts that alone are shown; empty: all of the patient
    segment::Labels hidden;  ///< the parts that are left out of those
    double peelMm = 0;       ///< thickness that is removed all around the body; [0, 50]

    bool all() const { return *this == Visible{}; }
    bool operator==(const Visible&) const = default;
};

}  // namespace pdr
