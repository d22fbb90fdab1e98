#include "render/prepare/light_layers.h"

#include <algorithm>
#include <optional>

namespace pdr {

namespace {

constexpr double kWindowMm = 2, kWindowVoxels = 1.5;
constexpr double kApartMm = 3;
constexpr double kFaintest = 0.1;
constexpr double kNearMm = 1;

/// A stretch of the ray that begins and ends with a quantile [mm].
struct Stretch {
    double first, last;
};

/// Returns the stretch of at most `window` that holds the most of the ascending `distances`; the nearest of equals.
Stretch densest(const std::vector<double>& distances, double window) {
    Stretch best{distances.front(), distances.front()};
    std::size_t most = 0, end = 0;
    for (std::size_t begin = 0; begin < distances.size(); ++begin) {
        while (end < distances.size() && distances[end] - distances[begin] <= window)
            ++end;
        if (end - begin > most) {
            most = end - begin;
            best = {distances[begin], distances[end - 1]};
        }
    }
    return best;
}

/// Returns the layer of length `window` about the middle of `stretch`; none if it holds less than kFaintest.
std::optional<LightLayer> layerAbout(const FirstEvents& events, const Stretch& stretch, double window) {
    const double middle = (stretch.first + stretch.last) / 2;
    const double before = events.metBefore(middle - window / 2);
    const double share = events.metBefore(middle + window / 2) - before;
    if (share < kFaintest)
        return std::nullopt;
    const auto at = [&](double part) { return events.where(before + part * share); };
    const double median = at(0.5);
    return LightLayer{.alongMm = median,
                      .sigmaMm = (at(0.84) - at(0.16)) / 2,
                      .share = share,
                      .nearShare = events.metBefore(median + kNearMm) - events.metBefore(median - kNearMm)};
}

}  // namespace

double spacingAlong(const Ray& ray) {
    return 1 / glm::length(dvec3(ray.direction));
}

double layerWindowMm(const Ray& ray) {
    return std::max(kWindowMm, kWindowVoxels * spacingAlong(ray));
}

/// The quantiles only find the layers: how much light these hold is computed from F, without the grain of the
/// quantiles.
std::vector<LightLayer> lightLayers(const FirstEvents& events, int quantiles) {
    std::vector<double> distances = events.quantiles(quantiles);
    const double window = layerWindowMm(events.segment().ray), apart = std::max(kApartMm, window);
    std::vector<LightLayer> layers;
    while (!distances.empty()) {
        const Stretch stretch = densest(distances, window);
        const std::optional<LightLayer> layer = layerAbout(events, stretch, window);
        if (!layer)
            break;
        layers.push_back(*layer);
        std::erase_if(distances, [&](double mm) { return mm > stretch.first - apart && mm < stretch.last + apart; });
    }
    std::ranges::stable_sort(layers, std::ranges::greater(), &LightLayer::share);
    return layers;
}

}  // namespace pdr
