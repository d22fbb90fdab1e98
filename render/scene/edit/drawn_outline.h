#pragma once
/// Simplification, area and distance of a closed line drawn on an image.

#include <vector>

#include "render/scene/clip.h"

namespace pdr {

/// Returns `outline` with fewer corners, such that every point of it stays within `tolerance` [image heights] of the
/// line (Ramer, Douglas & Peucker 1972). Empty if fewer than three corners would remain.
std::vector<ImagePoint> simplified(const std::vector<ImagePoint>& outline, double tolerance);

/// Returns the area inside [image heights squared]; parts that the line goes around the other way are subtracted.
double areaInside(const std::vector<ImagePoint>& outline);

/// The distance from a closed line, tabulated on a grid. A point is inside if a ray from it to the outside crosses the
/// line an odd number of times.
class OutlineDistance {
  public:
    /// Tabulates the distance from `outline`, which has at least three corners.
    explicit OutlineDistance(const std::vector<ImagePoint>& outline);

    /// Returns the distance [image heights], positive inside. Its error is below gridStep(); far outside it is a lower
    /// bound.
    double at(dvec2 place) const;
    double gridStep() const { return step_; }

  private:
    static constexpr int kCells = 256;  ///< cells along the outline's longer side

    float node(int i, int j) const { return distance_[std::size_t(j) * std::size_t(size_.x) + std::size_t(i)]; }

    dvec2 low_{0};
    double step_ = 1;
    ivec2 size_{0};
    std::vector<float> distance_;
};

}  // namespace pdr
