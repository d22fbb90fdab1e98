#include "render/film/local_error.h"

#include <cmath>
#include <limits>

#include "render/film/status_sums.h"

namespace pdr {
namespace {

constexpr int kRadius = 2;
constexpr float kPixels = (2 * kRadius + 1) * (2 * kRadius + 1);
constexpr float kUnknown = std::numeric_limits<float>::infinity();

/// plane(pixel) of all pixels.
template <class Value>
denoise::Plane planeOf(const Film& film, const Value& value) {
    denoise::Plane plane(film.size());
    denoise::eachBand(film.size().y, {}, [&](int begin, int end) {
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < film.size().x; ++x)
                plane.row(y)[x] = float(value(film.pixel(x, y)));
    });
    plane.mirror();
    return plane;
}

/// 1 where the light is known well enough to say how well, else infinite.
denoise::Plane known(const Film& film) {
    const auto light = planeOf(film, [](const PixelEstimate& pixel) { return luminance(pixel.mean); });
    const auto squares = planeOf(film, [](const PixelEstimate& pixel) {
        return pixel.count < 2 ? double(kUnknown) : std::pow(luminance(pixel.standardError), 2);
    });
    const auto tissue = planeOf(film, [](const PixelEstimate& pixel) { return pixel.tissue; });
    return denoise::combined(
        [](float mean, float square, float met) {
            const bool unlit = met > 0 && mean == 0;  // tissue, which may only be unlucky
            return unlit || isRareLight(double(mean), std::sqrt(double(square) / kPixels)) ? kUnknown : 1;
        },
        denoise::boxed(light, kRadius), denoise::boxed(squares, kRadius), tissue);
}

}  // namespace

denoise::Colours localErrors(const Film& film) {
    const denoise::Plane factor = known(film);
    const auto channel = [&](int c) {
        const auto own =
            planeOf(film, [c](const PixelEstimate& pixel) { return pixel.standardError[c] * pixel.standardError[c]; });
        return denoise::combined(
            [](float mine, float around, float times) {
                return times == kUnknown ? kUnknown : std::sqrt(std::max(mine, around));
            },
            own, denoise::boxed(own, kRadius), factor);
    };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace pdr
