#pragma once
/// A pinhole camera in patient space (LPS, mm).

#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr {

struct Camera {
    enum class Type { perspective, orthographic };

    Type type = Type::perspective;
    dvec3 eyeMm{0, -1000, 0};  ///< position of the eye; each coordinate in [-1e15, 1e15]
    dvec3 targetMm{0, 0, 0};   ///< point in the image's middle; each in [-1e15, 1e15]; at least 1e-12 mm from the eye
    dvec3 up{0, 0, 1};         ///< upward direction; any length but 0; not along the view
    double fovDegrees = 35;    ///< perspective: vertical field of view; [1e-12, 180)
    double heightMm = 300;     ///< orthographic: height of the visible area; [1e-12, 1e9]
    double apertureMm = 0;     ///< lens diameter; [0, 200]; 0 = pinhole
    double focusMm = 0;        ///< distance of the sharp plane from the eye; [1e-12, 1e9]; 0 = the target's distance

    double focusDistanceMm() const;  ///< focusMm, or the target's distance if focusMm is 0
    double heightInFocusMm() const;  ///< height of the visible area in the sharp plane

    dvec3 forward() const;  ///< unit vector from the eye to the target
    dvec3 right() const;    ///< unit vector along the image's x axis
    dvec3 imageUp() const;  ///< unit vector against the image's y axis

    Result<void> check() const;
    bool operator==(const Camera&) const = default;
};

/// The six anatomical views, named after the side one looks from.
enum class StandardView { anterior, posterior, left, right, superior, inferior };

/// Returns a perspective camera on that side, far enough away that a sphere of radius `radiusMm` about `centreMm` fits
/// into an image with `aspect` = width / height.
Camera standardView(StandardView view, dvec3 centreMm, double radiusMm, double aspect);

}  // namespace pdr
