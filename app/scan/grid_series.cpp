#include "app/scan/grid_series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <utility>

#include "dicom/stack/series_unit.h"
#include "dicom/stack/stack_geometry.h"
#include "render/base/errors.h"
#include "render/base/file_ending.h"
#include "render/base/free_memory.h"

namespace pdr::app {
namespace {

/// Returns one plane for each index k of the grid.
std::vector<dicom::SlicePlane> planesOf(const VolumeGeometry& grid) {
    const dmat4& map = grid.patientFromIndex;
    const dvec3 mm = grid.spacingMm();
    std::vector<dicom::SlicePlane> planes;
    planes.reserve(std::size_t(grid.size.z));
    for (int k = 0; k < grid.size.z; ++k)
        planes.push_back({std::string("#").append(std::to_string(k + 1)), ivec2(grid.size),
                          dvec3(map * dvec4(0, 0, k, 1)), dvec3(map[0]) / mm.x, dvec3(map[1]) / mm.y, dvec2(mm)});
    return planes;
}

/// Calls `use(values)` for all values of `file`, a few thousand at a time. Errors: those of GridSamples; cancelled().
template <class Use>
Result<void> forEachValue(const GridFile& file, const Progress& progress, const char* step, Use use) {
    std::array<double, 8192> piece;
    GridSamples samples(file);
    const std::size_t count = file.geometry.voxelCount();
    for (std::size_t at = 0; at < count; at += piece.size()) {
        const std::span<double> values = std::span(piece).first(std::min(piece.size(), count - at));
        if (Result<void> ok = samples.read(values); !ok)
            return ok;
        for (double& value : values)
            value = value * file.slope + file.intercept;
        use(at, std::span<const double>(values));
        if (!progress(double(at) / double(count), step))
            return cancelled();
    }
    return {};
}

Result<ValueRange> rangeOf(const GridFile& file, const Progress& progress) {
    ValueRange range = ValueRange::none();
    const auto widen = [&](std::size_t, std::span<const double> values) {
        for (const double value : values)
            range.include(value);
    };
    if (auto ok = forEachValue(file, progress, "reading values", widen); !ok)
        return ok.error();
    return range;
}

const char* formatName(const std::filesystem::path& file) {
    const std::string ending = fileEnding(file);
    if (ending == ".mha" || ending == ".mhd")
        return "MetaImage";
    return ending == ".nrrd" || ending == ".nhdr" ? "NRRD" : "NIfTI";
}

/// Judges the grid, and gives the slices their order.
void judgeGrid(dicom::Series& series, const GridFile& grid) {
    const dicom::StackAnalysis analysis = dicom::analyseStack(planesOf(grid.geometry));
    series.verdict = analysis.verdict;
    series.geometry = analysis.geometry;
    for (const int k : analysis.order)
        series.slices.push_back({grid.file, k, {}});
}

/// Judges the values, and gives them their unit.
void judgeValues(dicom::Series& series, const GridFile& grid, const ValueRange& range) {
    if (!range.isFinite()) {
        series.verdict.stack = dicom::Stack::unreadable;
        series.verdict.reason = phrase("its values are no finite numbers");
        return;
    }
    const Text lowest = numberOf(range.lowest), highest = numberOf(range.highest);
    std::vector<dicom::Note>& notes = series.verdict.notes;
    const FittedUnit fitted = gridUnit(grid, range);
    series.unit = fitted.unit;
    if (series.unit.isHu)
        return notes.push_back(
            {"no-unit:" + lowest + ".." + highest,
             phrase("the file does not say that its values are HU; they run from %1 to %2, and are taken as HU", lowest,
                    highest)});
    notes.push_back({std::string(dicom::kNoHu),
                     phrase("the values run from %1 to %2 and are no HU, which begin at -100 or below, and end at 100 "
                            "or above: looks, windows and parts of the body that need HU are not offered",
                            lowest, highest)});
    if (!fitted.isExact)
        notes.push_back(dicom::roundingNote(series.unit));
}

/// The voxels while they are read, and flags of those that are no numbers.
struct Filling {
    explicit Filling(const dicom::Series& series)
        : sliceVoxels(std::size_t(series.geometry.size.x) * std::size_t(series.geometry.size.y)),
          place(series.slices.size()),
          unit(series.unit),
          hu(series.geometry.voxelCount()) {
        for (std::size_t k = 0; k < series.slices.size(); ++k)
            place[std::size_t(series.slices[k].frame)] = k;
    }

    /// Takes values that lie in the file from `first` on.
    void take(std::size_t first, std::span<const double> values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
            const std::size_t inFile = first + i;
            const std::size_t at = place[inFile / sliceVoxels] * sliceVoxels + inFile % sliceVoxels;
            if (std::isnan(values[i])) {
                padding.resize(hu.size(), false);
                padding[at] = true;
                hu[at] = Volume::kAirHu;
            } else {
                const double voxel = std::nearbyint(unit.voxelOf(values[i]));
                isBeyond = isBeyond || !(voxel >= INT16_MIN && voxel <= INT16_MAX);
                hu[at] = isBeyond ? std::int16_t(0) : std::int16_t(voxel);
                lowest = std::min(lowest, hu[at]);
            }
        }
    }

