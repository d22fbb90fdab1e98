#pragma once
/// Kernels that take samples, in any order and by as many threads as there are, and then add them to their pixels in
/// order, so that the sums are those of the CPU.

#include "render/device/gpu/atomic.h"
#include "render/film/moments.h"
#include "render/kernel/baseline/kroes_path.h"
#include "render/kernel/pixel.h"
#include "render/kernel/quadrature/projection.h"
#include "render/kernel/transport/integrator.h"

namespace pdr {

/// Health that threads count together. Sample numbers must be below 2^32.
struct GpuHealth {
    struct Count {
        std::uint64_t count = 0;
        std::uint64_t first = ~0ull;  ///< sample << 32 | pixel
    };
    Count faults[kFaults];

    PDR_HD void note(Fault fault, std::uint64_t sample, std::uint32_t pixel) {
        Count& one = faults[std::uint32_t(fault)];
        atomicAddTo(one.count, 1);
        atomicLower(one.first, sample << 32 | pixel);
    }
};

struct ForgetFaultsKernel {
    GpuHealth* health;
    PDR_HD void operator()(std::int64_t) const { *health = {}; }
};

inline Health toHealth(const GpuHealth& counted) {
    Health health;
    for (int i = 0; i < kFaults; ++i)
        health.faults[i] = {counted.faults[i].count, counted.faults[i].first >> 32,
                            std::uint32_t(counted.faults[i].first)};
    return health;
}

inline GpuHealth toGpuHealth(const Health& health) {
    GpuHealth counted;
    for (int i = 0; i < kFaults; ++i)
        if (const FaultCount& fault = health.faults[i]; fault.count > 0)
            counted.faults[i] = {fault.count, fault.sample << 32 | fault.pixel};
    return counted;
}

/// The samples of a launch, numbered so that 32 threads in lockstep take the same sample of 8 x 4 neighbours, and the
/// next 32 their next sample, before other pixels follow: they read the same voxels.
struct SampleGrid {
    Tile tile;
    SampleRange samples;

    static constexpr int kWide = 8, kHigh = 4;

    PDR_HD int blocksPerRow() const { return (tile.width + kWide - 1) / kWide; }
    /// Returns how many numbers there are. Some belong to no pixel of the tile: its edges cut blocks.
    PDR_HD std::int64_t count() const {
        const int rows = (tile.height + kHigh - 1) / kHigh;
        return std::int64_t(blocksPerRow()) * rows * samples.count * (kWide * kHigh);
    }
    /// Converts a number to its pixel, from the tile's corner, and sample, from the range's first; false if there is
    /// none.
    PDR_HD bool at(std::int64_t index, ivec2& place, std::uint32_t& sample) const {
        const int inBlock = int(index % (kWide * kHigh));
        const std::int64_t turn = index / (kWide * kHigh);
        sample = std::uint32_t(turn % samples.count);
        const int block = int(turn / samples.count);
        place = {block % blocksPerRow() * kWide + inBlock % kWide, block / blocksPerRow() * kHigh + inBlock / kWide};
        return place.x < tile.width && place.y < tile.height;
    }
    PDR_HD std::int64_t pixels() const { return std::int64_t(tile.width) * tile.height; }
};

struct SampleAddress {
    ivec2 pixel;
    std::uint64_t sample;
};

/// A sample of a launch.
struct TracedSample {
    SampleAddress from;
    std::int64_t place;  ///< place in TraceTarget::radiance
};

/// The buffers for the samples of a launch before they are added: [sample][pixel of the tile].
struct TraceTarget {
    SampleGrid grid;
    vec3* radiance;  ///< linear Rec. 709
    GpuHealth* health;
    std::uint32_t* seen;  ///< flags kSeen... of each pixel of the tile
    int stride;           ///< pixels from one row of `seen` to the next

    /// Returns the position of a pixel of the tile, counted row by row, in `seen` and in a film.
    PDR_HD std::int64_t inFilm(std::int64_t pixel) const {
        return pixel / grid.tile.width * stride + pixel % grid.tile.width;
    }

