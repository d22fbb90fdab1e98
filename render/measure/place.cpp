#include "render/measure/place.h"

#include <algorithm>
#include <cmath>

namespace pdr::measure {
namespace {

/// Two edges with Gaussian blur of sigma s reach 99 % of their step between them when they are 5 s apart, which is two
/// widths: then the half level is off by 0.02 s.
constexpr double kResolvedMm = 2.5, kResolvedSteps = 2.5, kResolvedWidths = 2;

/// Returns the covariance of a deviation of `sigma` along a unit vector.
dmat3 along(dvec3 direction, double sigma) {
    return sigma * sigma * glm::outerProduct(direction, direction);
}

/// Returns what rounding has left of a symmetric matrix, symmetric to the last bit, as files keep it.
dmat3 symmetric(const dmat3& m) {
    return 0.5 * (m + glm::transpose(m));
}

/// Returns the standard deviation of a uniform distribution of this width.
double uniformSigma(double width) {
    return width / std::sqrt(12.0);
}

dmat3 gridSpread(const VolumeGeometry& geometry) {
    const dmat3 axes = gridAxes(geometry);
    const dvec3 spacing = geometry.spacingMm();
    dmat3 spread(0);
    for (int i = 0; i < 3; ++i)
        spread += along(axes[i], uniformSigma(spacing[i]));
    return spread;
}

}  // namespace

dmat3 Spread::total() const {
    dmat3 sum(0);
    for (const dmat3& each : mm2)
        sum += each;
    return sum;
}

bool isAtEdge(const Place& place) {
    return place.found == Found::atEdge || place.found == Found::pickedEdge;
}

dmat3 gridAxes(const VolumeGeometry& geometry) {
    dmat3 axes(geometry.patientFromIndex);
    for (int i = 0; i < 3; ++i)
        axes[i] = glm::normalize(axes[i]);
    return axes;
}

double stepAlongMm(const VolumeGeometry& geometry, dvec3 direction) {
    return glm::length(geometry.spacingMm() * (glm::transpose(gridAxes(geometry)) * direction));
}

double resolvedMm(const VolumeGeometry& geometry, dvec3 direction, double blurMm) {
    return std::max({kResolvedMm, kResolvedSteps * stepAlongMm(geometry, direction), kResolvedWidths * blurMm});
}

Place typedPlace(dvec3 mm) {
    return {.mm = mm};
}

Place clickedPlace(const VolumeGeometry& geometry, dvec3 mm, const ClickedPlane& plane) {
    Place place{.mm = mm, .found = Found::onSlice};
    place.spread.of(Cause::grid) = gridSpread(geometry);
    const double pixel = uniformSigma(plane.mmPerPixel);
    place.spread.of(Cause::hand) = along(plane.right, pixel) + along(plane.down, pixel) +
                                   along(glm::cross(plane.right, plane.down), uniformSigma(plane.slabMm));
    return place;
}

Place pickedPlace(const VolumeGeometry& geometry, dvec3 mm, dvec3 alongRay, double depthSigma, double pixelSigma) {
    Place place{.mm = mm, .found = Found::picked};
    place.spread.of(Cause::grid) = gridSpread(geometry);
    const dvec3 ray = glm::normalize(alongRay);  // of rays in float, what is longer than 1 would be a negative variance
    place.spread.of(Cause::hand) = pixelSigma * pixelSigma * dmat3(1) - along(ray, pixelSigma);
    place.spread.of(Cause::light) = along(ray, depthSigma);
    return place;
}

Place movedToEdge(Place place, dvec3 mm, dvec3 normal, double edgeSigma, double gridSigma, double blurMm) {
    const bool picked = place.found == Found::picked || place.found == Found::pickedEdge;
    const dmat3 across = dmat3(1) - glm::outerProduct(normal, normal);
    for (dmat3& each : place.spread.mm2)
        each = symmetric(across * each * across);
    place.spread.of(Cause::edge) = along(normal, edgeSigma);
    place.spread.of(Cause::grid) = along(normal, gridSigma);
    place.mm = mm;
    place.found = picked ? Found::pickedEdge : Found::atEdge;
    place.blurMm = blurMm;
    return place;
}

}  // namespace pdr::measure
