#pragma once
/// Where places are in a camera's picture, and what lies under its points. Of a pinhole: what is sharp in a lens.

#include <optional>
#include <utility>

#include "render/scene/camera.h"

namespace pdr {

/// All that lies under one point of a picture.
struct SightLine {
    dvec3 originMm;   ///< the eye, or where a parallel view starts
    dvec3 direction;  ///< unit, away from the viewer
};

/// Points of the picture are fractions of its width and height, (0, 0) is its upper left corner.
class ViewGeometry {
  public:
    /// `aspect` = width / height > 0.
    ViewGeometry(const Camera& camera, double aspect);

    const Camera& camera() const { return camera_; }
    double aspect() const { return aspect_; }
    /// Where a place is seen, also outside the picture; nothing at and behind the eye.
    std::optional<dvec2> at(dvec3 placeMm) const;
    /// Both ends of a line as it is seen; without what lies behind the eye, and nothing where all of it does.
    std::optional<std::pair<dvec2, dvec2>> lineAt(dvec3 fromMm, dvec3 toMm) const;
    SightLine under(dvec2 point) const;
    /// What the picture's height is at a place's depth [mm]; 0 at and behind the eye.
    double heightMm(dvec3 placeMm) const;

  private:
    double depth(dvec3 placeMm) const;

    Camera camera_;
    double aspect_;
    double heightPerDepth_;  ///< perspective
    dvec3 forward_, right_, up_;
};

}  // namespace pdr
