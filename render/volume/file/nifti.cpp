/// NIfTI-1 and NIfTI-2 (nifti1.h and nifti2.h of the NIfTI Data Format Working Group): a header of 348 or 540 bytes in
/// either byte order, and the samples behind it, together packed by gzip or not. Places are RAS: +x right, +y anterior.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "render/base/file_ending.h"
#include "render/volume/file/grid_header.h"

namespace pdr {
namespace {

constexpr double kAgreeMm = 0.1;  ///< how far sform and qform may lie apart

/// The fields at their offsets in both versions.
struct Layout {
    std::size_t bytes, magic, dim, datatype, pixdim, offset, slope, qformCode, quatern, sform, units;
    bool isWide;  ///< version 2: eight bytes a number instead of two and four
};
constexpr Layout kFirst{348, 344, 40, 70, 76, 108, 112, 252, 256, 280, 123, false};
constexpr Layout kSecond{540, 4, 16, 12, 104, 168, 176, 344, 352, 400, 500, true};

class Fields {
  public:
    Fields(std::span<const std::uint8_t> bytes, const Layout& layout, bool isBigEndian)
        : bytes_(bytes), layout_(layout), isBigEndian_(isBigEndian) {}

    double whole(std::size_t at, int index = 0) const {
        return one(at, layout_.isWide ? SampleType::int64 : SampleType::int16, index);
    }
    double real(std::size_t at, int index = 0) const {
        return one(at, layout_.isWide ? SampleType::float64 : SampleType::float32, index);
    }
    double one(std::size_t at, SampleType type, int index = 0) const {
        double value = 0;
        const std::size_t size = bytesOf(type);
        decodeSamples(type, isBigEndian_, bytes_.subspan(at + std::size_t(index) * size, size), {&value, 1});
        return value;
    }
    double code(int index) const {
        const std::size_t at = layout_.qformCode;
        return one(at, layout_.isWide ? SampleType::int32 : SampleType::int16, index);
    }
    const Layout& layout() const { return layout_; }

  private:
    std::span<const std::uint8_t> bytes_;
    const Layout& layout_;
    bool isBigEndian_;
};

std::optional<SampleType> sampleTypeOf(int datatype) {
    constexpr std::array<std::pair<int, SampleType>, 10> kTypes{{{2, SampleType::uint8},
                                                                 {4, SampleType::int16},
                                                                 {8, SampleType::int32},
                                                                 {16, SampleType::float32},
                                                                 {64, SampleType::float64},
                                                                 {256, SampleType::int8},
                                                                 {512, SampleType::uint16},
                                                                 {768, SampleType::uint32},
                                                                 {1024, SampleType::int64},
                                                                 {1280, SampleType::uint64}}};
    const auto found = std::ranges::find(kTypes, datatype, &std::pair<int, SampleType>::first);
    return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

/// Returns the place by the qform in RAS, in the file's units.
dmat4 qformOf(const Fields& fields) {
    const std::size_t at = fields.layout().quatern, pixdim = fields.layout().pixdim;
    const double b = fields.real(at, 0), c = fields.real(at, 1), d = fields.real(at, 2);
    const double a = std::sqrt(std::max(0.0, 1 - b * b - c * c - d * d));
    const double mirrored = fields.real(pixdim, 0) < 0 ? -1 : 1;
    dmat4 map(1.0);
    map[0] = dvec4(a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c), 0) * fields.real(pixdim, 1);
    map[1] = dvec4(2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b), 0) * fields.real(pixdim, 2);
    map[2] = dvec4(2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - c * c - b * b, 0) *
             fields.real(pixdim, 3) * mirrored;
    map[3] = dvec4(fields.real(at, 3), fields.real(at, 4), fields.real(at, 5), 1);
    return map;
}

dmat4 sformOf(const Fields& fields) {
    dmat4 map(1.0);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column)
            map[column][row] = fields.real(fields.layout().sform, row * 4 + column);
    return map;
}

/// Returns the largest distance of a corner of the grid from its place by the other map.
double apart(const dmat4& a, const dmat4& b, const ivec3& size) {
    double worst = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const dvec3 index = dvec3(corner & 1, corner >> 1 & 1, corner >> 2) * dvec3(size - 1);
        worst = std::max(worst, glm::length(dvec3((a - b) * dvec4(index, 1.0))));
    }
    return worst;
}

