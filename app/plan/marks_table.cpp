#include "app/plan/marks_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "app/plan/hole_mark.h"
#include "app/plan/measured_region.h"
#include "app/plan/plan_fields.h"

namespace pdr::app {
namespace {

constexpr int kDecimals = 4;  // of lengths, angles and HU

template <class T, std::size_t N>
std::string_view wordFor(T value, const Words<T, N>& words) {
    return std::ranges::find(words, value, &std::pair<std::string_view, T>::second)->first;
}

bool readsVoxels(MeasureKind kind) {
    return kind == MeasureKind::point || kind == MeasureKind::ball || kind == MeasureKind::ellipse;
}

/// Returns the value if it is the same however the grid lies. The step of the grid along a line tells only whether two
/// edges are told apart, so that two values with one bound are one value. Rows and columns are at right angles, and a
/// tilted gantry may bring the third axis near either of them: the step is between 0 and the root of both squares.
Result<Measured> valueWithoutScan(const Measurement& measurement, dvec3 spacingMm) {
    const Error unknown{phrase("not known without the scan"), "", "", ErrorKind::refused};
    if (readsVoxels(measurement.kind))
        return unknown;
    if (measurement.kind == MeasureKind::polygon)
        return areaOfPolygon(measurement.places);
    const auto valueOn = [&](double stepMm) {
        return measured(measurement, Volume(VolumeGeometry::aligned(ivec3(1), dvec3(stepMm), dvec3(0)), Voxels(1, 0)));
    };
    const double largest = std::hypot(std::max(spacingMm.x, spacingMm.y), spacingMm.z);
    auto finest = valueOn(kLowestSpacingMm);
    const auto coarsest = valueOn(largest);
    if (finest && coarsest && finest->bound != coarsest->bound)
        return unknown;
    return finest;
}

using ValueOf = std::function<Result<Measured>(const Measurement&)>;

std::vector<MarkRow> tableOf(const Plan& plan, const ValueOf& value) {
    std::vector<MarkRow> rows;
    for (const Measurement& one : plan.measurements) {
        const auto number = 1 + std::ranges::count(rows, one.kind, &MarkRow::kind);
        const std::string title = one.name.empty() ? std::string(ordinalName(one.kind, int(number))) : one.name;
        rows.push_back({one.id, one.kind, one.name, title, value(one), one.places});
    }
    return rows;
}

}  // namespace

std::vector<MarkRow> marksTable(const Plan& plan, const Volume& volume) {
    return tableOf(plan, [&](const Measurement& one) { return measured(one, volume); });
}

std::vector<MarkRow> marksTableWithoutScan(const SavedPlan& saved) {
    return tableOf(saved.plan, [&](const Measurement& one) {
        Result<Measured> value = valueWithoutScan(one, saved.scan.spacingMm);
        return value ? markedForHoles(*std::move(value), one, saved.scan.holes) : value;
    });
}

std::string readable(const MarkRow& row) {
    return row.value ? row.value->text : row.value.error().what;
}

std::string_view kindWord(MeasureKind kind) {
    return wordFor(kind, kMeasureWords);
}

std::string_view foundWord(measure::Found found) {
    return wordFor(found, kFoundWords);
}

std::string_view boundWord(measure::Bound bound) {
    constexpr std::array<std::string_view, 3> kWords{"", "atMost", "atLeast"};
    return kWords[std::size_t(bound)];
}

std::string unitWord(const Measured& measured) {
    constexpr std::array<std::string_view, 4> kWords{"mm", "deg", "mm2", "HU"};
    if (measured.unit == measure::Unit::hu && !isInHu(measured))
        return measured.valueUnit.name;
    return std::string(kWords[std::size_t(measured.unit)]);
}

bool isInHu(const Measured& measured) {
    return measured.valueUnit.isHu;
}

int valueDecimals(const Measured& measured) {
    return measured.unit == measure::Unit::hu ? figureDecimals(measured) : kDecimals;
}

int figureDecimals(const Measured& measured) {
    return kDecimals + measured.valueUnit.decimals();
}

}  // namespace pdr::app
