#include "app/plan/measured_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/plan/slice_region.h"
#include "render/measure/area.h"
#include "render/measure/measured_voxels.h"

namespace pdr::app {
namespace {

using measure::Place;
using measure::Stated;
using measure::Unit;

/// Returns the statistics of the voxels in `shape`, which encloses `mm3`.
Result<measure::RegionStatistics> statisticsOf(const Volume& volume, const measure::MeasuredShape& shape, double mm3) {
    const double voxelMm3 = std::abs(glm::determinant(dmat3(volume.geometry().patientFromIndex)));
    if (mm3 > kMostRegionVoxels * voxelMm3)
        return Error{phrase("this region holds more than %1 voxels", int(kMostRegionVoxels)), "",
                     phrase("Make it smaller."), ErrorKind::refused};
    return measure::regionStatistics(volume, shape);
}

/// Returns the statistics of the layer of voxels along the plane of a flat shape.
Result<measure::RegionStatistics> statisticsOf(const Volume& volume, const measure::MeasuredShape& shape,
                                               const Stated& area, dvec3 normal) {
    return statisticsOf(volume, shape, area.value * measure::layerMm(volume.geometry(), normal));
}

/// `region`: the statistics of the voxels of `volume`.
Measured meanOf(const measure::RegionStatistics& region, const Volume& volume) {
    const ValueUnit unit = unitOf(volume);
    const measure::RegionStatistics values = measure::inValues(region, unit);
    return {.unit = Unit::hu,
            .valueUnit = unit,
            .value = values.meanHu,
            .plusMinus = values.meanPlusMinus,
            .region = values,
            .text = measure::meanText(values, unit),
            .details = measure::regionText(values, unit)};
}

/// The farthest that a corner lies off the plane of its polygon [mm].
constexpr double kFlatMm = 0.01;

bool isFlat(const std::vector<Place>& corners, dvec3 normal) {
    return std::ranges::all_of(
        corners, [&](const Place& each) { return std::abs(glm::dot(each.mm - corners[0].mm, normal)) <= kFlatMm; });
}

measure::PlanePolygon polygonOf(const std::vector<Place>& corners) {
    measure::PlanePolygon polygon{{}, *normalOf(corners)};
    for (const Place& corner : corners)
        polygon.corners.push_back(corner.mm);
    return polygon;
}

}  // namespace

Result<Measured> measuredBall(const std::vector<Place>& places, const Volume& volume) {
    const double radius = glm::distance(places[0].mm, places[1].mm);
    const auto region =
        statisticsOf(volume, measure::Ball{places[0].mm, radius}, 4 * std::numbers::pi / 3 * radius * radius * radius);
    if (!region)
        return region.error();
    return meanOf(*region, volume);
}

Result<Measured> measuredEllipse(const std::vector<Place>& places, const Volume& volume) {
    const auto area = measure::ellipseArea(places[0], places[1], places[2]);
    if (!area)
        return area.error();
    const measure::PlaneEllipse ellipse = ellipseOf(places);
    const auto region = statisticsOf(volume, ellipse, *area, *normalOf(places));
    if (!region)
        return region.error();
    Measured measured = meanOf(*region, volume);
    measured.area = *area;
    measured.details = joined(phrase("Area %1.", measure::valueText(*area, Unit::mm2)), measured.details);
    return measured;
}

Result<Measured> areaOfPolygon(const std::vector<Place>& corners) {
    const auto normal = normalOf(corners);
    if (!normal)
        return Error{phrase("the outline encloses nothing"), "", phrase("Move its corners."), ErrorKind::refused};
    if (!isFlat(corners, *normal))
        return Error{phrase("the corners do not lie in one plane"), "", phrase("Move its corners."),
                     ErrorKind::refused};
    const auto area = measure::polygonArea(corners, *normal);
    if (!area)
        return area.error();
    Measured measured;
    measured.unit = Unit::mm2;
    measured.value = area->value;
    measured.plusMinus = plusMinusOf(*area);
    measured.bound = area->bound;
    measured.area = *area;
    measured.text = measure::valueText(*area, Unit::mm2);
    measured.details = measure::causesText(*area);
    return measured;
}

Result<Measured> measuredPolygon(const std::vector<Place>& corners, const Volume& volume) {
    Result<Measured> measured = areaOfPolygon(corners);
    if (!measured)
        return measured;
    const measure::PlanePolygon polygon = polygonOf(corners);
    const auto region = statisticsOf(volume, polygon, *measured->area, polygon.normal);
    if (!region) {
        measured->details = joined(Text::sentence(region.error().what), measured->details);
        return measured;
    }
    const Measured mean = meanOf(*region, volume);
    measured->valueUnit = mean.valueUnit;
    measured->region = mean.region;
    measured->details = joined(measured->details, joined(phrase("Mean %1.", mean.text), mean.details));
    return measured;
}

}  // namespace pdr::app
