#include "render/device/cpu/guide_batch.h"

#include <algorithm>
#include <cmath>

#include "render/kernel/attenuation.h"
#include "render/kernel/pixel.h"
#include "render/kernel/transport/integrator.h"

namespace pdr {
namespace {

/// A place where a ray is evaluated, for all that it passes from the previous layer up to an opacity.
struct Layer {
    float depth;  ///< optical depth
    float upTo;   ///< opacity
};

/// One layer for thin tissue in front of dense tissue, and one for the rest, at the depth where half of the light is
/// gone; that one counts as opaque. More layers cost more than they gain.
constexpr Layer kLayers[] = {{0.05129f, 0.15f}, {0.69315f, 1.0f}};

/// Returns the depth as Guide defines it. Depths that differ by the width of a pixel there differ by 1; in perspective,
/// pixels grow with the depth.
float depthInPixels(const FlatScene& scene, vec3 position) {
    const FlatCamera& camera = scene.camera;
    const double depth = glm::dot(dvec3(localPosition(scene.volume, position)) - camera.localEye, camera.forward);
    const double wide = glm::length(camera.right) * camera.perPixel.x;
    return float((camera.perspective != 0 ? std::log(std::max(depth, 1e-6)) : depth) / wide);
}

}  // namespace

bool canBeGuided(const FlatScene& scene) {
    return scene.optics.model == FlatModel::scattering && !scene.marched && scene.camera.focus == 0;
}

/// Lets the last evaluated place stand for everything up to that opacity.
void GuideBatch::Pixel::settle(float upTo) {
    const float weight = std::max(upTo - opacity, 0.0f);
    seen.radiance += weight * last.radiance;
    seen.normal += weight * last.normal;
    opacity += weight;
}

Ray GuideBatch::Pixel::rest() const {
    const Ray& ray = segment.ray;
    return {ray.origin + ray.direction * reached, ray.direction, ray.length - reached};
}

void GuideBatch::look(const FlatScene& scene, const Tile& tile, vec2 place, denoise::Guide& guide) {
    for (int y = tile.y; y < tile.y + tile.height; ++y)
        for (int x = tile.x; x < tile.x + tile.width; ++x) {
            const vec2 depths = depthBounds(scene, ivec2(x, y) / guide.finer);
            if (isBackgroundOnly(scene, depths) && plainBackground(scene) == vec3(0))
                continue;
            const vec2 onFilm = (vec2(x, y) + place) / float(guide.finer);
            pixels_.push_back({{x, y}, generateCameraRay(scene, onFilm, vec2(0), depths)});
            if (pixels_.size() == FlightBatch::kCapacity)
                finish(scene, guide);
        }
    finish(scene, guide);
}

void GuideBatch::finish(const FlatScene& scene, denoise::Guide& guide) {
    going_.clear();
    for (Pixel& pixel : pixels_)
        going_.push_back(&pixel);
    Layer before{0, 0};
    // Fly to one layer after the other; rays that leave the volume are done
    for (const Layer& layer : kLayers) {
        flights_.clear();
        for (const Pixel* pixel : going_)
            flights_.add(pixel->rest(), layer.depth - before.depth);
        flights_.fly(scene);
        int flight = 0;
        std::erase_if(going_, [&](Pixel* pixel) {
            const float distance = flights_.distance(flight), passed = flights_.passed(flight);
            ++flight;
            const bool met = distance >= 0;
            pixel->settle(met ? before.upTo : attenuation(before.depth + passed).taken);
            if (met) {
                pixel->reached += distance;
                pixel->last = unshadowedAt(scene, pixel->rest().origin, -pixel->segment.direction);
            }
            return !met;
        });
        before = layer;
    }
    // Rays that reach the last layer count as opaque
    for (Pixel* pixel : going_)
        pixel->settle(before.upTo);
    for (const Pixel& pixel : pixels_)
        keep(scene, pixel, guide);
    pixels_.clear();
}

void GuideBatch::keep(const FlatScene& scene, const Pixel& pixel, denoise::Guide& guide) {
    const vec3 radiance = pixel.seen.radiance + (1 - pixel.opacity) * background(scene, pixel.segment);
    for (int c = 0; c < 3; ++c) {
        guide.radiance[c].row(pixel.place.y)[pixel.place.x] = radiance[c];
        guide.normal[c].row(pixel.place.y)[pixel.place.x] = pixel.seen.normal[c];
    }
    guide.opacity.row(pixel.place.y)[pixel.place.x] = pixel.opacity;
    if (pixel.opacity > 0)
        guide.depth.row(pixel.place.y)[pixel.place.x] = depthInPixels(scene, pixel.rest().origin);
}

}  // namespace pdr
