#include "app/plan/scan_fit.h"

#include <algorithm>
#include <sstream>

#include "render/measure/trilinear.h"

namespace pdr::app {
namespace {

constexpr double kRounding = 1e-6;  // voxels

/// Returns how far a place lies from the voxels [mm]; 0 in them. In a sheared grid the nearest index is not that of the
/// nearest place: one axis after the other is moved as near as it can, until nothing moves.
double distanceMm(const measure::GridPlace& grid, dvec3 placeMm) {
    constexpr int kPasses = 40;  // each leaves less than half of what was missing at a tilt of 40 degrees
    const dmat3 steps(grid.patientFromIndex), products = glm::transpose(steps) * steps;
    const dvec3 index = grid.index(placeMm), low(-0.5), high = dvec3(grid.size) - 0.5;
    dvec3 away = glm::clamp(index, low, high) - index;
    for (int pass = 0; pass < kPasses; ++pass)
        for (int axis = 0; axis < 3; ++axis) {
            away[axis] = 0;
            const double best = index[axis] - glm::dot(products[axis], away) / products[axis][axis];
            away[axis] = glm::clamp(best, low[axis], high[axis]) - index[axis];
        }
    return glm::length(steps * away);
}

std::string mmText(double mm) {
    std::ostringstream text;
    text.precision(mm < 10 ? 1 : 0);
    text << std::fixed << mm;
    return text.str();
}

/// Returns how many of the first places must lie in the scan: of a ball or an ellipse, its middle.
std::size_t placesInTheScan(const Measurement& measurement) {
    return hasMiddle(measurement.kind) ? 1 : measurement.places.size();
}

}  // namespace

Result<void> checkPlaces(const Plan& plan, const VolumeGeometry& geometry) {
    const measure::GridPlace grid(geometry);
    const dvec3 spacing = geometry.spacingMm();
    const double roundingMm = kRounding * std::min({spacing.x, spacing.y, spacing.z});
    for (std::size_t i = 0; i < plan.measurements.size(); ++i) {
        const Measurement& measurement = plan.measurements[i];
        for (std::size_t k = 0; k < placesInTheScan(measurement); ++k)
            if (const double off = distanceMm(grid, measurement.places[k].mm); off > roundingMm)
                return Error{phrase("measurements[%1].places[%2].mm lies %3 mm outside the scan", i, k, mmText(off)),
                             "", phrase("Correct that place, or remove the measurement from the file."),
                             ErrorKind::refused};
    }
    return {};
}

}  // namespace pdr::app
