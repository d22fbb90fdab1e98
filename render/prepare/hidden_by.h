#pragma once
/// What hides a place of the patient from the eye.

#include <optional>

#include "render/prepare/prepared_scene.h"

namespace pdr {

struct HiddenBy {
    double transmittance;  ///< share of the light from the place that reaches the eye past the tissue in front; [0, 1]
    double tissueMm;  ///< length of the line of sight before the place on which tissue shows at all: its opacity and
                      ///< its visibility weight are above 0, and it is not cut away
    bool cutAway;     ///< the place itself is cut away, or its visibility weight is below one half

    /// Returns whether marks at the place are drawn as hidden: less than half of the light from it arrives.
    bool hidden() const { return transmittance < 0.5; }
};

/// Returns what hides `placeMm`, in the patient (LPS), through a pinhole; none at and behind the eye. `scene` must come
/// from Flattener::prepare(). Absorption, emission and maximumIntensity show all depths, so that nothing is hidden by
/// what lies in front.
std::optional<HiddenBy> hiddenBy(const PreparedScene& scene, dvec3 placeMm);

}  // namespace pdr
