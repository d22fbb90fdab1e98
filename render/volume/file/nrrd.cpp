/// NRRD ("Nearly Raw Raster Data", teem.sourceforge.net/nrrd/format.html): lines "field: value" up to an empty one, and
/// the samples behind them or in another file.

#include <algorithm>
#include <array>

#include "render/base/file_ending.h"
#include "render/base/lower_case.h"
#include "render/volume/file/grid_header.h"

namespace pdr {
namespace {

using Values = std::map<std::string, std::string>;

std::optional<SampleType> sampleTypeOf(const std::string& name) {
    struct Names {
        SampleType type;
        std::array<const char*, 6> names;
    };
    static constexpr Names kTypes[] = {
        {SampleType::int8, {"signed char", "int8", "int8_t", "", "", ""}},
        {SampleType::uint8, {"uchar", "unsigned char", "uint8", "uint8_t", "", ""}},
        {SampleType::int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
        {SampleType::uint16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t", ""}},
        {SampleType::int32, {"int", "signed int", "int32", "int32_t", "", ""}},
        {SampleType::uint32, {"uint", "unsigned int", "uint32", "uint32_t", "", ""}},
        {SampleType::int64, {"longlong", "long long", "long long int", "signed long long", "int64", "int64_t"}},
        {SampleType::uint64, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t", ""}},
        {SampleType::float32, {"float", "", "", "", "", ""}},
        {SampleType::float64, {"double", "", "", "", "", ""}}};
    for (const Names& known : kTypes)
        if (!name.empty() && std::ranges::find(known.names, name) != known.names.end())
            return known.type;
    return {};
}

/// Returns the signs that turn the file's space into LPS.
std::optional<dvec3> towardsLps(const std::string& space) {
    if (space == "left-posterior-superior" || space == "lps")
        return dvec3(1, 1, 1);
    if (space == "right-anterior-superior" || space == "ras")
        return dvec3(-1, -1, 1);
    if (space == "left-anterior-superior" || space == "las")
        return dvec3(1, -1, 1);
    return {};
}

/// Returns whether all units that are stated are millimetres.
bool isInMm(std::string units) {
    std::ranges::replace(units, '"', ' ');
    for (std::size_t at = 0; (at = units.find("mm", at)) != std::string::npos;)
        units.replace(at, 2, "  ");
    return trimmed(units).empty();
}

Result<VolumeGeometry> geometryOf(const Values& values) {
    const auto of = [&](const char* name) {
        const auto found = values.find(name);
        return found == values.end() ? std::string() : found->second;
    };
    if (of("dimension") != "3")
        return Error{phrase("it holds several values for each place"), "", ""};
    const auto size = numbersIn(of("sizes"), 3);
    const auto steps = numbersIn(of("space directions"), 9), origin = numbersIn(of("space origin"), 3);
    const auto signs = towardsLps(lowerCase(of("space")));
    if (!size)
        return Error{phrase("its header is damaged"), "", ""};
    if (!steps || !origin || !signs)
        return Error{phrase("it does not say how it lies in the patient"), "", ""};
    if (!isInMm(of("space units")))
        return Error{phrase("it states its lengths in an unknown unit"), "", ""};
    const auto vectorAt = [&](const std::vector<double>& numbers, std::size_t at) {
        return dvec3(numbers[at], numbers[at + 1], numbers[at + 2]) * *signs;
    };
    const auto grid =
        gridOf(*size, {vectorAt(*steps, 0), vectorAt(*steps, 3), vectorAt(*steps, 6)}, vectorAt(*origin, 0));
    return grid ? Result(*grid) : Error{phrase("its header is damaged"), "", ""};
}

/// Sets where the samples lie and how they are packed.
Result<void> placeSamples(GridFile& grid, const Values& values, std::uint64_t headerEnd) {
    const auto of = [&](const char* name) {
        const auto found = values.find(name);
        return found == values.end() ? std::string() : found->second;
    };
    const std::string coding = lowerCase(of("encoding"));
    if (coding != "raw" && coding != "gzip" && coding != "gz")
        return Error{phrase("its voxels are written in a coding that is not read (%1)", coding), "", ""};
    grid.isPacked = coding != "raw";
    grid.start = headerEnd;
    const std::string name = !of("data file").empty() ? of("data file") : of("datafile");
    if (!name.empty()) {
        const auto beside = fileBeside(grid.file, name);
        if (!beside)
            return Error{phrase("its voxels lie in several files, or outside its folder"), "", ""};
        grid.dataFile = *beside;
        grid.start = 0;
    }
    const std::string skip = !of("byte skip").empty() ? of("byte skip") : "0";
    const auto skipped = numbersIn(skip, 1);
    const bool skipsLines = !of("line skip").empty() && of("line skip") != "0";
    if (!skipped || !(skipped->front() >= 0 && skipped->front() <= 1e9) || skipsLines)
        return Error{phrase("it does not say plainly where its voxels begin"), "", ""};
    if (grid.isPacked)
        grid.skip = std::uint64_t(skipped->front());
    else
        grid.start += std::uint64_t(skipped->front());
    return {};
}

Result<GridFile> gridFrom(const HeaderLines& header, GridFile grid) {
    Values values;
    for (const std::string& line : header.lines) {
        if (line.starts_with("#"))
            continue;
        if (const auto pair = splitAt(line, ":="))
            grid.pairs[(*pair)[0]] = (*pair)[1];
        else if (const auto field = splitAt(line, ":"))
            values[lowerCase((*field)[0])] = (*field)[1];
    }
    const Result<VolumeGeometry> geometry = geometryOf(values);
    if (!geometry)
        return geometry.error();
    grid.geometry = *geometry;
    const auto type = sampleTypeOf(lowerCase(values["type"]));
    if (!type)
        return Error{phrase("its voxels are of a type that is not read"), "", ""};
    grid.type = *type;
    const std::string order = lowerCase(values["endian"]);
    if (order != "big" && order != "little" && bytesOf(*type) > 1)
        return Error{phrase("it does not say the order of its bytes"), "", ""};
    grid.isBigEndian = order == "big";
    if (auto ok = placeSamples(grid, values, header.end); !ok)
        return ok.error();
    return grid;
}

}  // namespace

Result<GridFile> readNrrd(const NamedBytes& file) {
    GridFile grid;
    grid.file = grid.dataFile = file.name;
    const Result<HeaderLines> header = readLines(file, [](std::string_view line) { return line.empty(); });
    if (!header)
        return header.error();
    if (!header->lines.front().starts_with("NRRD000"))
        return refusedHeader(file.name, phrase("this is no NRRD file"));
    const Result<GridFile> read = gridFrom(*header, std::move(grid));
    return read ? read : refusedHeader(file.name, read.error().what);
}

}  // namespace pdr
