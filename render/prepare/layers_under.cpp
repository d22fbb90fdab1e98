#include "render/prepare/layers_under.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "render/kernel/volume_sampling.h"
#include "render/prepare/highest_along.h"
#include "render/prepare/light_layers.h"

namespace pdr {

namespace {

constexpr double kPlaceShare = 0.5;
constexpr double kLeastShare = 0.15;
constexpr double kAroundMm = 1.5;
constexpr double kJumpMm = 5;
constexpr int kAround = 8;
constexpr int kQuantiles = 64, kQuantilesAround = 16;

/// Standard deviation of a uniform distribution, as a fraction of its width.
const double kUniformSigma = 1 / std::sqrt(12.0);

/// The light under one point of the film.
struct Light {
    PathSegment segment;
    double met = 0;
    std::vector<LightLayer> layers;  ///< heaviest first
};

/// Returns the light of a maximum intensity projection: all of it comes from one place.
Light brightestAt(const FlatScene& scene, vec2 place) {
    Light light{generateCameraRay(scene, place, vec2(0), vec2(0, 1e30f))};
    if (const auto highest = highestAlong(scene, light.segment.ray); highest && highest->hu > scene.optics.windowLow) {
        light.met = 1;
        light.layers = {{highest->alongMm, spacingAlong(light.segment.ray) * kUniformSigma, 1, 1}};
    }
    return light;
}

Light lightAt(const FlatScene& scene, vec2 place, int quantiles) {
    if (scene.optics.model == FlatModel::maximumIntensity)
        return brightestAt(scene, place);
    const FirstEvents events(scene, place);
    return {events.segment(), events.met(), lightLayers(events, quantiles)};
}

/// Returns the length of the ray that holds the middle 80 % of the light that meets tissue [mm].
double spreadOf(const FirstEvents& events) {
    return events.where(0.9 * events.met()) - events.where(0.1 * events.met());
}

dvec3 localPlace(const FlatVolume& volume, const PathSegment& segment, double alongMm) {
    return dvec3(localPosition(volume, segment.ray.origin)) + dvec3(segment.direction) * alongMm;
}

double depthOf(const FlatScene& scene, const PathSegment& segment, double alongMm) {
    return glm::dot(localPlace(scene.volume, segment, alongMm) - scene.camera.localEye, scene.camera.forward);
}

double mmPerPixel(const FlatCamera& camera, double depthMm) {
    return glm::length(camera.right) * camera.perPixel.x * (camera.perspective > 0 ? depthMm : 1);
}

/// Returns the standard deviation of a place across the ray [mm]: of a point anywhere in the pixel, and anywhere in the
/// circle of confusion at its depth, whose standard deviation along one axis is a quarter of its diameter.
double sigmaAcross(const FlatCamera& camera, double depthMm) {
    const double radius = camera.focus > 0 ? glm::length(camera.lensRight) * std::fabs(1 - depthMm / camera.focus) : 0;
    return std::hypot(mmPerPixel(camera, depthMm) * kUniformSigma, radius / 2);
}

/// Returns the layers at eight points around `place`, at least a pixel away, as depths [mm from the eye along the
/// view]. Points without a layer are left out.
std::vector<std::vector<double>> depthsAround(const FlatScene& scene, vec2 place, double depthMm) {
    const double radius = std::max(1.0, kAroundMm / mmPerPixel(scene.camera, depthMm));
    std::vector<std::vector<double>> around;
    for (int i = 0; i < kAround; ++i) {
        const double angle = 2 * std::numbers::pi * i / kAround;
        const vec2 beside = place + vec2(dvec2(std::cos(angle), std::sin(angle)) * radius);
        const Light light = lightAt(scene, beside, kQuantilesAround);
        std::vector<double> depths;
        for (const LightLayer& layer : light.layers)
            depths.push_back(depthOf(scene, light.segment, layer.alongMm));
        if (!depths.empty())
            around.push_back(std::move(depths));
    }
    return around;
}

/// Marks `layer` if it does not go on around the point: each point around is compared by the layer nearest in depth.
/// The root mean square of the differences is how uncertain the depth is.
void markSilhouette(SeenLayer& layer, const std::vector<std::vector<double>>& around) {
    double squares = 0;
    for (const std::vector<double>& depths : around) {
        double nearest = 1e30;
        for (const double depth : depths)
            nearest = std::min(nearest, std::fabs(depth - layer.depthMm));
        layer.onSilhouette = layer.onSilhouette || nearest > kJumpMm;
        squares += nearest * nearest;
    }
    if (layer.onSilhouette)
        layer.sigmaAlongMm = std::hypot(layer.sigmaAlongMm, std::sqrt(squares / double(around.size())));
}

/// Returns the layers of `light` that may be taken for a place: the one that holds half of the light, or else all that
/// hold enough, nearest first.
std::vector<LightLayer> takeable(const Light& light) {
    std::vector<LightLayer> layers;
    for (const LightLayer& layer : light.layers)
        if (layer.share >= kLeastShare && layer.nearShare >= kLeastShare)
            layers.push_back(layer);
    if (!layers.empty() && layers.front().share >= kPlaceShare)
        layers.resize(1);
    std::ranges::sort(layers, {}, &LightLayer::alongMm);
    return layers;
}

SeenAt seenAt(const std::vector<LightLayer>& layers, double met) {
    if (layers.empty())
        return met < kLeastShare ? SeenAt::nothing : SeenAt::fog;
    return layers.front().share >= kPlaceShare ? SeenAt::place : SeenAt::choice;
}

}  // namespace

const SeenLayer* LayersUnder::heaviest() const {
    const auto found = std::ranges::max_element(layers, {}, &SeenLayer::share);
    return found == layers.end() ? nullptr : &*found;
}

LayersUnder layersUnder(const PreparedScene& scene, vec2 place) {
    const FlatScene& flat = scene.flat;
    const vec2 film(flat.camera.film);
    if (!(place.x >= 0 && place.y >= 0 && place.x < film.x && place.y < film.y))
        return {};
    if (flat.optics.model == FlatModel::absorption || flat.optics.model == FlatModel::emission)
        return {SeenAt::everyDepth};
    const Light light = lightAt(flat, place, kQuantiles);
    const std::vector<LightLayer> layers = takeable(light);
    LayersUnder under{.seen = seenAt(layers, light.met), .met = light.met, .direction = dvec3(light.segment.direction)};
    if (under.seen == SeenAt::fog)
        under.spreadMm = spreadOf(FirstEvents(flat, place));
    for (const LightLayer& layer : layers) {
        const double depth = depthOf(flat, light.segment, layer.alongMm);
        under.layers.push_back(
            {.placeMm = scene.volume->geometry().centreMm() + localPlace(flat.volume, light.segment, layer.alongMm),
             .depthMm = depth,
             .share = layer.share,
             .sigmaAlongMm = layer.sigmaMm,
             .sigmaAcrossMm = sigmaAcross(flat.camera, depth),
             .onSilhouette = false});
    }
    if (const SeenLayer* heaviest = under.heaviest()) {
        const auto around = depthsAround(flat, place, heaviest->depthMm);
        for (SeenLayer& layer : under.layers)
            markSilhouette(layer, around);
    }
    return under;
}

}  // namespace pdr
