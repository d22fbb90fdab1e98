#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <optional>
#include <set>

#include "dicom/import.h"
#include "dicom/parallel.h"
#include "dicom/read/open_images.h"
#include "dicom/stack/blend.h"
#include "dicom/stack/series_unit.h"
#include "render/base/errors.h"
#include "render/base/free_memory.h"

namespace pdr::dicom {

namespace {

Error outOfMemory(const Series& series, std::uint64_t needed) {
    const std::uint64_t free = freeBytes();
    return {free != kNoMemoryLimit
                ? phrase("the volume needs %1 of memory, and %2 are free", bytesText(needed), bytesText(free))
                : phrase("the volume needs %1 of memory, which could not be had", bytesText(needed)),
            series.series.description, phrase("Close other programs, or import fewer slices."), ErrorKind::memory};
}

/// Copies flags run by run: padding lies in a ring around the image, and bits that are set together cost little.
void copyRuns(const std::vector<std::uint8_t>& mask, std::vector<bool>::iterator flags) {
    for (auto end = mask.begin(); end != mask.end();) {
        const auto begin = std::find(end, mask.end(), 1);
        end = std::find(begin, mask.end(), 0);
        std::fill(flags + (begin - mask.begin()), flags + (end - mask.begin()), true);
    }
}

/// The voxels while several threads fill them, one slice at a time.
class Filling {
  public:
    Filling(const Series& series, Padding padding)
        : series_(series),
          padding_(series.unit.isHu ? padding : Padding::keep),
          lowersPadding_(padding != padding_),
          images_(*series.source, series.unit),
          read_(std::make_shared<ArrivingVolume>(readGrid(series), series.unit)) {}
    Filling(const Filling&) = delete;
    Filling& operator=(const Filling&) = delete;
    /// Frees the voxels, even if somebody still holds the arriving volume.
    ~Filling() { read_->take(); }

    /// The volume into which slices are read.
    const std::shared_ptr<ArrivingVolume>& arriving() const { return read_; }

    void loadSlice(std::size_t k, const GoOn& goOn) {
        const SliceRef& from = series_.slices[k];
        Result<DecodedSlice> slice = images_.decode(from.file, from.frame, padding_, goOn);
        if (!slice)
            return fail(slice.error());
        if (slice->size != ivec2(series_.geometry.size) || slice->identity != from.identity)
            return fail(changedFile(from.file));
        std::ranges::copy(slice->hu, read_->slice(int(k)).begin());
        if (!include(*slice, k) || !lowersPadding_)
            read_->arrive(int(k));
        clipped_ += slice->clipped;
        lossy_ += slice->hasLost;
        mended_ += slice->isMended;
    }

    bool failed() {
        const std::lock_guard lock(mutex_);
        return error_.has_value();
    }
    const Error& error() const { return *error_; }

    /// Returns what only the pixels show.
    std::vector<Note> notes() const {
        std::vector<Note> notes;
        if (const std::size_t count = clipped_; count > 0)
            notes.push_back({"clipped", phrase(count == 1 ? "1 voxel lies beyond what 16 bits hold and was put at "
                                                            "their end (-32768 or 32767 HU)"
                                                          : "%1 voxels lie beyond what 16 bits hold and were put at "
                                                            "their end (-32768 or 32767 HU)",
                                               count)});
        if (const std::size_t count = lossy_; count > 0)
            notes.push_back({"lossy", phrase(count == 1 ? "1 slice was compressed with loss, which its file does not "
                                                          "say: the values are not those that were measured"
                                                        : "%1 slices were compressed with loss, which their files do "
                                                          "not say: the values are not those that were measured",
                                             count)});
        if (const std::size_t count = mended_; count > 0)
            notes.push_back({"mended", phrase(count == 1 ? "1 slice states a wrong length in its coding; it is "
                                                           "complete, and was read to its end"
                                                         : "%1 slices state a wrong length in their coding; they are "
                                                           "complete, and were read to their end",
                                              count)});
        return notes;
    }

    /// Slices that were blended have other voxels than those that were read, and other ranges.
    Volume finish() {
        Voxels hu = read_->take();
        if (series_.blends.empty() && !(lowersPadding_ && ranges_.padding > 0))
            return Volume(series_.geometry, std::move(hu), std::move(flags_), codes(), ranges_);
        FlaggedVoxels voxels{std::move(hu), std::move(flags_)};
        if (!series_.blends.empty())
            voxels = blended(voxels, sliceVoxels(), series_.blends);
        if (lowersPadding_ && !ranges_.measured.empty())
            for (std::size_t i = 0; i < voxels.padding.size(); ++i)
                if (voxels.padding[i])
                    voxels.hu[i] = ranges_.measured.lowest;
        return Volume(series_.geometry, std::move(voxels.hu), std::move(voxels.padding), codes());
    }

