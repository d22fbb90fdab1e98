#include "render/smooth/non_local_means.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <new>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "render/base/errors.h"
#include "render/base/free_memory.h"
#include "render/smooth/noise_level.h"
#include "render/smooth/slice_means.h"
#include "render/volume/value_unit.h"

namespace pdr {
namespace {

constexpr double kLeastNoise = 0.5;  ///< what rounding to whole values hides
constexpr const char* kRemark = "CT denoised";

/// Calls body(k) for each slice on all processors; returns false if `progress` has cancelled. `progress` is called by
/// the calling thread alone.
template <class Body>
bool eachSlice(int slices, const Progress& progress, const Body& body) {
    const std::thread::id caller = std::this_thread::get_id();
    std::atomic<int> done = 0;
    tbb::task_group_context context;
    tbb::parallel_for(
        0, slices, 1,
        [&](int k) {
            if (std::this_thread::get_id() == caller && !progress(double(done) / slices, "denoising the scan"))
                context.cancel_group_execution();
            if (context.is_group_execution_cancelled())
                return;
            body(k);
            ++done;
        },
        context);
    return done == slices;
}

void restorePadding(const Volume& volume, std::size_t begin, std::span<std::int16_t> slice) {
    if (volume.paddingCount() > 0)
        for (std::size_t i = 0; i < slice.size(); ++i)
            if (volume.isPadding(begin + i))
                slice[i] = volume.voxels()[begin + i];
}

Error tooLarge(const Volume& volume) {
    return notEnoughMemory(phrase("to denoise the scan: %1", bytesText(volume.voxels().size_bytes())), "",
                           phrase("Show it as it is."));
}

}  // namespace

Result<Volume> nonLocalMeans(const Volume& volume, double noise, const Progress& progress) {
    const ivec2 size(volume.size());
    const std::size_t area = std::size_t(size.x) * std::size_t(size.y);
    Voxels voxels(volume.voxels().size());
    tbb::enumerable_thread_specific<SliceMeans<FloatLanes>> means(size, float(noise));
    const bool whole = eachSlice(volume.size().z, progress, [&](int k) {
        const std::size_t begin = std::size_t(k) * area;
        const std::span<std::int16_t> slice = std::span(voxels).subspan(begin, area);
        means.local().write(volume.voxels().subspan(begin, area), slice);
        restorePadding(volume, begin, slice);
    });
    if (!whole)
        return cancelled();
    return volume.withVoxels(std::move(voxels), volume.hidden()).remarked(kRemark);
}

Result<Volume> ctDenoised(const Volume& volume, const Progress& progress) try {
    if (!unitOf(volume).isHu)
        return Error{phrase("only values in HU can be denoised, and those of this scan are none"), "",
                     phrase("Show it as it is."), ErrorKind::refused};
    if (volume.voxels().size_bytes() > freeBytes())
        return tooLarge(volume);
    return nonLocalMeans(volume, std::max(noiseOf(volume), kLeastNoise), progress);
} catch (const std::bad_alloc&) {
    return tooLarge(volume);
}

bool isCtDenoised(const Volume& volume) {
    return volume.remarks().find(kRemark) != std::string::npos;
}

}  // namespace pdr
