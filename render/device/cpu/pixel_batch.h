#pragma once
/// The CPU's way through kernel/integrator.h: the paths of many samples, step by step together.

#include "render/device/cpu/lane_tracker.h"
#include "render/device/cpu/sample_origin.h"
#include "render/kernel/transport/integrator.h"

namespace pdr {

/// Renders pixels of one scene; owns the room for the paths, so one per thread.
class PixelBatch {
  public:
    /// Adds `samples` to each pixel of `tile`. sums.health must be there.
    template <std::uint32_t F>
    void render(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums) {
        health_ = sums.health;
        for (int y = 0; y < tile.height; ++y)
            for (int x = 0; x < tile.width; ++x)
                startPixel<F>(scene, {tile.x + x, tile.y + y}, samples,
                              sums.pixels[std::ptrdiff_t(y) * sums.stride + x]);
        finish<F>(scene);
    }

  private:
    template <std::uint32_t F>
    void startPixel(const FlatScene& scene, ivec2 pixel, SampleRange samples, PixelSums& target) {
        const vec2 depths = depthBounds(scene, pixel);
        const bool nothing = isBackgroundOnly(scene, depths);
        const vec3 background = plainBackground(scene);
        target.seen |= seenAtFirst(scene, depths);
        SampleOrigin origin(target, scene, pixel, samples.first);
        for (std::uint32_t i = 0; i < samples.count; ++i, ++origin.sample) {
            if (nothing) {
                origin.add(background, *health_);
                continue;
            }
            if (rays_.full())
                finish<F>(scene);
            start(scene, pixel, depths, origin);
        }
    }

    PDR_HD_INLINE void start(const FlatScene& scene, ivec2 pixel, vec2 depths, const SampleOrigin& origin) {
        const int path = rays_.size();
        paths_[path] = startPath(scene, pixel, origin.sample, depths);
        samples_[path] = PathSample{};
        origins_[path] = origin;
        addSegment(path, 0);
    }

    /// The path's next segment is to be tracked.
    PDR_HD_INLINE void addSegment(int path, int bounce) {
        pathOf_[rays_.size()] = path;
        rays_.add(paths_[path].segment.ray, distanceStream(paths_[path], bounce));
    }

    /// Takes all started paths to their end and adds them up, in the order in which they were started.
    template <std::uint32_t F>
    void finish(const FlatScene& scene) {
        const int started = rays_.size();
        for (int bounce = 0; rays_.size() > 0; ++bounce)
            traceSegments<F>(scene, bounce);
        for (int path = 0; path < started; ++path)
            origins_[path].add(samples_[path], *health_);
    }

    /// Every path that is on its way goes on to its next event and meets the light there; rays_ are then the next
    /// segments.
    template <std::uint32_t F>
    void traceSegments(const FlatScene& scene, int bounce) {
        rays_.track<DeltaTracking>(scene);
        for (const int row : rays_.overMajorant())
            samples_[pathOf_[row]].overMajorant = true;
        const int segments = rays_.size();
        lights_.clear();
        for (int row = 0; row < segments; ++row)
            endRow<F>(scene, row, bounce);
        traceLights(scene);
        rays_.clear();
        for (int row = 0; has(F, kBounces) && row < segments; ++row)
            if (continues_[row])
                addSegment(pathOf_[row], bounce + 1);
    }

    template <std::uint32_t F>
    void endRow(const FlatScene& scene, int row, int bounce) {
        const int path = pathOf_[row];
        const PathVertex vertex = endSegment<F>(scene, paths_[path], rays_.result(row), bounce, samples_[path]);
        continues_[row] = vertex.continues;
        if (isDark(vertex.scattered))
            return;
        scattered_[lights_.size()] = vertex.scattered.radiance;
        pathOfLight_[lights_.size()] = path;
        lights_.add(vertex.scattered.ray, shadowStream(paths_[path], bounce));
    }

    void traceLights(const FlatScene& scene) {
        lights_.track<RatioTracking>(scene);
        for (const int row : lights_.overMajorant())
            samples_[pathOfLight_[row]].overMajorant = true;
        for (int row = 0; row < lights_.size(); ++row)
            addLight(samples_[pathOfLight_[row]], scattered_[row], lights_.result(row));
    }

    // by path
    std::array<Path, RayBatch::kCapacity> paths_;
    std::array<SampleOrigin, RayBatch::kCapacity> origins_;
    std::array<PathSample, RayBatch::kCapacity> samples_;
    // by segment, which has the row of its ray
    std::array<int, RayBatch::kCapacity> pathOf_;
    std::array<bool, RayBatch::kCapacity> continues_;
    // by light path, which has the row of its ray
    std::array<int, RayBatch::kCapacity> pathOfLight_;
    std::array<vec3, RayBatch::kCapacity> scattered_;
    RayBatch rays_, lights_;
    Health* health_ = nullptr;
};

}  // namespace pdr