/// Turns a map to RAS in the file's units into one to LPS in millimetres.
Result<dmat4> inPatient(dmat4 map, int units) {
    constexpr int kUnknown = 0, kMetre = 1, kMillimetre = 2, kMicrometre = 3;
    if (units != kUnknown && units != kMetre && units != kMillimetre && units != kMicrometre)
        return Error{phrase("it states its lengths in an unknown unit"), "", ""};
    const double mm = units == kMetre ? 1e3 : units == kMicrometre ? 1e-3 : 1;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            map[column][row] = map[column][row] * (row < 2 ? -mm : mm) + 0.0;  // no -0
    return map;
}

Result<dmat4> placeOf(const Fields& fields, const ivec3& size) {
    const int units =
        int(fields.one(fields.layout().units, fields.layout().isWide ? SampleType::int32 : SampleType::uint8)) & 7;
    const bool hasQform = fields.code(0) > 0, hasSform = fields.code(1) > 0;
    if (!hasQform && !hasSform)
        return Error{phrase("it does not say how it lies in the patient"), "", ""};
    Result<dmat4> place = inPatient(hasSform ? sformOf(fields) : qformOf(fields), units);
    if (!place || !hasQform || !hasSform)
        return place;
    const Result<dmat4> other = inPatient(qformOf(fields), units);
    const double off = apart(*place, *other, size);
    if (off <= kAgreeMm)
        return place;
    return Error{
        phrase("it states two places in the patient (sform and qform) that differ by up to %1 mm", numberOf(off, 3)),
        "", ""};
}

Result<GridFile> gridOf(const Fields& fields, GridFile grid) {
    const Layout& layout = fields.layout();
    const double dimensions = fields.whole(layout.dim);
    std::vector<double> size;
    for (int axis = 1; axis <= 7; ++axis) {
        const double count = axis <= dimensions ? fields.whole(layout.dim, axis) : 1;
        if (axis <= 3)
            size.push_back(count);
        else if (count > 1)
            return Error{phrase("it holds several values for each place"), "", ""};
    }
    const auto box = pdr::gridOf(size, {}, {});
    const auto type = sampleTypeOf(int(fields.one(layout.datatype, SampleType::int16)));
    const double offset = fields.one(layout.offset, layout.isWide ? SampleType::int64 : SampleType::float32);
    if (!box || !(dimensions >= 1 && dimensions <= 7) || !(offset >= 0 && offset <= 1e9))
        return Error{phrase("its header is damaged"), "", ""};
    if (!type)
        return Error{phrase("its voxels are of a type that is not read"), "", ""};
    const Result<dmat4> place = placeOf(fields, box->size);
    if (!place)
        return place.error();
    grid.geometry = {box->size, *place};
    grid.type = *type;
    (grid.isPacked ? grid.skip : grid.start) = std::uint64_t(offset);
    const double slope = fields.real(layout.slope);
    if (slope != 0 && std::isfinite(slope)) {  // else nothing is stated
        grid.slope = slope;
        grid.intercept = fields.real(layout.slope, 1);
    }
    return grid;
}

}  // namespace

Result<GridFile> readNifti(const NamedBytes& file) {
    GridFile grid;
    grid.file = grid.dataFile = file.name;
    grid.isPacked = fileEnding(file.name) == ".gz";
    std::array<std::uint8_t, kSecond.bytes> bytes{};
    UnpackedFile source(file, 0, grid.isPacked);
    if (auto ok = source.read(std::span(bytes).first(kFirst.bytes)); !ok)
        return ok.error();
    const auto sizeIs = [&](std::size_t stated, bool isBigEndian) {
        double size = 0;
        decodeSamples(SampleType::int32, isBigEndian, std::span(bytes).first(4), {&size, 1});
        return size == double(stated);
    };
    for (const Layout* layout : {&kFirst, &kSecond})
        for (const bool isBigEndian : {false, true}) {
            if (!sizeIs(layout->bytes, isBigEndian))
                continue;
            const char* magic = layout->isWide ? "n+2" : "n+1";
            if (std::memcmp(bytes.data() + layout->magic, magic, 4) != 0)
                break;
            if (auto ok = source.read(std::span(bytes).subspan(kFirst.bytes, layout->bytes - kFirst.bytes)); !ok)
                return ok.error();
            grid.isBigEndian = isBigEndian;
            const Result<GridFile> read = gridOf(Fields(bytes, *layout, isBigEndian), grid);
            return read ? read : refusedHeader(file.name, read.error().what);
        }
    return refusedHeader(file.name, phrase("this is no NIfTI file with header and voxels in one"));
}

}  // namespace pdr
