#include "render/accuracy/true_error.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/film/display_transform.h"
#include "render/film/error/noisy_film.h"

namespace pdr {
namespace {

/// Returns the linear radiance, row by row.
std::vector<dvec3> radianceOf(const Film& film, bool smooth) {
    std::vector<dvec3> radiance;
    const NoisyFilm noisy = noisyFilm(film);
    const denoise::Colours colours = smooth ? smoothRadiance(noisy) : noisy.all.mean;
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x)
            radiance.push_back(noisy.unit * dvec3(colours[0].row(y)[x], colours[1].row(y)[x], colours[2].row(y)[x]));
    return radiance;
}

}  // namespace

TrueError trueError(const Film& film, const Display& display, const Film& reference) {
    const std::vector<dvec3> radiance = radianceOf(film, display.denoised);
    const DisplayTransform transform = displayTransform(display);
    // Compare all tissue pixels
    double squares = 0, mean = 0;
    std::vector<float> levels;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        const PixelEstimate truth = reference.pixel(int(i) % film.size().x, int(i) / film.size().x);
        if (!truth.tissue)
            continue;
        const double off = luminance(radiance[i] - truth.mean);
        // The halves also give the noise of low-discrepancy points
        const double noise = luminance(truth.halves.even - truth.halves.odd) / 2;
        squares += off * off - noise * noise;
        mean += luminance(truth.mean);
        const vec3 apart = glm::abs(transform.exactLevels(radiance[i]) - transform.exactLevels(truth.mean));
        levels.push_back(std::max({apart.x, apart.y, apart.z}));
    }
    // Take the 95th percentile of the levels
    if (levels.empty())
        return {};
    const double count = double(levels.size());
    const auto quantile = levels.begin() + std::ptrdiff_t(0.95 * (count - 1));
    std::nth_element(levels.begin(), quantile, levels.end());
    return {std::sqrt(std::max(squares, 0.0) / count) / (mean / count), *quantile};
}

}  // namespace pdr
