#include "app/plan/marks_csv.h"

#include <charconv>
#include <cmath>
#include <iterator>

namespace pdr::app {
namespace {

constexpr int kDecimals = 4;  // of lengths

/// Returns a number with so many decimals, whatever the locale.
std::string cell(double number, int decimals = kDecimals) {
    char text[400];  // the largest double has 309 digits
    const double shown = std::abs(number) < std::pow(10, -decimals) / 2 ? 0 : number;  // no "-0.0000"
    return {text, std::to_chars(text, std::end(text), shown, std::chars_format::fixed, decimals).ptr};
}

/// Returns a text with quotes around it where it needs them.
std::string cell(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos)
        return std::string(text);
    std::string quoted = "\"";
    for (const char letter : text)
        quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return quoted + '"';
}

/// Returns a number that may not be known.
std::string cell(const std::optional<double>& number, int decimals = kDecimals) {
    return number ? cell(*number, decimals) : "";
}

/// Returns a text, such as a name that the user typed or "-50 HU", so that no spreadsheet computes it. An apostrophe of
/// its own gets one in front as well, so that whoever removes the first one has the text.
std::string withoutFormula(const std::string& text) {
    constexpr std::string_view kStarts = "=+-@'\t\r\n";
    return text.empty() || kStarts.find(text.front()) == std::string_view::npos ? text : "'" + text;
}

void add(std::string& line, const std::string& cell) {
    (line += ',') += cell;
}

std::string headOf() {
    std::string line =
        "id,kind,name,value,plus_minus_95,bound,unit,text,details,sd_hu,lowest_hu,highest_hu,voxels,volume_ml";
    for (std::size_t n = 1; n <= kMostPlaces; ++n)
        for (const char* column : {"found", "x_mm_lps", "y_mm_lps", "z_mm_lps"})
            add(line, std::string(column) + '_' + std::to_string(n));
    return line +
           ",mean_hu,mean_plus_minus_95,median_hu,area_mm2,area_plus_minus_95,area_bound,corners_mm_lps,across_hole"
           ",sd_value,lowest_value,highest_value,mean_value,mean_value_plus_minus_95,median_value,value_unit";
}

void addValue(std::string& line, const MarkRow& row) {
    const Measured value = row.value ? *row.value : Measured();
    add(line, row.value ? cell(value.value, valueDecimals(value)) : "");
    add(line, cell(value.plusMinus, valueDecimals(value)));
    add(line, cell(boundWord(value.bound)));
    add(line, row.value ? cell(withoutFormula(unitWord(value))) : "");
    add(line, cell(withoutFormula(readable(row))));
    add(line, cell(value.details));
}

void addRegion(std::string& line, const MarkRow& row) {
    if (!row.value || !row.value->region) {
        line += ",,,,,";
        return;
    }
    const measure::RegionStatistics& region = *row.value->region;
    for (const double hu : {region.sdHu, region.lowestHu, region.highestHu})
        add(line, isInHu(*row.value) ? cell(hu) : "");
    add(line, std::to_string(region.count));
    add(line, cell(region.millilitres));
}

/// Adds what came after the places: what else is known of a region, and its area. Columns in HU stay empty of values
/// that are none.
void addMeanAndArea(std::string& line, const MarkRow& row) {
    const Measured value = row.value ? *row.value : Measured();
    const auto region = isInHu(value) ? value.region : std::nullopt;
    add(line, region ? cell(region->meanHu) : "");
    add(line, region ? cell(region->meanPlusMinus) : "");
    add(line, region ? cell(region->medianHu) : "");
    add(line, value.area ? cell(value.area->value) : "");
    add(line, value.area ? cell(plusMinusOf(*value.area)) : "");
    add(line, value.area ? cell(boundWord(value.area->bound)) : "");
}

/// Adds the figures of a region once more, in the unit of the scan's values, whatever it is.
void addFigures(std::string& line, const MarkRow& row) {
    if (!row.value || !row.value->region) {
        line += ",,,,,,,";
        return;
    }
    const measure::RegionStatistics& region = *row.value->region;
    const int decimals = figureDecimals(*row.value);
    for (const double figure : {region.sdHu, region.lowestHu, region.highestHu, region.meanHu})
        add(line, cell(figure, decimals));
    add(line, cell(region.meanPlusMinus, decimals));
    add(line, cell(region.medianHu, decimals));
    add(line, isInHu(*row.value) ? "HU" : cell(withoutFormula(row.value->valueUnit.name)));
}

/// Returns the corners of a polygon, all of them, in one cell: "x y z; x y z; x y z".
std::string cornersOf(const MarkRow& row) {
    std::string corners;
    for (const measure::Place& place : row.places)
        corners += (corners.empty() ? "" : "; ") + cell(place.mm.x) + ' ' + cell(place.mm.y) + ' ' + cell(place.mm.z);
    return corners;
}

std::string lineOf(const MarkRow& row) {
    std::string line = std::to_string(row.id);
    add(line, cell(kindWord(row.kind)));
    add(line, cell(withoutFormula(row.name)));
    addValue(line, row);
    addRegion(line, row);
    for (std::size_t n = 0; n < kMostPlaces; ++n) {
        if (n >= row.places.size()) {
            line += ",,,,";
            continue;
        }
        add(line, cell(foundWord(row.places[n].found)));
        for (int axis = 0; axis < 3; ++axis)
            add(line, cell(row.places[n].mm[axis]));
    }
    addMeanAndArea(line, row);
    add(line, row.kind == MeasureKind::polygon ? cornersOf(row) : "");
    add(line, !row.value ? "" : row.value->acrossHole ? "yes" : "no");
    addFigures(line, row);
    return line;
}

}  // namespace

std::string marksCsv(const std::vector<MarkRow>& rows) {
    std::string text = headOf() + "\r\n";
    for (const MarkRow& row : rows)
        text += lineOf(row) + "\r\n";
    return text;
}

}  // namespace pdr::app
