#include "render/film/display/exposure.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/film/levels.h"
#include "render/film/moments.h"

namespace pdr {
namespace {

constexpr int kDarkest = 50, kBrightest = 150, kWhite = 245;  ///< display levels

/// Returns the radiance, in units of the exposure, from which `level` is shown.
double fractionOf(int level) {
    return displayThresholds()[std::size_t(level - 1)];
}

/// Returns the luminances of the film's tissue pixels, in units of the exposure, ascending.
std::vector<double> tissueLuminances(const Film& film, double exposure) {
    std::vector<double> luminances;
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x)
            if (const PixelEstimate pixel = film.pixel(x, y); pixel.tissue)
                luminances.push_back(luminance(pixel.mean) / exposure);
    std::ranges::sort(luminances);
    return luminances;
}

}  // namespace

double stopsFor(const Film& film, double exposure) {
    const std::vector<double> tissue = tissueLuminances(film, exposure);
    if (tissue.empty() || !(tissue[tissue.size() / 2] > 0))
        return 0;
    const double median = tissue[tissue.size() / 2], bright = tissue[tissue.size() * 98 / 100];
    const double least = fractionOf(kDarkest) / median, most = fractionOf(kBrightest) / median;
    const double factor = std::clamp(std::min(1.0, fractionOf(kWhite) / bright), least, most);
    return std::clamp(std::round(std::log2(factor) * 10) / 10, -4.0, 4.0) + 0.0;  // no -0
}

}  // namespace pdr
