#include "app/presenters/mark_profile.h"

#include "render/measure/profile.h"

namespace pdr::app {
namespace {

constexpr double kBeyondMm = 5;

/// Returns the value at a place that lies at an edge: there it is halfway between those of its sides.
std::optional<double> halfLevelAt(const Volume& volume, const measure::Place& place) {
    const measure::ProfileSample sample = measure::profile(volume, place.mm, place.mm).front();
    return isAtEdge(place) && sample.measured ? std::optional(unitOf(volume).valueOf(sample.hu)) : std::nullopt;
}

}  // namespace

std::optional<ui::ShownProfile> profileOf(const Measurement& measurement, const Volume& volume) {
    if (measurement.kind != MeasureKind::distance)
        return std::nullopt;
    const std::vector<measure::Place>& ends = measurement.places;
    const double length = glm::distance(ends[0].mm, ends[1].mm);
    if (length == 0)
        return std::nullopt;
    const dvec3 beyond = kBeyondMm / length * (ends[1].mm - ends[0].mm);
    ui::ShownProfile shown{{}, length, {halfLevelAt(volume, ends[0]), halfLevelAt(volume, ends[1])}, unitOf(volume)};
    for (const measure::ProfileSample& sample : measure::profile(volume, ends[0].mm - beyond, ends[1].mm + beyond))
        shown.samples.push_back(
            {sample.mm - kBeyondMm, shown.unit.valueOf(sample.hu), sample.measured, sample.acrossHole});
    return shown;
}

}  // namespace pdr::app
