/// MetaImage (itk.org/Wiki/ITK/MetaIO/Documentation): lines "Key = value" up to ElementDataFile, and the samples behind
/// them or in another file. Places are LPS.

#include <algorithm>
#include <array>

#include "render/volume/file/grid_header.h"

namespace pdr {
namespace {

using Values = std::map<std::string, std::string>;

std::optional<SampleType> sampleTypeOf(const std::string& name) {
    static const std::map<std::string, SampleType> kTypes{
        {"MET_CHAR", SampleType::int8},       {"MET_UCHAR", SampleType::uint8},
        {"MET_SHORT", SampleType::int16},     {"MET_USHORT", SampleType::uint16},
        {"MET_INT", SampleType::int32},       {"MET_UINT", SampleType::uint32},
        {"MET_LONG_LONG", SampleType::int64}, {"MET_ULONG_LONG", SampleType::uint64},
        {"MET_FLOAT", SampleType::float32},   {"MET_DOUBLE", SampleType::float64}};
    const auto found = kTypes.find(name);
    return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

/// Returns the value of the first of `names` that is stated; empty if none is.
std::string valueOf(const Values& values, std::initializer_list<const char*> names) {
    for (const char* name : names)
        if (const auto found = values.find(name); found != values.end())
            return found->second;
    return {};
}

bool isTrue(const std::string& value) {
    return value == "True" || value == "true" || value == "1";
}

Result<VolumeGeometry> geometryOf(const Values& values) {
    const std::string channels = valueOf(values, {"ElementNumberOfChannels"});
    if (valueOf(values, {"NDims"}) != "3" || (!channels.empty() && channels != "1"))
        return Error{phrase("it holds several values for each place"), "", ""};
    const auto size = numbersIn(valueOf(values, {"DimSize"}), 3);
    const auto spacing = numbersIn(valueOf(values, {"ElementSpacing"}), 3);
    const auto axes = numbersIn(valueOf(values, {"TransformMatrix", "Orientation", "Rotation"}), 9);
    const auto origin = numbersIn(valueOf(values, {"Offset", "Origin", "Position"}), 3);
    if (!size)
        return Error{phrase("its header is damaged"), "", ""};
    if (!spacing || !axes || !origin)
        return Error{phrase("it does not say how it lies in the patient"), "", ""};
    std::array<dvec3, 3> steps;
    for (std::size_t axis = 0; axis < 3; ++axis)
        steps[axis] = dvec3((*axes)[3 * axis], (*axes)[3 * axis + 1], (*axes)[3 * axis + 2]) * (*spacing)[axis];
    const auto grid = gridOf(*size, steps, {(*origin)[0], (*origin)[1], (*origin)[2]});
    return grid ? Result(*grid) : Error{phrase("its header is damaged"), "", ""};
}

/// Sets where the samples lie and how they are packed.
Result<void> placeSamples(GridFile& grid, const Values& values, std::uint64_t headerEnd) {
    const std::string name = valueOf(values, {"ElementDataFile"}), skip = valueOf(values, {"HeaderSize"});
    const auto skipped = numbersIn(skip.empty() ? "0" : skip, 1);
    const bool isText = valueOf(values, {"BinaryData"}) == "False";
    grid.isPacked = isTrue(valueOf(values, {"CompressedData"}));
    if (isText)
        return Error{phrase("its voxels are written in a coding that is not read (%1)", "text"), "", ""};
    if (!skipped || !(skipped->front() >= 0 && skipped->front() <= 1e9))
        return Error{phrase("it does not say plainly where its voxels begin"), "", ""};
    grid.start = std::uint64_t(skipped->front());
    if (name == "LOCAL" || name == "Local" || name == "local") {
        grid.start += headerEnd;
        return {};
    }
    const auto beside = fileBeside(grid.file, name);
    if (!beside)
        return Error{phrase("its voxels lie in several files, or outside its folder"), "", ""};
    grid.dataFile = *beside;
    return {};
}

Result<GridFile> gridFrom(const HeaderLines& header, GridFile grid) {
    Values values;
    for (const std::string& line : header.lines)
        if (const auto field = splitAt(line, "="))
            values[(*field)[0]] = (*field)[1];
    const Result<VolumeGeometry> geometry = geometryOf(values);
    if (!geometry)
        return geometry.error();
    grid.geometry = *geometry;
    const auto type = sampleTypeOf(valueOf(values, {"ElementType"}));
    if (!type)
        return Error{phrase("its voxels are of a type that is not read"), "", ""};
    grid.type = *type;
    grid.isBigEndian = isTrue(valueOf(values, {"BinaryDataByteOrderMSB", "ElementByteOrderMSB"}));
    const auto slope = numbersIn(valueOf(values, {"ElementToIntensityFunctionSlope"}), 1);
    const auto intercept = numbersIn(valueOf(values, {"ElementToIntensityFunctionOffset"}), 1);
    grid.slope = slope ? slope->front() : 1;
    grid.intercept = intercept ? intercept->front() : 0;
    if (auto ok = placeSamples(grid, values, header.end); !ok)
        return ok.error();
    return grid;
}

}  // namespace

Result<GridFile> readMetaImage(const NamedBytes& file) {
    GridFile grid;
    grid.file = grid.dataFile = file.name;
    const Result<HeaderLines> header =
        readLines(file, [](std::string_view line) { return line.starts_with("ElementDataFile"); });
    if (!header)
        return header.error();
    if (!header->lines.back().starts_with("ElementDataFile"))
        return refusedHeader(file.name, phrase("this is no MetaImage file"));
    const Result<GridFile> read = gridFrom(*header, std::move(grid));
    return read ? read : refusedHeader(file.name, read.error().what);
}

}  // namespace pdr
