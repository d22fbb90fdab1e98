#pragma once
/// A pinhole camera in patient space (LPS, mm).

#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr {

struct Camera {
    enum class Type { perspective, orthographic };

    Type type = Type::perspective;
    dvec3 eyeMm{0, -1000, 0};  ///< each in [-1e15, 1e15]
    dvec3 targetMm{0, 0, 0};   ///< each in [-1e15, 1e15]; at least 1e-12 mm from the eye
    dvec3 up{0, 0, 1};         ///< any length but 0; not along the view
    double fovDegrees = 35;    ///< perspective: vertical field of view; [1e-12, 180)
    double heightMm = 300;     ///< orthographic: height of what is seen; [1e-12, 1e9]
    double apertureMm = 0;     ///< lens diameter; [0, 200]; 0 = pinhole
    double focusMm = 0;        ///< distance of the sharp plane from the eye; [1e-12, 1e9]; 0 = the target's

    double focusDistanceMm() const;  ///< focusMm, or else the target's distance
    double heightInFocusMm() const;  ///< of what is seen, in the sharp plane

    dvec3 forward() const;  ///< unit
    dvec3 right() const;    ///< unit; the image's x
    dvec3 imageUp() const;  ///< unit; against the image's y

    Result<void> check() const;
    bool operator==(const Camera&) const = default;
};

/// The six anatomical views, named after the side one looks from.
enum class StandardView { anterior, posterior, left, right, superior, inferior };

/// A perspective camera on that side, far enough to see a sphere of `radiusMm` about `centreMm` in an image `aspect` =
/// width / height.
Camera standardView(StandardView view, dvec3 centreMm, double radiusMm, double aspect);

}  // namespace pdr
