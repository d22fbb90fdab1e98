#pragma once
/// The CPU's way through kernel/integrator.h: the paths of many samples, step by step together.

#include "render/device/cpu/lane_tracker.h"
#include "render/kernel/pixel.h"

namespace pdr {

/// Renders pixels of one scene; owns the room for the paths, so one per thread.
class PixelBatch {
  public:
    /// Adds `samples` to each pixel of [x, x + width) x [y, y + height), sums at (row, column) * stride.
    template <std::uint32_t F>
    void render(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums) {
        for (int y = 0; y < tile.height; ++y)
            for (int x = 0; x < tile.width; ++x) {
                const ivec2 pixel(tile.x + x, tile.y + y);
                PixelSums& target = sums.pixels[std::ptrdiff_t(y) * sums.stride + x];
                const vec2 depths = matterDepths(scene, pixel);
                for (std::uint32_t i = 0; i < samples.count; ++i) {
                    if (meetsNothing(depths)) {
                        addSample(target, background(scene));
                        continue;
                    }
                    if (rays_.full())
                        finish<F>(scene);
                    start(scene, pixel, samples.first + i, depths, target);
                }
            }
        finish<F>(scene);
    }

  private:
    void start(const FlatScene& scene, ivec2 pixel, std::uint64_t sample, vec2 depths, PixelSums& target) {
        const int row = rays_.size();
        paths_[row] = cameraStart(scene, pixel, sample, depths);
        targets_[row] = &target;
        rays_.add(paths_[row].camera.ray, paths_[row].random.stream(0, BounceDimension::flight));
    }

    /// Takes all started paths to their end and adds them up, in the order in which they were started.
    template <std::uint32_t F>
    void finish(const FlatScene& scene) {
        rays_.track<DeltaTracking>(scene);
        lights_.clear();
        for (int row = 0; row < rays_.size(); ++row)
            arrive<F>(scene, row);
        lights_.track<RatioTracking>(scene);
        for (int row = 0; row < rays_.size(); ++row) {
            vec3 radiance = radiance_[row];
            if (lightRow_[row] != kDark)
                radiance += scattered_[row] * lights_.result(lightRow_[row]);
            addSample(*targets_[row], radiance);
        }
        rays_.clear();
    }

    /// The end of one camera ray: what is known of the radiance, and the light path that is still to be followed.
    template <std::uint32_t F>
    void arrive(const FlatScene& scene, int row) {
        lightRow_[row] = kDark;
        if (rays_.result(row) < 0) {
            radiance_[row] = background(scene);
            return;
        }
        const Arrival met = arrival<F>(scene, paths_[row], rays_.result(row));
        radiance_[row] = met.emitted;
        if (isDark(met.scattered))
            return;
        scattered_[row] = met.scattered.radiance;
        lightRow_[row] = lights_.size();
        lights_.add(met.scattered.ray, paths_[row].random.stream(0, BounceDimension::shadow));
    }

    static constexpr int kDark = -1;  ///< instead of a light path's row: there is none

    std::array<Path, RayBatch::kCapacity> paths_;
    std::array<PixelSums*, RayBatch::kCapacity> targets_;
    std::array<vec3, RayBatch::kCapacity> radiance_, scattered_;
    std::array<int, RayBatch::kCapacity> lightRow_;
    RayBatch rays_, lights_;
};

}  // namespace pdr
