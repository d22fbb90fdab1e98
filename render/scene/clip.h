#pragma once
/// What is cut away of the volume, in patient space (LPS, mm).

#include <optional>
#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr {

/// Only what lies between the two corners stays.
struct ClipBox {
    dvec3 lowMm{0}, highMm{0};  ///< each in [-1e9, 1e9]; low < high along every axis
    bool operator==(const ClipBox&) const = default;
};

/// All on the side of the normal is cut away.
struct ClipPlane {
    dvec3 pointMm{0};        ///< on the plane; each in [-1e9, 1e9]
    dvec3 normal{0, -1, 0};  ///< any length but 0
    bool operator==(const ClipPlane&) const = default;
};

struct Clip {
    std::optional<ClipBox> box;
    std::vector<ClipPlane> planes;
    bool shadows = false;  ///< whether what is cut away still throws its shadow

    bool empty() const { return !box && planes.empty(); }
    /// The box's sides and the planes.
    std::vector<ClipPlane> allPlanes() const;
    /// Those of them that cut something away of a volume; the others leave all of it.
    std::vector<ClipPlane> planesThrough(const VolumeGeometry& volume) const;
    Result<void> check() const;
    bool operator==(const Clip&) const = default;
};

}  // namespace pdr
