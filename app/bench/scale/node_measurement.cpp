#include "app/bench/scale/node_measurement.h"

#include <algorithm>
#include <array>
#include <limits>

#include "app/bench/median.h"
#include "app/bench/paper/frame_clock.h"
#include "app/bench/paper/plan.h"

namespace pdr::bench::scale {

namespace {

constexpr std::array<ivec2, 5> kFrameSizes{{{48, 27}, {60, 34}, {84, 48}, {120, 67}, {160, 90}}};
constexpr std::array<std::uint32_t, 3> kIterations{1, 16, 128};
constexpr int kRounds = 3;

constexpr ivec2 kTiledSize{480, 272};
constexpr int kTilesAlong = 8;
constexpr std::uint32_t kTileSamples = 16;

const Error kStopped{"the measurement was broken off", "", "", ErrorKind::cancelled};

Result<std::vector<TimedFrame>> timedFrames(Device& device, Scene& scene, const Display& display, double seconds,
                                            const paper::WorkClock& now, const std::stop_token& stop) {
    paper::Plan plan;
    plan.onGpu = !device.info().hostMemory;
    std::vector<TimedFrame> frames;
    for (const ivec2 size : kFrameSizes) {
        scene.film = size;
        ++scene.revision;
        if (const auto uploaded = device.upload(scene); !uploaded)
            return uploaded.error();
        for (const std::uint32_t n : kIterations) {
            std::vector<double> took;
            for (int round = 0; round < kRounds; ++round) {
                const auto film = device.film(size, scene.revision, {});
                const auto lap = film ? paper::timeFrames(**film, n, display, seconds / kRounds, now, stop)
                                      : Result<paper::Lap>(film.error());
                if (!lap)
                    return lap.error();
                if (lap->frames == 0)
                    return kStopped;
                took.push_back(lap->seconds / double(lap->frames));
            }
            frames.push_back({{double(size.x) * size.y, n, std::min(n, plan.mostPerLaunch(size))}, median(took)});
        }
    }
    return frames;
}

/// Returns the shortest time of a tile in several rounds, minus `floor`, the time that every frame takes [s].
Result<double> tileSeconds(Device& device, const Scene& scene, const Tile& tile, double floor,
                           const paper::WorkClock& now, const std::stop_token& stop) {
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < kRounds; ++round) {
        const auto film = device.film(tile, scene.revision, {});
        if (!film)
            return film.error();
        const double began = now();
        Result<void> done = (*film)->accumulate(kTileSamples, stop);
        if (done)
            done = (*film)->resolve({}, stop);
        const auto image = done ? (*film)->readback() : Result<Image>(done.error());
        if (!image)
            return image.error();
        if (stop.stop_requested())
            return kStopped;
        least = std::min(least, now() - began);
    }
    return std::max(0.0, least - floor);
}

Result<TileCosts> tileCosts(Device& device, Scene& scene, double floor, const paper::WorkClock& now,
                            const std::stop_token& stop) {
    scene.film = kTiledSize;
    ++scene.revision;
    if (const auto uploaded = device.upload(scene); !uploaded)
        return uploaded.error();
    const ivec2 size = kTiledSize / kTilesAlong;
    std::vector<double> costs;
    for (int y = 0; y < kTiledSize.y; y += size.y)
        for (int x = 0; x < kTiledSize.x; x += size.x) {
            const auto seconds = tileSeconds(device, scene, {x, y, size.x, size.y}, floor, now, stop);
            if (!seconds)
                return seconds.error();
            costs.push_back(*seconds);
        }
    return TileCosts(costs);
}

}  // namespace

Result<MeasuredNode> measureNode(Device& device, Scene scene, const Display& display, double seconds,
                                 const paper::WorkClock& now, std::stop_token stop) {
    const auto frames = timedFrames(device, scene, display, seconds, now, stop);
    if (!frames)
        return frames.error();
    const auto fit = FrameTimeFit::of(*frames);
    if (!fit)
        return fit.error();
    const FrameTimeModel& model = fit->model();
    auto tiles = tileCosts(device, scene, model.launch + model.communication, now, stop);
    if (!tiles)
        return tiles.error();
    return MeasuredNode{*fit, *std::move(tiles)};
}

}  // namespace pdr::bench::scale
