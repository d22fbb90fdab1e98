#include "app/scan/seen_series.h"

#include <span>
#include <utility>

#include "app/scan/scan_place.h"

namespace pdr::app {

Result<SeenSeries> seenSeries(const dicom::Series& series, const Progress& progress,
                              const dicom::OnArrival& onArrival) {
    SeenSeries seen;
    seen.notes = series.verdict.notes;
    // Decoding takes most of the time.
    auto volume = loadVoxels(series, dicom::Padding::maskAsAir, partOf(progress, 0, 0.7), &seen.notes, onArrival);
    if (!volume)
        return volume.error();
    const auto hidden = std::make_shared<HiddenVoxels>(volume->size().z);
    const auto keep = [&](int slice, std::span<const std::int16_t> scan, std::span<const std::int16_t> left) {
        hidden->keep(slice, scan, left);
    };
    auto bare = segment::hideTableIn(*std::move(volume), keep, partOf(progress, 0.7, 1));
    if (!bare)
        return bare.error();
    seen.volume = std::move(bare->volume);
    seen.table = std::move(bare->table);
    if (seen.table.body)
        seen.hidden = hidden;
    return seen;
}

}  // namespace pdr::app
