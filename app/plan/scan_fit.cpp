#include "app/plan/scan_fit.h"

#include <sstream>

namespace pdr::app {
namespace {

constexpr double kRounding = 1e-6;  // voxels

/// Returns how far a place lies from the voxels [mm]; 0 in them.
double distanceMm(const VolumeGeometry& geometry, dvec3 placeMm) {
    const dvec3 index(glm::inverse(geometry.patientFromIndex) * dvec4(placeMm, 1));
    const dvec3 nearest = glm::clamp(index, dvec3(-0.5), dvec3(geometry.size) - 0.5);
    return glm::length(dvec3(geometry.patientFromIndex * dvec4(index - nearest, 0)));
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

bool liesIn(const VolumeGeometry& geometry, dvec3 placeMm) {
    const dvec3 spacing = geometry.spacingMm();
    return distanceMm(geometry, placeMm) <= kRounding * std::min({spacing.x, spacing.y, spacing.z});
}

Result<void> checkFits(const SavedPlan& saved, const Volume& volume) {
    if (auto ok = checkIsScanOf(saved.scan, volume); !ok)
        return ok;
    for (std::size_t i = 0; i < saved.plan.measurements.size(); ++i) {
        const Measurement& measurement = saved.plan.measurements[i];
        for (std::size_t k = 0; k < placesInTheScan(measurement); ++k)
            if (const dvec3 mm = measurement.places[k].mm; !liesIn(volume.geometry(), mm))
                return Error{phrase("measurements[%1].places[%2].mm lies %3 mm outside the scan", i, k,
                                    mmText(distanceMm(volume.geometry(), mm))),
                             "", phrase("Correct that place, or remove the measurement from the file."),
                             ErrorKind::refused};
    }
    return {};
}

}  // namespace pdr::app
