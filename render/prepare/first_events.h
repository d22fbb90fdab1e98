#pragma once
/// Where the light under a point of an image meets its first event: F(s) = 1 - exp(-tau(s)), the share of it that has
/// met tissue within a distance s along the ray, and the inverse of F. Both come from free flights, so that they are
/// exact, know every cut and mask, and need no image: the answer is the same after one sample and after a thousand.

#include <vector>

#include "render/kernel/transport/camera_ray.h"

namespace pdr {

class FirstEvents {
  public:
    /// `place`: pixels from the image's upper left corner. The lens is ignored. `scene` must have been prepared for a
    /// model other than maximumIntensity, whose majorants are no bounds on the extinction, and must outlive this
    /// object.
    FirstEvents(const FlatScene& scene, vec2 place);

    /// Returns the part of the ray inside the volume; all distances below are measured along it, from its origin.
    const PathSegment& segment() const { return segment_; }
    /// Returns the share of the light that meets tissue at all, [0, 1].
    double met() const { return met_; }
    /// Returns F(mm). Before the ray's origin it is 0, and behind its end it is met().
    double metBefore(double mm) const;
    /// Returns the distance at which F reaches `share` [mm]. `share`: above 0 and below met().
    double where(double share) const;
    /// Returns the distances at which F reaches (i + 0.5) / `count` of met() [mm], in ascending order; none if no light
    /// meets tissue.
    std::vector<double> quantiles(int count) const;

  private:
    const FlatScene& scene_;
    PathSegment segment_;
    double met_;
};

}  // namespace pdr
