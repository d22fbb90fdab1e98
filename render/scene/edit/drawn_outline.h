#pragma once
/// A closed line drawn on a picture: with fewer corners, and how far away it is.

#include <vector>

#include "render/scene/clip.h"

namespace pdr {

/// With as few corners as keep every point of `outline` within `tolerance` [picture heights] of the line (Ramer,
/// Douglas & Peucker 1972). Fewer than three where there is no more to it than a line.
std::vector<PicturePoint> simplified(const std::vector<PicturePoint>& outline, double tolerance);

/// The area inside [picture heights squared]; parts that the line goes around the other way count against it.
double areaInside(const std::vector<PicturePoint>& outline);

/// The distance from a closed line, on a grid that is looked up. Inside is where a ray to the outside crosses the line
/// an odd number of times.
class OutlineDistance {
  public:
    /// At least three corners.
    explicit OutlineDistance(const std::vector<PicturePoint>& outline);

    /// Picture heights, positive inside. It is off by less than gridStep(); far outside it is a lower bound.
    double at(dvec2 place) const;
    double gridStep() const { return step_; }

  private:
    static constexpr int kCells = 256;  ///< along the outline's longer side

    float node(int i, int j) const { return distance_[std::size_t(j) * std::size_t(size_.x) + std::size_t(i)]; }

    dvec2 low_{0};
    double step_ = 1;
    ivec2 size_{0};
    std::vector<float> distance_;
};

}  // namespace pdr
