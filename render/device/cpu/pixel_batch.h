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
        for (int row = 0; row < rays_.size(); ++row) {
            radiance_[row] = vec3(0);
            lightRow_[row] = -1;
            if (rays_.result(row) < 0) {
                radiance_[row] = background(scene);
                continue;
            }
            const LightPath light = scatteredLight<F>(scene, paths_[row], rays_.result(row));
            if (isDark(light))
                continue;
            radiance_[row] = light.radiance;
            lightRow_[row] = lights_.size();
            lights_.add(light.ray, paths_[row].random.stream(0, BounceDimension::shadow));
        }
        lights_.track<RatioTracking>(scene);
        for (int row = 0; row < rays_.size(); ++row) {
            const float visible = lightRow_[row] < 0 ? 1.0f : lights_.result(lightRow_[row]);
            addSample(*targets_[row], radiance_[row] * visible);
        }
        rays_.clear();
    }

    std::array<Path, RayBatch::kCapacity> paths_;
    std::array<PixelSums*, RayBatch::kCapacity> targets_;
    std::array<vec3, RayBatch::kCapacity> radiance_;
    std::array<int, RayBatch::kCapacity> lightRow_;
    RayBatch rays_, lights_;
};

}  // namespace pdr
