#include "app/plan/marks_slicer.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/plan/slice_region.h"

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
    std::size_t points;    ///< in each markup, two lines being two markups; 0: all
    const char* quantity;  ///< what is measured
};

/// Returns how a kind is shown. Slicer knows no ball: it gets its middle and a place on its surface. Nor does it know
/// ellipses, and its regions of interest are boxes: an ellipse is a closed curve, which is seen and has an area there.
/// So is a polygon, whose corners Slicer rounds: the schema has no word for straight sides.
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
            return {"Fiducial", 2, "mean HU"};
        case MeasureKind::ellipse:
            return {"ClosedCurve", 0, "mean HU"};
        case MeasureKind::polygon:
            break;
    }
    return {"ClosedCurve", 0, "area"};
}

/// A control point of a markup.
struct Point {
    dvec3 mm;
    std::string_view found;  ///< how its place was found
};

/// Returns places around an ellipse, from the end of its first half axis on: as many that the spline through them is
/// within 0.1 % of it.
std::vector<Point> pointsAround(const MarkRow& row) {
    constexpr int kPoints = 16;
    const measure::PlaneEllipse ellipse = ellipseOf(row.places);
    std::vector<Point> points;
    for (int n = 0; n < kPoints; ++n) {
        const double turn = 2 * std::numbers::pi * n / kPoints;
        points.push_back({ellipse.centre + std::cos(turn) * ellipse.halfU + std::sin(turn) * ellipse.halfV,
                          foundWord(row.places[1].found)});
    }
    return points;
}

std::vector<Point> pointsOf(const MarkRow& row) {
    if (row.kind == MeasureKind::ellipse)
        return pointsAround(row);
    std::vector<Point> points;
    for (const measure::Place& place : row.places)
        points.push_back({place.mm, foundWord(place.found)});
    return points;
}

/// Returns a point as the control point `number`, counted from 1, of its markup. The axes of points are those of
/// Slicer, right to left and back to front, as points that are placed there have them.
Json controlPoint(const Point& point, const std::string& label, std::size_t number) {
    return {{"id", std::to_string(number)},
            {"label", label},
            {"description", point.found},
            {"associatedNodeID", ""},
            {"position", {point.mm.x, point.mm.y, point.mm.z}},
            {"orientation", {-1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 0.0, 0.0, 1.0}},
            {"selected", true},
            {"locked", true},
            {"visibility", true},
            {"positionStatus", "defined"}};
}

/// Returns a stated number, rounded to more decimals than it has reasons for.
Json measurement(const std::string& name, double number, const Measured& value, const std::string& description) {
    const double last = std::pow(10, valueDecimals(value));
    return {{"name", name},
            {"enabled", true},
            {"value", std::round(number * last) / last},
            {"units", unitWord(value)},
            {"description", description}};
}

/// Returns the value and its ± as measurements of names that Slicer does not use, since it would replace them by what
/// it computes from the points. A bound says so in its name, and so does what was measured across a hole.
Json measurements(const MarkRow& row) {
    Json all = Json::array();
    if (!row.value)
        return all;
    const Measured& value = *row.value;
    const std::string bound = value.bound == measure::Bound::atMost    ? ", at most"
                              : value.bound == measure::Bound::atLeast ? ", at least"
                                                                       : "";
    const std::string hole = value.acrossHole ? ", across a hole" : "";
    std::string quantity = markupOf(row.kind).quantity;
    if (const std::size_t hu = quantity.find("HU"); hu != std::string::npos && !isInHu(value))
        quantity.replace(hu, 2, "value");
    const std::string name = "PD-Render " + quantity + bound + hole;
    all.push_back(measurement(name, value.value, value, value.text));
    if (value.plusMinus)
        all.push_back(measurement(name + ", plus or minus", *value.plusMinus, value,
                                  "Half of the 95 % interval. " + value.details));
    return all;
}

/// Returns the markup of `count` of the row's points, from `first` on. What was measured goes with the first markup of
/// a row.
Json markup(const MarkRow& row, const std::vector<Point>& all, std::size_t first, std::size_t count) {
    Json points = Json::array();
    for (std::size_t n = 0; n < count; ++n)
        points.push_back(controlPoint(
            all[first + n], all.size() == 1 ? row.title : row.title + "-" + std::to_string(first + n + 1), n + 1));
    const bool several = count < all.size();
    return {{"type", markupOf(row.kind).type},
            {"name", several ? row.title + " (" + std::to_string(first / count + 1) + ")" : row.title},
            {"coordinateSystem", "LPS"},
            {"coordinateUnits", "mm"},
            {"locked", true},
            {"fixedNumberOfControlPoints", true},
            {"labelFormat", "%N-%d"},
            {"lastUsedControlPointNumber", count},
            {"controlPoints", points},
            {"measurements", first == 0 ? measurements(row) : Json::array()}};
}

}  // namespace

std::string marksForSlicer(const std::vector<MarkRow>& rows) {
    Json markups = Json::array();
    for (const MarkRow& row : rows) {
        const std::vector<Point> points = pointsOf(row);
        const std::size_t each = markupOf(row.kind).points, count = each > 0 ? each : points.size();
        for (std::size_t first = 0; first < points.size(); first += count)
            markups.push_back(markup(row, points, first, count));
    }
    return Json{{"@schema", kSchema}, {"markups", markups}}.dump(2) + '\n';
}

}  // namespace pdr::app
