#include "app/plan/measured.h"

#include <utility>

#include "app/plan/hole_mark.h"
#include "app/plan/measured_region.h"
#include "render/measure/angle.h"
#include "render/measure/distance.h"
#include "render/measure/profile.h"

namespace pdr::app {
namespace {

using measure::Place;
using measure::Stated;
using measure::Unit;

Measured measuredOf(const Stated& stated, Unit unit) {
    Measured measured{.unit = unit, .value = stated.value, .plusMinus = plusMinusOf(stated), .bound = stated.bound};
    measured.text = measure::valueText(stated, unit);
    measured.details = measure::causesText(stated);
    return measured;
}

Result<Measured> angleOf(const Result<Stated>& angle) {
    if (!angle)
        return angle.error();
    return measuredOf(*angle, Unit::degrees);
}

/// Returns the angles of two lines as seen along the patient's axes, from where both can be seen: "Seen from the front
/// 61 ± 2°."
Text seenAlongAxes(const measure::DrawnLine& first, const measure::DrawnLine& second) {
    const auto along = [&](dvec3 normal) -> std::optional<Text> {
        const Result<Stated> angle = measure::angleInPlane(first, second, normal);
        return angle ? std::optional(measure::valueText(*angle, Unit::degrees)) : std::nullopt;
    };
    Text all;
    if (const auto front = along({0, 1, 0}))
        all = joined(all, phrase("Seen from the front %1.", *front));
    if (const auto left = along({1, 0, 0}))
        all = joined(all, phrase("Seen from the left %1.", *left));
    if (const auto feet = along({0, 0, 1}))
        all = joined(all, phrase("Seen from the feet %1.", *feet));
    return all;
}

Result<Measured> linesOf(const std::vector<Place>& places) {
    const measure::DrawnLine first{places[0], places[1]}, second{places[2], places[3]};
    const Result<Stated> angle = measure::angleOfLines(first, second);
    if (!angle)
        return angle.error();
    Measured measured = measuredOf(*angle, Unit::degrees);
    const Text other = measure::valueText(measure::supplement(*angle), Unit::degrees);
    measured.details =
        joined(joined(phrase("On their other side %1.", other), seenAlongAxes(first, second)), measured.details);
    return measured;
}

Result<Measured> pointOf(const Place& place, const Volume& volume) {
    const measure::ProfileSample sample = measure::profile(volume, place.mm, place.mm).front();
    if (!sample.measured)
        return Error{phrase("the scanner measured nothing here"), "", phrase("Move it into the scan."),
                     ErrorKind::refused};
    const ValueUnit unit = unitOf(volume);
    const Text digits = fixedNumber(unit.roundedValueOf(sample.hu), unit.decimals());
    return Measured{.unit = Unit::hu,
                    .valueUnit = unit,
                    .value = unit.valueOf(sample.hu),
                    .text = phrase("%1 %2", digits, unitText(unit)),
                    .details = phrase(unit.isHu ? "The HU that slices show at this place. One place has no ±: a ball "
                                                  "has a mean with a ±."
                                                : "The value that slices show at this place. One place has no ±: a "
                                                  "ball has a mean with a ±.")};
}

Result<Measured> valueOf(const Measurement& measurement, const Volume& volume) {
    const std::vector<Place>& places = measurement.places;
    switch (measurement.kind) {
        case MeasureKind::distance:
            return measuredOf(measure::distance(volume.geometry(), places[0], places[1]), Unit::mm);
        case MeasureKind::angle:
            return angleOf(measure::angle(places[0], places[1], places[2]));
        case MeasureKind::lines:
            return linesOf(places);
        case MeasureKind::point:
            return pointOf(places[0], volume);
        case MeasureKind::ball:
            return measuredBall(places, volume);
        case MeasureKind::ellipse:
            return measuredEllipse(places, volume);
        case MeasureKind::polygon:
            break;
    }
    return measuredPolygon(places, volume);
}

}  // namespace

std::optional<double> plusMinusOf(const Stated& stated) {
    if (stated.bound != measure::Bound::none || stated.plusMinus() == 0)
        return std::nullopt;
    return stated.plusMinus();
}

Text ordinalName(MeasureKind kind, int number) {
    switch (kind) {
        case MeasureKind::distance:
            return phrase("Distance %1", number);
        case MeasureKind::angle:
            return phrase("Angle %1", number);
        case MeasureKind::lines:
            return phrase("Two lines %1", number);
        case MeasureKind::point:
            return phrase("Place %1", number);
        case MeasureKind::ball:
            return phrase("Ball %1", number);
        case MeasureKind::ellipse:
            return phrase("Ellipse %1", number);
        case MeasureKind::polygon:
            break;
    }
    return phrase("Polygon %1", number);
}

Result<Measured> measured(const Measurement& measurement, const Volume& volume) {
    Result<Measured> value = valueOf(measurement, volume);
    return value ? markedForHoles(*std::move(value), measurement, holesOf(volume)) : value;
}

}  // namespace pdr::app
