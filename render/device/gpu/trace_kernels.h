#pragma once
/// Samples: taken in any order by as many threads as there are, then added to their pixels in order, so that the sums
/// are those of the CPU.

#include "render/device/gpu/atomic.h"
#include "render/film/moments.h"
#include "render/kernel/baseline/kroes_path.h"
#include "render/kernel/pixel.h"
#include "render/kernel/quadrature/projection.h"
#include "render/kernel/transport/integrator.h"

namespace pdr {

/// Health as threads count it together. Sample numbers below 2^32.
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

/// The samples of a launch, numbered so that 32 threads in step take the same sample of 8 x 4 neighbours, the next 32
/// their next sample, and only then come other pixels: they meet the same voxels.
struct SampleGrid {
    Tile tile;
    SampleRange samples;

    static constexpr int kWide = 8, kHigh = 4;

    PDR_HD int blocksPerRow() const { return (tile.width + kWide - 1) / kWide; }
    /// Some numbers are of no pixel of the tile: its edges cut blocks.
    PDR_HD std::int64_t count() const {
        const int rows = (tile.height + kHigh - 1) / kHigh;
        return std::int64_t(blocksPerRow()) * rows * samples.count * (kWide * kHigh);
    }
    /// Pixel, from the tile's corner, and sample, from the range's first, of a number; false: there is none.
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

/// Where the samples of a launch go before they are added: [sample][pixel of the tile].
struct TraceTarget {
    SampleGrid grid;
    vec3* radiance;  ///< linear Rec. 709
    GpuHealth* health;
    std::uint32_t* seen;  ///< kSeen... of each pixel of the tile ...
    int stride;           ///< ... and so many to the next row

    /// Of a pixel of the tile, row by row, in `seen` and in a film.
    PDR_HD std::int64_t inFilm(std::int64_t pixel) const {
        return pixel / grid.tile.width * stride + pixel % grid.tile.width;
    }
};

/// For the numbers of a launch's samples. How one is taken is told by
///   Take::Walk                             what it is at; its `found` is, at the end, the PathSample or Projected
///   Take::start(scene, Origin, Walk&)      before its first step; false: nothing is to be done, walk.found is known
///   Take::step(scene, Walk&)               false: it has ended
struct SampleAddress {
    ivec2 pixel;
    std::uint64_t sample;
};

template <class Take>
struct TraceKernel {
    FlatScene scene;
    TraceTarget target;

    struct Walk {
        typename Take::Walk taken;
        std::int64_t place;  ///< in target.radiance
        SampleAddress from;
    };

    PDR_HD bool start(std::int64_t index, Walk& walk) const {
        ivec2 place;
        std::uint32_t turn;
        if (!target.grid.at(index, place, turn))
            return false;
        const Tile& tile = target.grid.tile;
        walk.place = turn * target.grid.pixels() + std::int64_t(place.y) * tile.width + place.x;
        walk.from = {ivec2(tile.x, tile.y) + place, target.grid.samples.first + turn};
        if (Take::start(scene, walk.from, walk.taken))
            return true;
        end(walk);
        return false;
    }

    PDR_HD bool step(Walk& walk) const {
        if (Take::step(scene, walk.taken))
            return true;
        end(walk);
        return false;
    }

    PDR_HD void end(const Walk& walk) const {
        const auto& found = walk.taken.found;
        noteFaults(found, [&](Fault fault) {
            const ivec2 pixel = walk.from.pixel;
            target.health->note(fault, walk.from.sample, std::uint32_t(pixel.y * scene.camera.film.x + pixel.x));
        });
        target.radiance[walk.place] = found.radiance;
        const std::uint32_t seen = seenAtFirst(scene, depthBounds(scene, walk.from.pixel));
        const Tile& tile = target.grid.tile;
        const ivec2 place = walk.from.pixel - ivec2(tile.x, tile.y);
        if (const std::uint32_t all = seen | (found.tissue ? kSeenTissue : 0); all != 0)
            atomicMark(target.seen[std::int64_t(place.y) * target.stride + place.x], all);
    }
};

/// By Monte Carlo, with the effects F; a step is a segment of the path.
template <std::uint32_t F>
struct PathSampler {
    struct Walk {
        Path path;
        PathSample found;
        int bounce;
    };

    PDR_HD static bool start(const FlatScene& scene, const SampleAddress& from, Walk& walk) {
        const vec2 depths = depthBounds(scene, from.pixel);
        walk.found = PathSample{};
        walk.bounce = 0;
        if (isBackgroundOnly(scene, depths)) {
            walk.found.radiance = plainBackground(scene);
            return false;
        }
        walk.path = startPath(scene, from.pixel, from.sample, depths);
        return true;
    }
    PDR_HD static bool step(const FlatScene& scene, Walk& walk) {
        return traceSegment<F>(scene, walk.path, walk.bounce++, walk.found, NullVisitor());
    }
};

/// As Exposure Render does, in one step.
struct MarchSampler {
    struct Walk {
        SampleAddress from;
        PathSample found;
    };

    PDR_HD static bool start(const FlatScene& scene, const SampleAddress& from, Walk& walk) {
        walk = {from, {.radiance = plainBackground(scene)}};
        return !isBackgroundOnly(scene, depthBounds(scene, from.pixel));
    }
    PDR_HD static bool step(const FlatScene& scene, Walk& walk) {
        const ivec2 pixel = walk.from.pixel;
        walk.found = kroesSample(scene, pixel, walk.from.sample, depthBounds(scene, pixel));
        return false;
    }
};

/// A sum along the ray, in one step.
template <FlatModel Model>
struct ProjectionSampler {
    struct Walk {
        SampleAddress from;
        Projected found;
    };

    PDR_HD static bool start(const FlatScene& scene, const SampleAddress& from, Walk& walk) {
        walk.from = from;
        if (!isBackgroundOnly(scene, depthBounds(scene, from.pixel)))
            return true;
        walk.found = projectedMiss<Model>(scene, backdrop<Model>(scene, PathSegment{}));
        return false;
    }
    PDR_HD static bool step(const FlatScene& scene, Walk& walk) {
        const ivec2 pixel = walk.from.pixel;
        const PathSegment segment = startPath(scene, pixel, walk.from.sample, depthBounds(scene, pixel)).segment;
        walk.found = project<Model>(scene, segment.ray, backdrop<Model>(scene, segment));
        return false;
    }
};

/// For each pixel of the tile: its samples are added in order.
struct AccumulateKernel {
    TraceTarget from;
    int filmWidth;
    PixelSums* sums;   ///< of the tile, from.stride pixels to the next row
    Moments* moments;  ///< likewise: full blocks go there

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
            if ((sample + 1) % kSamplesPerBlock == 0) {
                moments[place] = merged(moments[place], pixelSums);
                pixelSums = nextBlock(pixelSums);
            }
        }
        sums[place] = pixelSums;
    }
};

}  // namespace pdr
