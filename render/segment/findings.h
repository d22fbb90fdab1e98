#pragma once
/// What a scan holds, as far as it decides which looks make sense and where their curves lie. Rules over block means,
/// no learning: they offer looks, and nothing is measured by them.

#include <optional>

#include "render/volume/volume.h"

namespace pdr::segment {

struct Findings {
    double widthMm = 0;          ///< of the body, from right to left
    double lungMl = 0;           ///< even cells of -950 to -600 HU
    double metalMl = 0;          ///< voxels above 2500 HU
    std::optional<float> blood;  ///< HU of blood with contrast: the peak of the bright and even cells above 180 HU

    bool operator==(const Findings&) const = default;
};

/// Of `scan`, without its table where that is known; `bodyBox`: the part of its grid that holds the body. The same for
/// any number of threads.
Findings findingsOn(const Volume& scan, const VolumeGeometry& bodyBox);

}  // namespace pdr::segment
