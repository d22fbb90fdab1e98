#pragma once
/// Kernels from the film to what is copied to the host: display levels, and the sums for its status.

#include "render/device/gpu/trace_kernels.h"
#include "render/film/status_sums.h"

namespace pdr {

/// Pixels of one partial sum, and partial sums of one total; one thread adds them up.
inline constexpr int kPixelsPerSum = 16, kSumsPerTotal = 256;

/// Number of histograms of the errors side by side, so that few threads wait for the same number.
inline constexpr int kCountPlaces = 16;

/// An image on its way, in one piece of memory: the head with the histogram of the pixels' errors, totals of the
/// status, RGBA8 pixels, and the tail.
struct FrameLayout {
    std::int64_t pixels;

    struct Head {
        std::uint64_t id;  ///< number of the image; equal to the tail's, or the image is torn
        GpuHealth health;
        ErrorCounts errors;
    };

    PDR_HD std::int64_t sums() const { return (pixels + kPixelsPerSum - 1) / kPixelsPerSum; }
    PDR_HD std::int64_t totals() const { return (sums() + kSumsPerTotal - 1) / kSumsPerTotal; }
    PDR_HD std::int64_t totalsAt() const { return sizeof(Head); }
    PDR_HD std::int64_t pixelsAt() const { return totalsAt() + totals() * std::int64_t(sizeof(StatusSums)); }
    PDR_HD std::int64_t tailAt() const { return (pixelsAt() + pixels * 4 + 7) / 8 * 8; }
    PDR_HD std::int64_t bytes() const { return tailAt() + std::int64_t(sizeof(std::uint64_t)); }
};

/// Computes for kPixelsPerSum pixels their levels and their part of the status.
struct ResolveKernel {
    FrameLayout layout;
    const PixelSums* block;
    const Moments* moments;
    DisplayTransform transform;  ///< with tables on the device
    std::byte* frame;
    StatusSums* sums;
    ErrorCounts* errors;  ///< kCountPlaces histograms

    PDR_HD void operator()(std::int64_t index) const {
        StatusSums mine;
        ErrorCounts& counts = errors[index % kCountPlaces];
        const std::int64_t begin = index * kPixelsPerSum, end = glm::min(begin + kPixelsPerSum, layout.pixels);
        for (std::int64_t pixel = begin; pixel < end; ++pixel) {
            const Moments known = merged(moments[pixel], block[pixel]);
            const std::uint32_t seen = block[pixel].seen;
            const dvec3 draw = errorDrawOf(known);
            mine.add(known, draw, seen);
            if (knowsItsError(known, seen))
                atomicAddTo(counts.pixels[errorBinOf(levelsOff(transform, known.mean, draw))], 1u);
            auto* rgba = reinterpret_cast<std::uint8_t*>(frame) + layout.pixelsAt() + pixel * 4;
            transform.setLevels(known.mean, rgba);
            rgba[3] = 255;
        }
        sums[index] = mine;
    }
};

/// Adds up each bin of the errors over all histograms, and empties them.
struct CountErrorsKernel {
    ErrorCounts* errors;
    std::byte* frame;

    PDR_HD void operator()(std::int64_t bin) const {
        std::uint32_t all = 0;
        for (int place = 0; place < kCountPlaces; ++place) {
            all += errors[place].pixels[bin];
            errors[place].pixels[bin] = 0;
        }
        reinterpret_cast<FrameLayout::Head*>(frame)->errors.pixels[bin] = all;
    }
};

/// Computes the total of kSumsPerTotal sums; the first thread also writes both ends of the frame.
struct FinalizeKernel {
    FrameLayout layout;
    const StatusSums* sums;
    const GpuHealth* health;
    std::uint64_t id;
    std::byte* frame;

    PDR_HD void operator()(std::int64_t index) const {
        StatusSums total;
        const std::int64_t begin = index * kSumsPerTotal, end = glm::min(begin + kSumsPerTotal, layout.sums());
        for (std::int64_t i = begin; i < end; ++i)
            total.add(sums[i]);
        reinterpret_cast<StatusSums*>(frame + layout.totalsAt())[index] = total;
        if (index != 0)
            return;
        auto* head = reinterpret_cast<FrameLayout::Head*>(frame);
        head->id = id;
        head->health = *health;
        *reinterpret_cast<std::uint64_t*>(frame + layout.tailAt()) = id;
    }
};

}  // namespace pdr
