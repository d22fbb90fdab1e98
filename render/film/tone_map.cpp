#include "render/film/tone_map.h"

#include <tbb/parallel_for.h>

#include <cmath>

#include "render/film/levels.h"

namespace pdr {
namespace {

/// Linear light of an sRGB value, both in [0, 1]. IEC 61966-2-1.
double linearFromSrgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

/// The curve is inverted once, where it rounds, so that a pixel costs a search instead of an exponential and a power,
/// and the levels are exact.
Thresholds makeThresholds() {
    Thresholds thresholds{};
    for (int k = 0; k < kThresholds; ++k)
        thresholds[k] = -std::log1p(-linearFromSrgb((k + 0.5) / 255.0));
    return thresholds;
}

}  // namespace

const Thresholds& displayThresholds() {
    static const Thresholds thresholds = makeThresholds();
    return thresholds;
}

std::uint8_t displayLevel(double radiance, const Display& display) {
    return levelOf(displayThresholds().data(), radiance, display.exposure);
}

std::vector<std::uint8_t> toneMap(const Film& film, const Display& display) {
    const ivec2 size = film.size();
    const double* thresholds = displayThresholds().data();
    std::vector<std::uint8_t> rgba(std::size_t(size.x) * std::size_t(size.y) * 4);
    tbb::parallel_for(0, size.y, [&](int y) {
        std::uint8_t* out = &rgba[std::size_t(y) * std::size_t(size.x) * 4];
        for (int x = 0; x < size.x; ++x, out += 4) {
            const dvec3 mean = film.pixel(x, y).mean;
            for (int channel = 0; channel < 3; ++channel)
                out[channel] = levelOf(thresholds, mean[channel], display.exposure);
            out[3] = 255;
        }
    });
    return rgba;
}

}  // namespace pdr
