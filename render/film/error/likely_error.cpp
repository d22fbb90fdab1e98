#include "render/film/error/likely_error.h"

#include <cmath>

#include "render/film/error/local_error.h"

namespace pdr {
namespace {

constexpr int kRadius = 6;

/// Returns the ratio of the real noise to the presumed one, at most 1. The presumed noise is the geometric mean of the
/// pixels' own errors and of the bound that localErrors() makes of them: the bound alone would give errors that are too
/// large, since the greater of two is taken, the pixels' own alone errors that are too small, since a few lucky draws
/// count as little noise. 1 where a pixel around has less than two samples, which show no noise.
denoise::Plane noiseShare(const ErrorPlanes& planes) {
    const auto greater = [](float own, float around) { return std::max(own, around); };
    const denoise::Plane most =
        denoise::combined(greater, planes.lightSquares, denoise::boxed(planes.lightSquares, kLocalRadius));
    const auto share = [](float real, float own, float most) {
        const float presumed = std::sqrt(own) * std::sqrt(most);
        return presumed > 0 && std::isfinite(presumed) ? std::sqrt(std::min(real / presumed, 1.0f)) : 1;
    };
    return denoise::combined(share, denoise::boxed(planes.drawSquares, kRadius),
                             denoise::boxed(planes.lightSquares, kRadius), denoise::boxed(most, kRadius));
}

denoise::Colours errorsIn(const Tile& part, const ErrorPlanes& planes) {
    const denoise::Plane share = noiseShare(planes);
    const denoise::Colours most = localErrors(planes);
    const auto channel = [&](int c) {
        const auto likely = [](float error, float times) { return std::isinf(error) ? error : error * times; };
        return cropped(denoise::combined(likely, most[c], share), planes.area, part);
    };
    return {channel(0), channel(1), channel(2)};
}

/// The squared sum of three draws of variance 1 is 3 + 6 times their correlation on average, the sum of their squares
/// is 3. Draws that cancel each other count as independent ones.
denoise::Plane correlationIn(const Tile& part, const ErrorPlanes& planes) {
    const auto of = [](float joint, float own) { return own > 0 ? glm::clamp((joint / own - 1) / 2, 0.0f, 1.0f) : 1; };
    return cropped(
        denoise::combined(of, denoise::boxed(planes.jointDraws, kRadius), denoise::boxed(planes.ownDraws, kRadius)),
        planes.area, part);
}

}  // namespace

denoise::Colours likelyErrors(const Film& film, const Tile& part) {
    return errorsIn(part, errorPlanesAround(film, part, kRadius + kLocalRadius));
}

LikelyErrors likelyErrorsAndCorrelation(const Film& film, const Tile& part) {
    const ErrorPlanes planes = errorPlanesAround(film, part, kRadius + kLocalRadius);
    return {errorsIn(part, planes), correlationIn(part, planes)};
}

}  // namespace pdr
