#include "app/plan/marks_slicer.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace pdr::app {
namespace {

using Json = nlohmann::ordered_json;

/// The name of the schema, by which Slicer knows the file. It is no address any longer, and stays as it is.
constexpr const char* kSchema =
    "https://raw.githubusercontent.com/slicer/slicer/master/Modules/Loadable/Markups/Resources/Schema/"
    "markups-schema-v1.0.3.json#";

/// How Slicer shows a kind of measurement.
struct Markup {
    const char* type;
    std::size_t points;    ///< in each markup: two lines are two markups
    const char* quantity;  ///< what is measured
};

/// Returns how a kind is shown. Slicer knows no ball: it gets its middle and a place on its surface.
Markup markupOf(MeasureKind kind) {
    switch (kind) {
        case MeasureKind::distance:
            return {"Line", 2, "distance"};
        case MeasureKind::angle:
            return {"Angle", 3, "angle"};
        case MeasureKind::lines:
            return {"Line", 2, "angle of two lines"};
        case MeasureKind::point:
            return {"Fiducial", 1, "HU"};
        case MeasureKind::ball:
            break;
    }
    return {"Fiducial", 2, "mean HU"};
}

/// Returns a place as the control point `number`, counted from 1, of its markup. The axes of points are those of
/// Slicer, right to left and back to front, as points that are placed there have them.
Json controlPoint(const MarkRow& row, std::size_t index, std::size_t number) {
    const measure::Place& place = row.places[index];
    return {{"id", std::to_string(number)},
            {"label", row.places.size() == 1 ? row.title : row.title + "-" + std::to_string(index + 1)},
            {"description", foundWord(place.found)},
            {"associatedNodeID", ""},
            {"position", {place.mm.x, place.mm.y, place.mm.z}},
            {"orientation", {-1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0}},
            {"selected", true},
            {"locked", true},
            {"visibility", true},
            {"positionStatus", "defined"}};
}

/// Returns a stated number, rounded to more decimals than it has reasons for.
Json measurement(const std::string& name, double number, const Measured& value, const std::string& description) {
    return {{"name", name},
            {"enabled", true},
            {"value", std::round(number * 1e4) / 1e4},
            {"units", unitWord(value.unit)},
            {"description", description}};
}

/// Returns the value and its ± as measurements of names that Slicer does not use, since it would replace them by what
/// it computes from the points. A bound says so in its name.
Json measurements(const MarkRow& row) {
    Json all = Json::array();
    if (!row.value)
        return all;
    const Measured& value = *row.value;
    const std::string bound = value.bound == measure::Bound::atMost    ? ", at most"
                              : value.bound == measure::Bound::atLeast ? ", at least"
                                                                       : "";
    const std::string name = std::string("PD-Render ") + markupOf(row.kind).quantity + bound;
    all.push_back(measurement(name, value.value, value, value.text));
    if (value.plusMinus)
        all.push_back(measurement(name + ", plus or minus", *value.plusMinus, value,
                                  "Half of the 95 % interval. " + value.details));
    return all;
}

/// Returns the markup of the places from `first` on. What was measured goes with the first markup of a row.
Json markup(const MarkRow& row, std::size_t first) {
    const Markup shown = markupOf(row.kind);
    Json points = Json::array();
    for (std::size_t n = 0; n < shown.points; ++n)
        points.push_back(controlPoint(row, first + n, n + 1));
    const bool several = shown.points < row.places.size();
    return {{"type", shown.type},
            {"name", several ? row.title + " (" + std::to_string(first / shown.points + 1) + ")" : row.title},
            {"coordinateSystem", "LPS"},
            {"coordinateUnits", "mm"},
            {"locked", true},
            {"fixedNumberOfControlPoints", true},
            {"labelFormat", "%N-%d"},
            {"lastUsedControlPointNumber", shown.points},
            {"controlPoints", points},
            {"measurements", first == 0 ? measurements(row) : Json::array()}};
}

}  // namespace

std::string marksForSlicer(const std::vector<MarkRow>& rows) {
    Json markups = Json::array();
    for (const MarkRow& row : rows)
        for (std::size_t first = 0; first < row.places.size(); first += markupOf(row.kind).points)
            markups.push_back(markup(row, first));
    return Json{{"@schema", kSchema}, {"markups", markups}}.dump(2) + '\n';
}

}  // namespace pdr::app
