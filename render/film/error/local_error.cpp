#include "render/film/error/local_error.h"

#include <cmath>
#include <limits>

#include "render/film/status_sums.h"

namespace pdr {
namespace {

constexpr float kPixels = (2 * kLocalRadius + 1) * (2 * kLocalRadius + 1);
constexpr float kUnknown = std::numeric_limits<float>::infinity();

/// Returns 1 where the light is known well enough to state its error, else infinite.
denoise::Plane known(const ErrorPlanes& planes) {
    return denoise::combined(
        [](float mean, float square, float met) {
            const bool unlit = met > 0 && mean == 0;  // tissue whose samples may only have been unlucky
            return unlit || isRareLight(double(mean), std::sqrt(double(square) / kPixels)) ? kUnknown : 1;
        },
        denoise::boxed(planes.light, kLocalRadius), denoise::boxed(planes.lightSquares, kLocalRadius), planes.tissue);
}

}  // namespace

denoise::Colours localErrors(const Film& film) {
    return localErrors(errorPlanesAround(film, wholeImage(film.size()), kLocalRadius));
}

denoise::Colours localErrors(const ErrorPlanes& planes) {
    const denoise::Plane factor = known(planes);
    const auto channel = [&](int c) {
        const denoise::Plane& own = planes.squares[c];
        return denoise::combined(
            [](float mine, float around, float times) {
                return times == kUnknown ? kUnknown : std::sqrt(std::max(mine, around));
            },
            own, denoise::boxed(own, kLocalRadius), factor);
    };
    return {channel(0), channel(1), channel(2)};
}

}  // namespace pdr
