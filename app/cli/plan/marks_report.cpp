#include "app/cli/plan/marks_report.h"

#include <QString>

#include <algorithm>
#include <array>

#include "render/base/version.h"
#include "render/scene/field_writer.h"

namespace pdr::app {
namespace {

using Json = nlohmann::ordered_json;
using Line = std::array<QString, 7>;

/// Returns a name without what moves the cursor or turns the direction of writing.
QString printable(const std::string& name) {
    QString text = QString::fromStdString(name);
    for (QChar& letter : text)
        if (letter.category() == QChar::Other_Control || letter.category() == QChar::Other_Format)
            letter = ' ';
    return text;
}

std::vector<Line> linesOf(const std::vector<MarkRow>& rows) {
    std::vector<Line> lines{{"name", "kind", "value", "x [mm]", "y [mm]", "z [mm]", "found"}};
    for (const MarkRow& row : rows) {
        Line line{printable(row.title), QString::fromUtf8(kindWord(row.kind).data()),
                  QString::fromStdString(readable(row))};
        for (const measure::Place& place : row.places) {
            for (int axis = 0; axis < 3; ++axis)
                line[3 + std::size_t(axis)] = QString::fromStdString(fixedNumber(place.mm[axis], 2));
            line[6] = QString::fromUtf8(foundWord(place.found).data());
            lines.push_back(std::exchange(line, {}));
        }
    }
    return lines;
}

Json number(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json placesOf(const MarkRow& row) {
    Json places = Json::array();
    for (const measure::Place& place : row.places)
        places.push_back({{"mm", {place.mm.x, place.mm.y, place.mm.z}}, {"found", foundWord(place.found)}});
    return places;
}

/// Returns the figures of a region; their names end in "Hu" only where they are.
Json regionOf(const MarkRow& row) {
    if (!row.value || !row.value->region)
        return {};
    const measure::RegionStatistics& region = *row.value->region;
    const std::string unit = isInHu(*row.value) ? "Hu" : "";
    return {{"sd" + unit, region.sdHu},
            {"lowest" + unit, region.lowestHu},
            {"highest" + unit, region.highestHu},
            {"voxels", region.count},
            {"millilitres", region.millilitres},
            {"mean" + unit, region.meanHu},
            {"meanPlusMinus95", number(region.meanPlusMinus)},
            {"median" + unit, region.medianHu}};
}

Json areaOf(const MarkRow& row) {
    if (!row.value || !row.value->area)
        return {};
    const measure::Stated& area = *row.value->area;
    return {{"mm2", area.value}, {"plusMinus95", number(plusMinusOf(area))}, {"bound", boundWord(area.bound)}};
}

Json markOf(const MarkRow& row) {
    const Measured value = row.value ? *row.value : Measured();
    return {{"id", std::to_string(row.id)},
            {"kind", kindWord(row.kind)},
            {"name", row.name},
            {"value", number(row.value ? std::optional(value.value) : std::nullopt)},
            {"plusMinus95", number(value.plusMinus)},
            {"bound", boundWord(value.bound)},
            {"unit", row.value ? unitWord(value) : ""},
            {"text", readable(row)},
            {"details", std::string(value.details)},
            {"region", regionOf(row)},
            {"area", areaOf(row)},
            {"acrossHole", value.acrossHole},
            {"places", placesOf(row)}};
}

}  // namespace

std::string plainText(const std::vector<MarkRow>& rows) {
    if (rows.empty())
        return "This plan has no measurements.\n";
    const std::vector<Line> lines = linesOf(rows);
    std::array<qsizetype, 7> widths{};
    for (const Line& line : lines)
        for (std::size_t n = 0; n < line.size(); ++n)
            widths[n] = std::max(widths[n], line[n].size());
    QString text;
    for (const Line& line : lines) {
        QString cells;
        for (std::size_t n = 0; n < line.size(); ++n) {
            const bool isNumber = n >= 3 && n < 6;
            cells += (isNumber ? line[n].rightJustified(widths[n]) : line[n].leftJustified(widths[n])) + "  ";
        }
        while (cells.endsWith(' '))
            cells.chop(1);
        text += cells + '\n';
    }
    return text.toStdString() + "Places are the patient's, in LPS: x to the left, y to the back, z to the head.\n";
}

std::string jsonText(const std::vector<MarkRow>& rows, const ScanMark& scan, bool onScan) {
    Json marks = Json::array();
    for (const MarkRow& row : rows)
        marks.push_back(markOf(row));
    return pdr::jsonText("pdrender-marks", {{"program", "PD-Render " PDR_VERSION},
                                            {"scan",
                                             {{"size", {scan.size.x, scan.size.y, scan.size.z}},
                                              {"spacingMm", {scan.spacingMm.x, scan.spacingMm.y, scan.spacingMm.z}},
                                              {"read", onScan}}},
                                            {"coordinates", "LPS, mm"},
                                            {"marks", marks}});
}

}  // namespace pdr::app