  private:
    /// Returns the grid of the slices that are read; those that are resampled from them have another.
    static VolumeGeometry readGrid(const Series& series) {
        VolumeGeometry grid = series.geometry;
        grid.size.z = int(series.slices.size());
        return grid;
    }

    std::size_t sliceVoxels() const {
        return std::size_t(series_.geometry.size.x) * std::size_t(series_.geometry.size.y);
    }

    /// Takes up the ranges of slice k, and flags its padding. Slices share words of flags, so one is flagged at a time.
    /// Returns whether there is padding.
    bool include(const DecodedSlice& slice, std::size_t k) {
        const std::lock_guard lock(mutex_);
        ranges_.include(slice.ranges);
        if (slice.padding.empty())
            return false;
        flags_.resize(sliceVoxels() * series_.slices.size(), false);
        copyRuns(slice.padding, flags_.begin() + std::ptrdiff_t(k * sliceVoxels()));
        return true;
    }

    /// Returns one word for each kind of note, and the unit of values that are no HU, noted or not.
    std::string codes() const {
        std::set<std::string> all;
        for (const Note& note : series_.verdict.notes)
            all.insert(note.code);
        for (const Note& note : notes())
            all.insert(note.code);
        if (!series_.unit.isHu) {
            all.erase(std::string(kNoHu));
            all.insert(unitWord(series_.unit));
        }
        std::string joined;
        for (const std::string& code : all)
            joined += (joined.empty() ? "" : " ") + code;
        return joined;
    }

    void fail(Error error) {
        const std::lock_guard lock(mutex_);
        if (!error_)
            error_ = std::move(error);
    }

    const Series& series_;
    const Padding padding_;
    const bool lowersPadding_;  ///< whether padding gets the lowest value in the end, since air has none that is known
    OpenImages images_;
    const std::shared_ptr<ArrivingVolume> read_;
    ValueRanges ranges_;                               ///< guarded by mutex_
    std::vector<bool> flags_;                          ///< padding, guarded by mutex_; empty: there is none so far
    std::atomic<std::size_t> clipped_ = 0;             ///< voxels
    std::atomic<std::size_t> lossy_ = 0, mended_ = 0;  ///< slices; see DecodedSlice
    std::mutex mutex_;
    std::optional<Error> error_;
};

/// Returns the slice that is read as number `i` of `count`: the middle one, which is seen first, then its neighbours,
/// outwards to both ends.
std::size_t outwards(std::size_t i, std::size_t count) {
    const std::size_t middle = count / 2;
    return i % 2 == 1 ? middle - (i + 1) / 2 : middle + i / 2;
}

Result<Volume> fill(const Series& series, Padding padding, const Progress& progress, std::vector<Note>* notes,
                    const OnArrival& onArrival) {
    Filling filling(series, padding);
    if (onArrival && series.blends.empty())
        onArrival(filling.arriving());
    const Progress untilFailure = [&](double fraction, std::string_view step) {
        return progress(fraction, step) && !filling.failed();
    };
    const std::size_t count = series.slices.size();
    const auto loadOne = [&](std::size_t i, const GoOn& goOn) { filling.loadSlice(outwards(i, count), goOn); };
    const bool complete = onAllCores(count, loadOne, untilFailure, "reading slices");
    if (filling.failed())
        return filling.error();
    if (!complete)
        return cancelled();
    if (notes) {
        for (Note& note : filling.notes())
            notes->push_back(std::move(note));
    }
    return filling.finish();
}

}  // namespace

Result<Volume> loadSeries(const Series& series, Padding padding, const Progress& progress, std::vector<Note>* notes,
                          const OnArrival& onArrival) {
    const ivec3 size = series.geometry.size;
    if (padding == Padding::maskAsAir && !series.verdict.loadable())
        return Error{series.verdict.reason, series.series.description, phrase("Choose another series.")};
    const std::size_t slices = series.blends.empty() ? series.slices.size() : series.blends.size();
    if (size.x < 1 || size.y < 1 || size.z < 1 || size.z != int(slices))
        return Error{phrase("the slices differ in size: %1", series.verdict.reason), series.series.description, ""};
    // Two bytes per voxel, and a bit for its padding flag. Resampled slices come beside the measured ones.
    const std::uint64_t resampled = series.blends.empty() ? 0 : std::uint64_t(size.x) * size.y * series.slices.size();
    const std::uint64_t needed = (std::uint64_t(series.geometry.voxelCount()) + resampled) * 17 / 8;
    if (needed > freeBytes())
        return outOfMemory(series, needed);
    try {
        return fill(series, padding, progress, notes, onArrival);
    } catch (const std::bad_alloc&) {
        return outOfMemory(series, needed);
    }
}

}  // namespace pdr::dicom
