#include "render/film/tone_map.h"

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

Picture pictureOf(const Film& film, const Display& display) {
    const double* thresholds = displayThresholds().data();
    Picture picture{std::vector<std::uint8_t>(std::size_t(film.size().x) * std::size_t(film.size().y) * 4), {}};
    // In one pass with the status: both wait for the film's memory.
    picture.status = film.status([&](std::size_t pixel, const Moments& known) {
        std::uint8_t* out = &picture.rgba[pixel * 4];
        for (int channel = 0; channel < 3; ++channel)
            out[channel] = levelOf(thresholds, known.mean[channel], display.exposure);
        out[3] = 255;
    });
    return picture;
}

std::vector<std::uint8_t> toneMap(const Film& film, const Display& display) {
    return pictureOf(film, display).rgba;
}

}  // namespace pdr
