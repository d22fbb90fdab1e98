#pragma once
/// Lists the fields of each message with their keys and ranges, once for both writing and reading (map_writer.h,
/// map_reader.h). Keys ascend. The key of a removed field stays unused; a new field gets a higher key.

#include "app/wire/messages.h"
#include "render/base/image_size.h"

namespace pdr::wire {

inline constexpr std::uint64_t kMostVoxels = std::uint64_t(1) << 31;  ///< voxels of a volume
inline constexpr std::uint64_t kMostTexels = std::uint64_t(1) << 27;  ///< texels of an environment map
inline constexpr int kMostAlongAxis = 2048;                           ///< voxels along an axis of a volume
inline constexpr std::uint64_t kLastSample = std::uint64_t(1) << 53;  ///< highest index of a lease's first sample
inline constexpr double kMostSeconds = 1e9;                           ///< longest time that a result may report

inline std::array<int*, 3> places(ivec3& v) {
    return {&v.x, &v.y, &v.z};
}
inline std::array<int*, 2> places(ivec2& v) {
    return {&v.x, &v.y};
}

template <class Fields>
void fields(Fields& map, Hello& hello) {
    map.numbers(1, std::array{&hello.versions.lowest, &hello.versions.highest}, 1);
    map.must(hello.versions.lowest <= hello.versions.highest, "its versions end before they begin");
    map.text(2, hello.program, kMostNameBytes);
    map.text(3, hello.name, kMostNameBytes);
    map.bytes(4, hello.boot);
    map.bytes(5, hello.bits);
    map.text(6, hello.device, kMostNameBytes);
    map.text(7, hello.details, kMostWordBytes);
    map.number(8, hello.memoryBytes);
    if (map.optional(9, hello.keptPixels))
        map.number(9, *hello.keptPixels);
}

template <class Fields>
void fields(Fields& map, Welcome& welcome) {
    map.number(1, welcome.version, 1);
    map.number(2, welcome.heartbeatMs, 100, 60000);
    map.bytes(3, welcome.key);
}

template <class Fields>
void fields(Fields& map, Refused& refused) {
    map.number(1, refused.why, 1, 3);
    map.phrase(2, 3, refused.reason);
}

template <class Fields>
void fields(Fields& map, Ping& ping) {
    map.number(1, ping.number);
}
template <class Fields>
void fields(Fields& map, Pong& pong) {
    map.number(1, pong.number);
}

template <class Fields>
void fields(Fields& map, SceneOrder& order) {
    VolumeOrder& volume = order.volume;
    map.number(1, order.revision);
    map.bytes(2, volume.content);
    map.numbers(3, places(volume.size), 1, kMostAlongAxis);
    map.must(std::uint64_t(volume.size.x) * volume.size.y * volume.size.z <= kMostVoxels, "its volume is too large");
    map.reals(4, volume.patientFromIndex);
    if (map.optional(5, order.mask)) {
        MaskOrder& mask = *order.mask;
        map.bytes(5, mask.content);
        map.numbers(6, places(mask.voxels), 1, kMostAlongAxis);
        map.must(mask.voxels == volume.size, "its mask is of another volume");
        map.numbers(7, places(mask.shift), 0, 15);
    }
    if (map.optional(8, order.environment)) {
        EnvironmentOrder& environment = *order.environment;
        map.bytes(8, environment.content);
        map.numbers(9, places(environment.size), 1, kLongestSide);
        map.must(std::uint64_t(environment.size.x) * environment.size.y <= kMostTexels,
                 "its image of the surroundings is too large");
    }
    if (map.optional(10, order.labels))
        map.bytes(10, order.labels->content);
}

template <class Fields>
void fields(Fields& map, Need& need) {
    map.bytes(1, need.content);
    map.number(2, need.from);
}

template <class Fields>
void fields(Fields& map, Chunk& chunk) {
    map.bytes(1, chunk.content);
    map.number(2, chunk.index);
    map.number(3, chunk.rawBytes, 1, kChunkBytes);
}

template <class Fields>
void fields(Fields& map, SceneReady& ready) {
    map.number(1, ready.revision);
}
template <class Fields>
void fields(Fields& map, SceneRefused& refused) {
    map.number(1, refused.revision);
    map.phrase(2, 3, refused.reason);
    if (map.optional(4, refused.place))
        map.number(4, *refused.place, 1);
}

/// Fields that a lease and its result share.
template <class Fields, class Work>
void workFields(Fields& map, Work& work) {
    Tile& tile = work.tile;
    map.number(1, work.number);
    map.bytes(2, work.nonce);
    map.number(3, work.revision);
    map.numbers(4, std::array{&tile.x, &tile.y}, 0, kLongestSide - 1);
    map.numbers(5, std::array{&tile.width, &tile.height}, 1, kLongestSide);
    map.must(isInside(tile, {0, 0, kLongestSide, kLongestSide}), "its tile lies outside of all images");
    map.number(6, work.samples.first, 0, kLastSample);
    map.number(7, work.samples.count, 1, kMostDeepSamples);
    const bool deep = isDeep(work.samples);
    map.must(std::uint64_t(tile.width) * tile.height <= (deep ? kMostDeepPixels : kMostLeasePixels),
             "its tile is too large");
    map.must(deep ? work.samples.first % kSamplesPerBlock == 0 && work.samples.count % kSamplesPerBlock == 0
                  : work.samples == samplesInBlock(work.samples.first, work.samples.count),
             "its samples are of parts of blocks");
}

template <class Fields>
void fields(Fields& map, Lease& lease) {
    workFields(map, lease);
    if (map.optional(8, lease.kept))
        map.bytes(8, *lease.kept);
}

template <class Fields>
void fields(Fields& map, Result& result) {
    std::array<std::uint64_t*, 2 * kFaults> numbers;
    std::array<std::uint32_t*, kFaults> pixels;
    for (int i = 0; i < kFaults; ++i) {
        FaultCount& fault = result.health.faults[i];
        numbers[2 * i] = &fault.count;
        numbers[2 * i + 1] = &fault.sample;
        pixels[i] = &fault.pixel;
    }
    workFields(map, result);
    map.numbers(8, numbers);
    map.numbers(9, pixels);
    map.real(10, result.seconds, 0, kMostSeconds);
}

template <class Fields>
void fields(Fields& map, Abandoned& abandoned) {
    map.number(1, abandoned.number);
    map.bytes(2, abandoned.nonce);
    map.phrase(3, 4, abandoned.reason);
}

template <class Fields>
void fields(Fields&, Draining&) {}
template <class Fields>
void fields(Fields&, Forget&) {}

template <class Fields>
void fields(Fields& map, Bye& bye) {
    map.phrase(1, 2, bye.reason);
}

}  // namespace pdr::wire
