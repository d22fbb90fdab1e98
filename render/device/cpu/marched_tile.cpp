#include "render/device/cpu/marched_tile.h"

#include "render/device/cpu/sample_origin.h"
#include "render/kernel/baseline/kroes_path.h"

namespace pdr {

void renderMarched(const FlatScene& scene, const Tile& tile, SampleRange samples, TileSums sums) {
    for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x) {
            const ivec2 pixel(tile.x + x, tile.y + y);
            const vec2 depths = depthBounds(scene, pixel);
            const bool nothing = isBackgroundOnly(scene, depths);
            SampleOrigin origin(sums.pixels[std::ptrdiff_t(y) * sums.stride + x], scene, pixel, samples.first);
            origin.see(seenAtFirst(scene, depths));
            for (std::uint32_t i = 0; i < samples.count; ++i, ++origin.sample) {
                const PathSample found = nothing ? PathSample{.radiance = plainBackground(scene)}
                                                 : kroesSample(scene, pixel, origin.sample, depths);
                origin.add(found, *sums.health);
            }
        }
}

}  // namespace pdr
