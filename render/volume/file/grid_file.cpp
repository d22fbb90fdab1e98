#include "render/volume/file/grid_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/volume/file/grid_header.h"
#include "render/volume/file/scan_endings.h"

namespace pdr {
namespace {

/// zlib packs no stream to less than this part of it.
constexpr std::uint64_t kMostPacked = 1032;

/// Returns the length of the file that holds the samples [bytes]. `header`: the file that names it.
Result<std::uint64_t> lengthOf(const GridFile& grid, const NamedBytes& header) {
    const Result<NamedBytes> data =
        grid.dataFile == header.name ? Result<NamedBytes>(header) : grid.open(grid.dataFile);
    std::error_code failure;
    Text why;
    if (!data)
        why = data.error().what;
    else if (data->memory)
        return data->memory->size();
    else if (const std::uint64_t bytes = std::filesystem::file_size(grid.dataFile, failure); !failure)
        return bytes;
    else
        why = failure.message();
    return Error{phrase("the file of its voxels cannot be read (%1)", why), grid.dataFile.string(),
                 phrase("Put both files into one folder."), ErrorKind::refused};
}

/// Refuses samples that the file cannot hold, before memory is taken for them.
Result<void> checkLength(const GridFile& grid, const NamedBytes& header) {
    const Result<std::uint64_t> length = lengthOf(grid, header);
    if (!length)
        return length.error();
    const std::uint64_t found = *length;
    const std::uint64_t needed = grid.geometry.voxelCount() * bytesOf(grid.type) + grid.skip;
    const std::uint64_t held = found > grid.start ? found - grid.start : 0;
    if (needed <= (grid.isPacked ? held * kMostPacked : held))
        return {};
    return Error{phrase("it is too short for its %1 x %2 x %3 voxels", grid.geometry.size.x, grid.geometry.size.y,
                        grid.geometry.size.z),
                 grid.dataFile.string(), phrase("Copy the file again."), ErrorKind::refused};
}

Result<void> checkGrid(const GridFile& grid, const NamedBytes& header) {
    constexpr int kMost = 65535;
    const ivec3 size = grid.geometry.size;
    if (!(size.x >= 1 && size.y >= 1 && size.z >= 1 && size.x <= kMost && size.y <= kMost && size.z <= kMost))
        return refusedHeader(grid.file, phrase("its grid has %1 x %2 x %3 voxels", size.x, size.y, size.z));
    const dmat4& map = grid.geometry.patientFromIndex;
    bool isFinite = std::isfinite(grid.slope) && std::isfinite(grid.intercept) && grid.slope != 0;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row)
            isFinite = isFinite && std::isfinite(map[column][row]);
    if (!isFinite)
        return refusedHeader(grid.file, phrase("a number in its header is not finite"));
    if (auto ok = checkSpacing(grid.geometry.spacingMm()); !ok)
        return refusedHeader(grid.file, ok.error().what);
    return checkLength(grid, header);
}

}  // namespace

bool isGridFile(const std::filesystem::path& file) {
    const std::string ending = scanEnding(file);
    return !ending.empty() && ending != ".zip";
}

Result<GridFile> readGridFile(const std::filesystem::path& file, const OpenBytes& open) {
    const Result<NamedBytes> bytes = open(file);
    if (!bytes)
        return bytes.error();
    const std::string format = scanEnding(file);
    Result<GridFile> grid = format == ".nii" || format == ".nii.gz"  ? readNifti(*bytes)
                            : format == ".nrrd" || format == ".nhdr" ? readNrrd(*bytes)
                                                                     : readMetaImage(*bytes);
    if (!grid)
        return grid;
    grid->open = open;
    if (auto ok = checkGrid(*grid, *bytes); !ok)
        return ok.error();
    return grid;
}

GridSamples::GridSamples(const GridFile& file)
    : type_(file.type),
      isBigEndian_(file.isBigEndian),
      source_(file.open(file.dataFile)),
      bytes_(source_ ? *source_ : NamedBytes{file.dataFile}, file.start, file.isPacked),
      placed_(source_ ? bytes_.skip(file.skip) : source_.error()),
      left_(file.geometry.voxelCount()) {}

Result<void> GridSamples::read(std::span<double> samples) {
    if (!placed_)
        return placed_;
    left_ -= samples.size();
    const std::size_t each = bytesOf(type_);
    std::array<std::uint8_t, 64 << 10> bytes;
    while (!samples.empty()) {
        const std::size_t count = std::min(samples.size(), bytes.size() / each);
        const std::span<std::uint8_t> piece = std::span(bytes).first(count * each);
        if (Result<void> ok = bytes_.read(piece); !ok)
            return ok;
        decodeSamples(type_, isBigEndian_, piece, samples.first(count));
        samples = samples.subspan(count);
    }
    return left_ == 0 ? bytes_.checkEnd() : Result<void>();
}

}  // namespace pdr
