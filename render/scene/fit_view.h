#pragma once
/// From where a volume is seen first, and how near a camera may come so that all of it is still in the picture.

#include <memory>
#include <vector>

#include "render/scene/camera.h"
#include "render/volume/volume.h"

namespace pdr {

/// What a view is to be filled with.
struct Framed {
    VolumeGeometry box;
    std::shared_ptr<const std::vector<dvec3>> placesMm;  ///< in it, whose convex hull is seen; null: all of it
};

/// Part of an image that a volume fills, for fittedView(): the rest is for the letters of the sides.
inline constexpr double kViewFilled = 0.92;

/// The side from which a scan is seen first: the front, or where few slices are much less deep than wide, the side from
/// which these are looked at: left, front or feet.
StandardView firstView(const VolumeGeometry& geometry);

/// `camera` with its eye on the same line through the target, as near as possible with every corner of the volume's box
/// inside the middle `fraction` of an image `aspect` = width / height. Orthographic: with its height made so.
/// `aspect` > 0; `fraction` in (0, 1]; 0.9 leaves a margin.
Camera fittedView(const Camera& camera, const VolumeGeometry& geometry, double aspect, double fraction);

/// The standard view about the middle of `framed`'s box, as near as fittedView() would come to what fills it, in the
/// projection, with the field of view and the aperture of `lens`, and sharp in the middle.
Camera fittedView(StandardView view, const Framed& framed, double aspect, double fraction, const Camera& lens = {});

}  // namespace pdr
