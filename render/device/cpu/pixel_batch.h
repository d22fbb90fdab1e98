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
        radiance_[path] = vec3(0);
        origins_[path] = origin;
        pathOf_[path] = path;
        rays_.add(paths_[path].segment.ray, paths_[path].random.stream(0, BounceDimension::distance));
    }

    /// Takes all started paths to their end and adds them up, in the order in which they were started.
    template <std::uint32_t F>
    void finish(const FlatScene& scene) {
        const int started = rays_.size();
        for (int bounce = 0; rays_.size() > 0; ++bounce)
            traceSegments<F>(scene, bounce);
        for (int path = 0; path < started; ++path)
            origins_[path].add(radiance_[path], *health_);
    }

    /// Every path that is on its way goes on to its next event and meets the light there; rays_ are then the next segments.
    template <std::uint32_t F>
    void traceSegments(const FlatScene& scene, int bounce) {
        rays_.track<DeltaTracking>(scene);
        for (const int row : rays_.overMajorant())
            origins_[pathOf_[row]].note(Fault::overMajorant, *health_);
        lights_.clear();
        const int segments = rays_.size();
        for (int row = 0; row < segments; ++row)
            shade<F>(scene, row, bounce);
        lights_.track<RatioTracking>(scene);
        for (const int row : lights_.overMajorant())
            origins_[pathOfLight_[row]].note(Fault::overMajorant, *health_);
        rays_.clear();
        for (int row = 0; row < segments; ++row) {
            const int path = pathOf_[row];
            if (lightRow_[row] != kDark && lights_.result(lightRow_[row]) != 0)
                radiance_[path] += scattered_[row] * lights_.result(lightRow_[row]);
            if (has(F, kBounces) && continues_[row]) {
                pathOf_[rays_.size()] = path;
                rays_.add(paths_[path].segment.ray, paths_[path].random.stream(bounce + 1, BounceDimension::distance));
            }
        }
    }

    /// The end of one segment: what is known of the radiance, and the light path that is still to be followed.
    template <std::uint32_t F>
    void shade(const FlatScene& scene, int row, int bounce) {
        const int path = pathOf_[row];
        lightRow_[row] = kDark;
        continues_[row] = false;
        const float collision = rays_.result(row);
        if (!(collision >= 0)) {
            if (bounce == 0 || collision != collision)
                radiance_[path] = missed(scene, paths_[path].segment, collision);
            return;
        }
        if (bounce == 0)
            origins_[path].see(kSeenTissue);
        const PathVertex met = shadeVertex<F>(scene, paths_[path], collision, bounce);
        radiance_[path] += met.emitted;
        continues_[row] = met.continues;
        if (met.cut)
            origins_[path].note(Fault::cutPath, *health_);
        if (isDark(met.scattered))
            return;
        scattered_[row] = met.scattered.radiance;
        lightRow_[row] = lights_.size();
        pathOfLight_[lights_.size()] = path;
        lights_.add(met.scattered.ray, paths_[path].random.stream(bounce, BounceDimension::shadow));
    }

    static constexpr int kDark = -1;  ///< instead of a light path's row: there is none

    // by path
    std::array<Path, RayBatch::kCapacity> paths_;
    std::array<SampleOrigin, RayBatch::kCapacity> origins_;
    std::array<vec3, RayBatch::kCapacity> radiance_;
    // by segment, which has the row of its ray
    std::array<int, RayBatch::kCapacity> pathOf_;
    std::array<vec3, RayBatch::kCapacity> scattered_;
    std::array<int, RayBatch::kCapacity> lightRow_;
    std::array<bool, RayBatch::kCapacity> continues_;
    std::array<int, RayBatch::kCapacity> pathOfLight_;  ///< by light path
    RayBatch rays_, lights_;
    Health* health_ = nullptr;
};

}  // namespace pdr
