#include "render/film/likely_error.h"

#include <cmath>

#include "render/film/local_error.h"

namespace pdr {
namespace {

constexpr int kRadius = 10;

/// Of the real noise to the presumed one, at most 1.
denoise::Plane noiseShare(const ErrorPlanes& planes) {
    const auto share = [](float real, float presumed) {
        return presumed > 0 ? std::sqrt(std::min(real / presumed, 1.0f)) : 1;
    };
    return denoise::combined(share, denoise::boxed(planes.drawSquares, kRadius),
                             denoise::boxed(planes.lightSquares, kRadius));
}

}  // namespace

denoise::Colours likelyErrors(const Film& film, const Tile& part) {
    const ErrorPlanes planes = errorPlanesAround(film, part, kRadius);
    const denoise::Plane share = noiseShare(planes);
    const denoise::Colours most = localErrors(planes);
    const auto channel = [&](int c) {
        const auto likely = [](float error, float times) { return std::isinf(error) ? error : error * times; };
        return cropped(denoise::combined(likely, most[c], share), planes.area, part);
    };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace pdr
