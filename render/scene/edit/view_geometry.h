#pragma once
/// Maps places to points of a camera's image, and points to lines of sight. The lens is ignored: the camera is a
/// pinhole.

#include <optional>
#include <utility>

#include "render/scene/camera.h"

namespace pdr {

/// The line of all places under one point of an image.
struct SightLine {
    dvec3 originMm;   ///< the eye, or where the line starts in a parallel view
    dvec3 direction;  ///< unit, away from the viewer
};

/// The projection of a camera. Image points are fractions of its width and height; (0, 0) is its upper left corner.
class ViewGeometry {
  public:
    /// `aspect` = width / height > 0.
    ViewGeometry(const Camera& camera, double aspect);

    const Camera& camera() const { return camera_; }
    double aspect() const { return aspect_; }
    /// Returns where a place is seen, also outside the image; none at and behind the eye.
    std::optional<dvec2> at(dvec3 placeMm) const;
    /// Returns both ends of a line as it is seen, without what lies behind the eye; none if all of it does.
    std::optional<std::pair<dvec2, dvec2>> lineAt(dvec3 fromMm, dvec3 toMm) const;
    SightLine under(dvec2 point) const;
    /// Returns the height of the image at a place's depth [mm]; 0 at and behind the eye.
    double heightMm(dvec3 placeMm) const;

  private:
    double depth(dvec3 placeMm) const;

    Camera camera_;
    double aspect_;
    double heightPerDepth_;  ///< for a perspective view
    dvec3 forward_, right_, up_;
};

}  // namespace pdr
