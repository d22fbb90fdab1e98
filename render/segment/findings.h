#pragma once
/// Findings of a scan that decide which looks make sense and where their curves lie. Rules over block means, without
/// learning: they offer looks, and nothing is measured by them.

#include <optional>

#include "render/volume/volume.h"

namespace pdr::segment {

struct Findings {
    double widthMm = 0;          ///< width of the body, from right to left
    double lungMl = 0;           ///< uniform cells of -950 to -600 HU
    double metalMl = 0;          ///< voxels above 2500 HU
    std::optional<float> blood;  ///< HU of blood with contrast: peak of the bright, uniform cells above 180 HU

    bool operator==(const Findings&) const = default;
};

/// Returns the findings of `scan`, without its table where that is known; `bodyBox`: the part of its grid that
/// holds the body. The same for any number of threads. None of a scan whose values are no HU.
Findings findingsOn(const Volume& scan, const VolumeGeometry& bodyBox);

}  // namespace pdr::segment
