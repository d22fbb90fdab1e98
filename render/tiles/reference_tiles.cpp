#include "render/tiles/reference_tiles.h"

#include <cstdint>
#include <cstring>
#include <memory>

#include "render/scene/scene.h"
#include "render/tiles/trace_lease.h"

namespace pdr {
namespace {

constexpr SampleRange kSamples{56, 8};  // the end of a block

/// Makes tissue by integer arithmetic, which is independent of any library.
std::shared_ptr<const Volume> referenceVolume() {
    constexpr ivec3 kSize{28, 26, 24};
    Voxels voxels;
    voxels.reserve(std::size_t(kSize.x) * kSize.y * kSize.z);
    std::uint32_t noise = 1;
    for (int k = 0; k < kSize.z; ++k)
        for (int j = 0; j < kSize.y; ++j)
            for (int i = 0; i < kSize.x; ++i) {
                noise = noise * 1664525u + 1013904223u;  // Knuth's linear congruence
                const int x = i - 14, y = j - 13, z = k - 12;
                voxels.push_back(std::int16_t(1400 - 14 * (x * x + y * y + z * z) + int(noise >> 24)));
            }
    return std::make_shared<Volume>(VolumeGeometry::aligned(kSize, {1, 1.25, 1.5}, {-14, -16, -18}), std::move(voxels));
}

Scene litScene() {
    Scene scene;
    scene.volume = referenceVolume();
    scene.transferFunction.extinctionPerMm = 0.5f;
    scene.transferFunction.nodes = {{.hu = -200, .opacity = 0},
                                    {.hu = 300, .opacity = 0.2f, .albedo = vec3(0.9f, 0.6f, 0.5f)},
                                    {.hu = 900, .opacity = 1, .specular = vec3(0.04f), .roughness = 0.3f}};
    scene.gradientFactor = 2;
    scene.phaseG = 0.4f;
    scene.lights = {DirectionalLight{{0.3, 1, -1}, vec3(2)},
                    RectangleLight{{-60, -80, 40}, {0.6, 0.8, -0.4}, {0, 0, 1}, 50, 40, vec3(9)},
                    SphereLight{{70, -50, 10}, 20, vec3(4)}};
    scene.environment = {.radiance = vec3(0.2f, 0.25f, 0.3f), .nadir = vec3(0.1f)};
    scene.camera = {.eyeMm = {20, -90, 30}, .apertureMm = 4};
    scene.clip.planes = {{{0, -9, 0}, {0.2, -1, 0.1}}};
    scene.film = {kFilmCell * 2, kFilmCell};
    return scene;
}

std::vector<Scene> referenceScenes() {
    std::vector<Scene> scenes;
    for (const Model model : kModels) {
        Scene scene = litScene();
        scene.model = model;
        scenes.push_back(scene);
    }
    return scenes;
}

template <class Number>
void append(std::vector<std::byte>& bytes, const Number& number) {
    const auto* begin = reinterpret_cast<const std::byte*>(&number);
    bytes.insert(bytes.end(), begin, begin + sizeof number);
}

/// Appends sums member by member, since padding is undefined.
void append(std::vector<std::byte>& bytes, const PixelSums& sums) {
    append(bytes, sums.sum);
    append(bytes, sums.sumOfSquares);
    append(bytes, sums.evenSum);
    append(bytes, sums.evenCount);
    append(bytes, sums.count);
    append(bytes, sums.seen);
}

}  // namespace

Result<std::vector<std::byte>> referenceTiles(Device& device) {
    std::vector<std::byte> bytes;
    for (const Scene& scene : referenceScenes()) {
        if (Result<void> uploaded = device.upload(scene); !uploaded)
            return uploaded.error();
        const Result<LeaseResult> result = traceLease(device, {1, 1, wholeImage(scene.film), kSamples, {}}, {});
        if (!result)
            return result.error();
        for (const PixelSums& sums : result->sums)
            append(bytes, sums);
    }
    if (Result<void> forgotten = device.unload(); !forgotten)
        return forgotten.error();
    return bytes;
}

}  // namespace pdr
