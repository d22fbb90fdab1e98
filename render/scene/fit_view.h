#pragma once
/// Chooses the view from which a volume is seen first, and how near a camera may come while all of it stays in the
/// image.

#include <memory>
#include <vector>

#include "render/scene/camera.h"
#include "render/volume/volume.h"

namespace pdr {

/// The content that a view is to be filled with.
struct Framed {
    VolumeGeometry box;
    std::shared_ptr<const std::vector<dvec3>> placesMm;  ///< points whose convex hull is shown; null: the whole box
};

/// Fraction of an image that a volume fills, for fittedView(); the rest is for the letters that name the sides.
inline constexpr double kViewFilled = 0.92;

/// Returns the side from which a scan is seen first: the front, or for a thin stack of slices, much less deep than
/// wide, the side from which the slices are looked at: left, front or feet.
StandardView firstView(const VolumeGeometry& geometry);

/// Returns `camera` with its eye moved along the line through the target, as near as possible while every corner of the
/// volume's box stays inside the middle `fraction` of an image with `aspect` = width / height. The height of an
/// orthographic view is set by the same rule. `aspect` > 0; `fraction` in (0, 1]; 0.9 leaves a margin.
Camera fittedView(const Camera& camera, const VolumeGeometry& geometry, double aspect, double fraction);

/// Returns the standard view about the middle of `framed`'s box, as near as the function above would come to the
/// content. Projection, field of view and aperture are those of `lens`; the middle is in focus.
Camera fittedView(StandardView view, const Framed& framed, double aspect, double fraction, const Camera& lens = {});

}  // namespace pdr
