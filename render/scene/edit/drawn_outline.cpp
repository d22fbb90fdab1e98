#include "render/scene/edit/drawn_outline.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace pdr {
namespace {

dvec2 placeOf(const ImagePoint& point) {
    return {point.x, point.y};
}

double distanceToLine(dvec2 place, dvec2 a, dvec2 b) {
    const dvec2 along = b - a;
    const double squared = glm::dot(along, along);
    const double part = squared > 0 ? std::clamp(glm::dot(place - a, along) / squared, 0.0, 1.0) : 0;
    return glm::distance(place, a + along * part);
}

/// Appends the corners that are needed between `first` and `last`, and `last`.
void addCorners(const std::vector<ImagePoint>& line, std::size_t first, std::size_t last, double tolerance,
                std::vector<ImagePoint>& corners) {
    std::size_t farthest = first;
    double away = tolerance;
    for (std::size_t i = first + 1; i < last; ++i)
        if (const double d = distanceToLine(placeOf(line[i]), placeOf(line[first]), placeOf(line[last])); d > away) {
            away = d;
            farthest = i;
        }
    if (farthest == first)
        return corners.push_back(line[last]);
    addCorners(line, first, farthest, tolerance, corners);
    addCorners(line, farthest, last, tolerance, corners);
}

bool isInside(const std::vector<ImagePoint>& outline, dvec2 place) {
    bool inside = false;
    for (std::size_t i = 0, before = outline.size() - 1; i < outline.size(); before = i++) {
        const dvec2 a = placeOf(outline[before]), b = placeOf(outline[i]);
        if ((a.y > place.y) != (b.y > place.y) && place.x < a.x + (b.x - a.x) * (place.y - a.y) / (b.y - a.y))
            inside = !inside;
    }
    return inside;
}

double signedDistance(const std::vector<ImagePoint>& outline, dvec2 place) {
    double nearest = 1e300;
    for (std::size_t i = 0, before = outline.size() - 1; i < outline.size(); before = i++)
        nearest = std::min(nearest, distanceToLine(place, placeOf(outline[before]), placeOf(outline[i])));
    return isInside(outline, place) ? nearest : -nearest;
}

}  // namespace

/// Simplifies the line in two halves: from the first corner to the one farthest from it, and back.
std::vector<ImagePoint> simplified(const std::vector<ImagePoint>& outline, double tolerance) {
    if (outline.size() < 3)
        return {};
    std::size_t farthest = 0;
    const auto away = [&](std::size_t i) { return glm::distance(placeOf(outline[i]), placeOf(outline[0])); };
    for (std::size_t i = 1; i < outline.size(); ++i)
        if (away(i) > away(farthest))
            farthest = i;
    std::vector<ImagePoint> closed = outline, corners;
    closed.push_back(outline.front());
    addCorners(closed, 0, farthest, tolerance, corners);
    addCorners(closed, farthest, closed.size() - 1, tolerance, corners);
    return corners.size() < 3 ? std::vector<ImagePoint>{} : corners;
}

double areaInside(const std::vector<ImagePoint>& outline) {
    double twice = 0;
    for (std::size_t i = 0, before = outline.size() - 1; i < outline.size(); before = i++)
        twice += outline[before].x * outline[i].y - outline[i].x * outline[before].y;
    return std::fabs(twice) / 2;
}

OutlineDistance::OutlineDistance(const std::vector<ImagePoint>& outline) {
    dvec2 low(1e300), high(-1e300);
    for (const ImagePoint& point : outline) {
        low = glm::min(low, placeOf(point));
        high = glm::max(high, placeOf(point));
    }
    const dvec2 edges = high - low;
    step_ = std::max(std::max(edges.x, edges.y) / kCells, 1e-12);
    low_ = low - step_;  // one row of nodes outside the outline
    size_ = ivec2(glm::ceil(edges / step_)) + 3;
    distance_.resize(std::size_t(size_.x) * std::size_t(size_.y));
    tbb::parallel_for(0, size_.y, [&](int j) {
        for (int i = 0; i < size_.x; ++i)
            distance_[std::size_t(j) * std::size_t(size_.x) + std::size_t(i)] =
                float(signedDistance(outline, low_ + dvec2(i, j) * step_));
    });
}

double OutlineDistance::at(dvec2 place) const {
    const dvec2 grid = (place - low_) / step_;
    const dvec2 within = glm::clamp(grid, dvec2(0), dvec2(size_ - 1));
    const ivec2 corner = glm::min(ivec2(within), size_ - 2);
    const dvec2 part = within - dvec2(corner);
    const double above = glm::mix(double(node(corner.x, corner.y)), double(node(corner.x + 1, corner.y)), part.x);
    const double below =
        glm::mix(double(node(corner.x, corner.y + 1)), double(node(corner.x + 1, corner.y + 1)), part.x);
    return glm::mix(above, below, part.y) - glm::distance(grid, within) * step_;
}

}  // namespace pdr
