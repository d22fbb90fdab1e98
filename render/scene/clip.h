#pragma once
/// The part of the volume that is cut away, in patient space (LPS, mm).

#include <optional>
#include <string>
#include <vector>

#include "render/base/portable.h"
#include "render/base/result.h"
#include "render/scene/camera.h"
#include "render/volume/volume.h"

namespace pdr {

/// A box along the patient's axes; everything outside it is cut away.
struct ClipBox {
    dvec3 lowMm{0}, highMm{0};  ///< each in [-1e9, 1e9]; low < high along every axis
    bool operator==(const ClipBox&) const = default;
};

/// Returns the smallest box that contains all voxels, including their extents.
ClipBox boxAround(const VolumeGeometry& volume);

/// A plane; everything on the side that its normal points to is cut away.
struct ClipPlane {
    dvec3 pointMm{0};        ///< a point of the plane; each coordinate in [-1e9, 1e9]
    dvec3 normal{0, -1, 0};  ///< any length but 0
    bool operator==(const ClipPlane&) const = default;
};

/// Largest number of planes that a user can add; a file may hold more.
inline constexpr std::size_t kMostPlanes = 8;

/// A point of an image, relative to the image's middle, in units of the image's height.
struct ImagePoint {
    double x = 0, y = 0;  ///< x to the right, y downwards; each in [-1000, 1000]
    bool operator==(const ImagePoint&) const = default;
};

/// A cut along the view through a closed line drawn on an image: a cone behind the line, or a prism in a parallel view.
struct FreehandCut {
    Camera camera;                    ///< camera of the image that the line was drawn on; its lens is ignored
    std::vector<ImagePoint> outline;  ///< corners of the line, at least three; it returns from the last to the first
    bool keepInside = false;  ///< true: what lies behind the inside stays, all else is cut away; false: the reverse
    bool operator==(const FreehandCut&) const = default;
};

struct Clip {
    std::optional<ClipBox> box;
    std::vector<ClipPlane> planes;
    bool shadows = false;  ///< whether tissue that box and planes cut away still casts shadows
    std::vector<FreehandCut> freehand;

    bool empty() const { return !box && planes.empty() && freehand.empty(); }
    /// Returns the sides of the box and the planes in one list.
    std::vector<ClipPlane> allPlanes() const;
    /// Returns those of allPlanes() that cut something away of `volume`.
    std::vector<ClipPlane> planesThrough(const VolumeGeometry& volume) const;
    Result<void> check() const;
    bool operator==(const Clip&) const = default;
};

/// Describes the cut in short: "box, 2 planes, 1 freehand"; empty if nothing is cut.
std::string cutText(const Clip& clip);

}  // namespace pdr
