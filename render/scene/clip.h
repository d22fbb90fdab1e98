#pragma once
/// What is cut away of the volume, in patient space (LPS, mm).

#include <optional>
#include <string>
#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/scene/camera.h"
#include "render/volume/volume.h"

namespace pdr {

/// Only what lies between the two corners stays.
struct ClipBox {
    dvec3 lowMm{0}, highMm{0};  ///< each in [-1e9, 1e9]; low < high along every axis
    bool operator==(const ClipBox&) const = default;
};

/// The smallest one around all voxels, their extents included.
ClipBox boxAround(const VolumeGeometry& volume);

/// All on the side of the normal is cut away.
struct ClipPlane {
    dvec3 pointMm{0};        ///< on the plane; each in [-1e9, 1e9]
    dvec3 normal{0, -1, 0};  ///< any length but 0
    bool operator==(const ClipPlane&) const = default;
};

/// Planes that can be added by hand; a file may hold more.
inline constexpr std::size_t kMostPlanes = 8;

/// A point of a picture, in fractions of its height from its middle.
struct PicturePoint {
    double x = 0, y = 0;  ///< to the right and downwards; each in [-1000, 1000]
    bool operator==(const PicturePoint&) const = default;
};

/// A line drawn on a picture cuts along the view: a cone of what lies behind it, or in a parallel view a prism.
struct FreehandCut {
    Camera camera;                      ///< of the picture; its lens does not count
    std::vector<PicturePoint> outline;  ///< the line's corners, three at least; from the last it goes back to the first
    bool keepInside = false;            ///< else what is inside is cut away
    bool operator==(const FreehandCut&) const = default;
};

struct Clip {
    std::optional<ClipBox> box;
    std::vector<ClipPlane> planes;
    bool shadows = false;  ///< whether what box and planes cut away still throws its shadow
    std::vector<FreehandCut> freehand;

    bool empty() const { return !box && planes.empty() && freehand.empty(); }
    /// The box's sides and the planes.
    std::vector<ClipPlane> allPlanes() const;
    /// Those of them that cut something away of a volume; the others leave all of it.
    std::vector<ClipPlane> planesThrough(const VolumeGeometry& volume) const;
    Result<void> check() const;
    bool operator==(const Clip&) const = default;
};

/// "box, 2 planes, 1 freehand"; empty: nothing is cut.
std::string cutText(const Clip& clip);

}  // namespace pdr