    /// Gives padding the lowest value where air has none that is known.
    void lowerPadding() {
        for (std::size_t i = 0; !unit.isHu && i < padding.size(); ++i)
            if (padding[i])
                hu[i] = lowest;
    }

    std::size_t sliceVoxels;
    std::vector<std::size_t> place;  ///< where slice k of the file lies in the volume
    ValueUnit unit;
    std::int16_t lowest = INT16_MAX;
    Voxels hu;
    std::vector<bool> padding;
    bool isBeyond = false;  ///< whether a value lies outside int16, which the list has excluded
};

std::string codesOf(const dicom::Series& series) {
    std::string joined;
    for (const dicom::Note& note : series.verdict.notes)
        joined += (joined.empty() ? "" : " ") + (note.code == dicom::kNoHu ? unitWord(series.unit) : note.code);
    return joined;
}

/// Returns the voxel of a slice that is read alone where nothing was measured.
std::int16_t nothingMeasured(const ValueUnit& unit) {
    return unit.isHu ? Volume::kAirHu : std::int16_t(std::clamp<double>(unit.voxelOf(0), INT16_MIN, INT16_MAX));
}

bool isSame(const GridFile& a, const GridFile& b) {
    return a.geometry.size == b.geometry.size && a.geometry.patientFromIndex == b.geometry.patientFromIndex &&
           a.type == b.type && a.isBigEndian == b.isBigEndian && a.slope == b.slope && a.intercept == b.intercept;
}

}  // namespace

Result<dicom::Series> gridSeries(const std::filesystem::path& file, const Progress& progress, const OpenBytes& open) {
    Result<GridFile> grid = readGridFile(file, open);
    if (!grid)
        return grid.error();
    dicom::Series series;
    series.series.modality = formatName(file);
    series.series.description = file.filename().string();
    series.series.uid = file.filename().string();
    series.series.number = 1;
    judgeGrid(series, *grid);
    if (series.verdict.loadable()) {
        const Result<ValueRange> range = rangeOf(*grid, progress);
        if (!range)
            return range.error();
        judgeValues(series, *grid, *range);
    }
    series.source = std::make_shared<GridSource>(*std::move(grid));
    return series;
}

Result<Volume> loadGridSeries(const dicom::Series& series, const Progress& progress) {
    if (!series.verdict.loadable())
        return Error{series.verdict.reason, series.series.description, phrase("Choose another series.")};
    const GridFile& listed = static_cast<const GridSource&>(*series.source).grid();
    const Result<GridFile> grid = readGridFile(listed.file, listed.open);
    if (!grid)
        return grid.error();
    if (!isSame(*grid, listed))
        return dicom::changedFile(listed.file);
    const std::uint64_t needed = series.geometry.voxelCount() * sizeof(std::int16_t);
    const Error tooLarge = notEnoughMemoryForVoxels(needed, listed.file.string());
    if (needed > freeBytes())
        return tooLarge;
    try {
        Filling filling(series);
        const auto take = [&](std::size_t first, std::span<const double> values) { filling.take(first, values); };
        if (auto ok = forEachValue(*grid, progress, "reading slices", take); !ok)
            return ok.error();
        if (filling.isBeyond)
            return dicom::changedFile(listed.file);
        filling.lowerPadding();
        return Volume(series.geometry, std::move(filling.hu), std::move(filling.padding), codesOf(series));
    } catch (const std::bad_alloc&) {
        return tooLarge;
    }
}

Result<dicom::DecodedSlice> decodeGridSlice(const dicom::Series& series, const dicom::SliceRef& slice,
                                            const std::stop_token& stop) {
    const GridFile& grid = static_cast<const GridSource&>(*series.source).grid();
    dicom::DecodedSlice decoded;
    decoded.size = ivec2(grid.geometry.size);
    std::vector<double> values(std::size_t(decoded.size.x) * std::size_t(decoded.size.y));
    GridSamples samples(grid);
    for (int k = 0; k <= slice.frame; ++k) {
        if (stop.stop_requested())
            return cancelled();
        if (const Result<void> ok = samples.read(values); !ok)
            return ok.error();
    }
    decoded.hu.reserve(values.size());
    for (const double sample : values) {
        const double voxel = std::nearbyint(series.unit.voxelOf(sample * grid.slope + grid.intercept));
        decoded.hu.push_back(std::isnan(voxel) ? nothingMeasured(series.unit)
                                               : std::int16_t(std::clamp<double>(voxel, INT16_MIN, INT16_MAX)));
    }
    return decoded;
}

}  // namespace pdr::app