    /// Finds the sample of that number; false if there is none.
    PDR_HD bool at(std::int64_t index, TracedSample& sample) const {
        ivec2 place;
        std::uint32_t turn;
        if (!grid.at(index, place, turn))
            return false;
        sample.place = turn * grid.pixels() + std::int64_t(place.y) * grid.tile.width + place.x;
        sample.from = {ivec2(grid.tile.x, grid.tile.y) + place, grid.samples.first + turn};
        return true;
    }

    /// Stores what a sample has found. Found: PathSample or Projected.
    template <class Found>
    PDR_HD void keep(const FlatScene& scene, const TracedSample& sample, const Found& found) const {
        const ivec2 pixel = sample.from.pixel;
        noteFaults(found, [&](Fault fault) {
            health->note(fault, sample.from.sample, std::uint32_t(pixel.y * scene.camera.film.x + pixel.x));
        });
        radiance[sample.place] = found.radiance;
        const std::uint32_t chance = seenAtFirst(scene, depthBounds(scene, pixel));
        const ivec2 place = pixel - ivec2(grid.tile.x, grid.tile.y);
        if (const std::uint32_t all = chance | (found.tissue ? seenOfTissue(sample.from.sample) : 0); all != 0)
            atomicMark(seen[std::int64_t(place.y) * stride + place.x], all);
    }
};

/// Takes the samples of a launch, by their numbers, each in one step. The type Take defines how:
///   Take::sample(scene, SampleAddress)     returns the PathSample or Projected that the sample finds
template <class Take>
struct TraceKernel {
    FlatScene scene;
    TraceTarget target;
    std::int64_t first;  ///< number of the first of these samples in the target

    struct Walk {
        TracedSample sample;
    };

    PDR_HD bool start(std::int64_t i, Walk& walk) const { return target.at(first + i, walk.sample); }
    PDR_HD bool step(Walk& walk) const {
        target.keep(scene, walk.sample, Take::sample(scene, walk.sample.from));
        return false;
    }
};

/// Takes a sample as Exposure Render does.
struct MarchSampler {
    PDR_HD static PathSample sample(const FlatScene& scene, const SampleAddress& from) {
        const vec2 depths = depthBounds(scene, from.pixel);
        if (isBackgroundOnly(scene, depths))
            return {.radiance = plainBackground(scene)};
        return kroesSample(scene, from.pixel, from.sample, depths);
    }
};

/// Takes a sample of a projection: a sum along the ray.
template <FlatModel Model, Tissue Kind>
struct ProjectionSampler {
    PDR_HD static Projected sample(const FlatScene& scene, const SampleAddress& from) {
        const vec2 depths = depthBounds(scene, from.pixel);
        if (isBackgroundOnly(scene, depths))
            return projectedMiss<Model>(scene, backdrop<Model>(scene, PathSegment{}));
        const PathSegment segment = startPath(scene, from.pixel, from.sample, depths).segment;
        return projectAlong<Model, Kind>(scene, segment.ray, backdrop<Model>(scene, segment));
    }
};

/// Adds the samples of each pixel of the tile in order.
struct AccumulateKernel {
    TraceTarget from;
    int filmWidth;
    PixelSums* sums;   ///< sums of the tile, from.stride pixels to the next row
    Moments* moments;  ///< moments in the same layout, to which full blocks are moved; null: blocks stay in `sums`

    PDR_HD void operator()(std::int64_t index) const {
        const Tile& tile = from.grid.tile;
        const ivec2 pixel(tile.x + int(index % tile.width), tile.y + int(index / tile.width));
        const std::int64_t place = from.inFilm(index);
        PixelSums pixelSums = sums[place];
        pixelSums.seen |= from.seen[place];
        for (std::uint32_t i = 0; i < from.grid.samples.count; ++i) {
            const vec3 radiance = from.radiance[i * from.grid.pixels() + index];
            const std::uint64_t sample = from.grid.samples.first + i;
            if (!addSample(pixelSums, radiance, sample))
                from.health->note(faultOf(radiance), sample, std::uint32_t(pixel.y * filmWidth + pixel.x));
            if (moments != nullptr && (sample + 1) % kSamplesPerBlock == 0) {
                moments[place] = merged(moments[place], pixelSums);
                pixelSums = nextBlock(pixelSums);
            }
        }
        sums[place] = pixelSums;
    }
};

}  // namespace pdr
