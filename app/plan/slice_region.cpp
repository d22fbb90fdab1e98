#include "app/plan/slice_region.h"

namespace pdr::app {
namespace {

using measure::Place;

/// Returns a vector across the polygon over the places, twice its area long (Newell's method).
dvec3 acrossOf(const std::vector<Place>& places) {
    dvec3 across(0);
    for (std::size_t n = 1; n + 1 < places.size(); ++n)
        across += glm::cross(places[n].mm - places[0].mm, places[n + 1].mm - places[0].mm);
    return across;
}

/// Returns the part of `v` across the vector `u`.
dvec3 partAcross(dvec3 v, dvec3 u) {
    const double squared = glm::dot(u, u);
    return squared > 0 ? v - glm::dot(v, u) / squared * u : v;
}

}  // namespace

std::optional<dvec3> normalOf(const std::vector<Place>& places) {
    const dvec3 across = acrossOf(places);
    if (across == dvec3(0))
        return std::nullopt;
    const dvec3 size = glm::abs(across);
    const int largest = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
    return glm::normalize(across[largest] < 0 ? -across : across);
}

measure::PlaneEllipse ellipseOf(const std::vector<Place>& places) {
    const dvec3 u = places[1].mm - places[0].mm, v = partAcross(places[2].mm - places[0].mm, u);
    const bool turned = glm::dot(glm::cross(u, v), normalOf(places).value_or(dvec3(0))) < 0;
    return {places[0].mm, u, turned ? -v : v};
}

void settle(Measurement& measurement) {
    std::vector<Place>& places = measurement.places;
    if (measurement.kind == MeasureKind::ellipse)
        places[2].mm = places[0].mm + partAcross(places[2].mm - places[0].mm, places[1].mm - places[0].mm);
}

void movePlace(Measurement& measurement, std::size_t index, const Place& to) {
    std::vector<Place>& places = measurement.places;
    const std::vector<Place> before = places;
    places[index] = to;
    if (hasMiddle(measurement.kind) && index == 0)
        for (std::size_t n = 1; n < places.size(); ++n)
            places[n].mm += to.mm - before[0].mm;
    const dvec3 u = places[1 % places.size()].mm - places[0].mm, across = acrossOf(before);
    if (measurement.kind == MeasureKind::ellipse && index == 1 && across != dvec3(0) && u != dvec3(0))
        places[2].mm = places[0].mm + glm::distance(before[2].mm, before[0].mm) * glm::normalize(glm::cross(across, u));
    settle(measurement);
}

}  // namespace pdr::app
