#include "app/plan/hole_mark.h"

#include <cmath>
#include <initializer_list>
#include <utility>

#include "app/plan/slice_region.h"

namespace pdr::app {
namespace {

using measure::Place;

bool anyLineReaches(std::span<const Hole> holes, const std::vector<Place>& ends,
                    std::initializer_list<std::pair<std::size_t, std::size_t>> lines) {
    for (const auto& [from, to] : lines)
        if (reachesInto(holes, ends[from].mm, ends[to].mm))
            return true;
    return false;
}

/// Returns whether an ellipse reaches into a hole: where its extent along the normal of the slices is largest.
bool reachesInto(std::span<const Hole> holes, const measure::PlaneEllipse& ellipse) {
    for (const Hole& hole : holes) {
        const dvec3 reach =
            hole.normal * std::hypot(glm::dot(hole.normal, ellipse.halfU), glm::dot(hole.normal, ellipse.halfV));
        if (pdr::reachesInto({&hole, 1}, ellipse.centre - reach, ellipse.centre + reach))
            return true;
    }
    return false;
}

/// Returns whether the outline of a closed figure reaches into a hole: one of its sides does.
bool outlineReaches(std::span<const Hole> holes, const std::vector<Place>& corners) {
    for (std::size_t n = 0; n < corners.size(); ++n)
        if (pdr::reachesInto(holes, corners[n].mm, corners[(n + 1) % corners.size()].mm))
            return true;
    return false;
}

bool shapeReaches(std::span<const Hole> holes, const Measurement& measurement) {
    const std::vector<Place>& places = measurement.places;
    switch (measurement.kind) {
        case MeasureKind::distance:
            return anyLineReaches(holes, places, {{0, 1}});
        case MeasureKind::angle:
            return anyLineReaches(holes, places, {{0, 1}, {1, 2}});
        case MeasureKind::lines:
            return anyLineReaches(holes, places, {{0, 1}, {2, 3}});
        case MeasureKind::point:
            return anyLineReaches(holes, places, {{0, 0}});
        case MeasureKind::ball:
            return false;  // it is nothing but its voxels
        case MeasureKind::ellipse:
            return reachesInto(holes, ellipseOf(places));
        case MeasureKind::polygon:
            break;
    }
    return outlineReaches(holes, places);
}

}  // namespace

Measured markedForHoles(Measured measured, const Measurement& measurement, std::span<const Hole> holes) {
    const bool holdsVoxels = measured.region && measured.region->interpolated > 0;
    measured.acrossHole = holdsVoxels || shapeReaches(holes, measurement);
    if (!measured.acrossHole)
        return measured;
    measured.text = phrase("%1, interpolated across a hole", measured.text);
    measured.details =
        joined(phrase("It reaches where slices were not measured: they are interpolated, and the ± does not know what "
                      "lies between."),
               measured.details);
    return measured;
}

}  // namespace pdr::app
