#include "render/film/display/tone_map.h"

#include <cmath>
#include <utility>

#include "render/base/srgb.h"
#include "render/film/error/noisy_film.h"
#include "render/film/levels.h"
#include "render/film/tone_curve.h"

namespace pdr {
namespace {

/// Inverts the curve once, at the radiances where it rounds, so that a pixel costs a search instead of an exponential
/// and a power, and the levels are exact.
Thresholds makeThresholds() {
    Thresholds thresholds{};
    for (int k = 0; k < kThresholds; ++k)
        thresholds[k] = -std::log1p(-linearFromSrgb((k + 0.5) / 255.0));
    return thresholds;
}

std::array<float, kCurveEntries> makeCurve() {
    std::array<float, kCurveEntries> curve{};
    for (int i = 0; i < kCurveEntries; ++i) {
        const double octave = std::exp2(kCurveFrom + i / kCurvePerOctave);
        const double fraction = octave * (1 + double(i % kCurvePerOctave) / kCurvePerOctave);
        curve[i] = float(255 * srgbFromLinear(-std::expm1(-fraction)));
    }
    return curve;
}

/// Returns levelOf() without its search: the curve gives the level or its neighbour.
std::uint8_t levelNear(const double* thresholds, const float* curve, double radiance, double exposure) {
    if (!(radiance > 0))
        return 0;
    const double fraction = radiance / exposure;
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): the thresholds decide
    int level = int(exactLevelOf(curve, float(fraction)) + 0.5f);
    while (level < kThresholds && thresholds[level] <= fraction)
        ++level;
    while (level > 0 && thresholds[level - 1] > fraction)
        --level;
    return std::uint8_t(level);
}

}  // namespace

const float* displayCurve() {
    static const std::array<float, kCurveEntries> curve = makeCurve();
    return curve.data();
}

const Thresholds& displayThresholds() {
    static const Thresholds thresholds = makeThresholds();
    return thresholds;
}

std::uint8_t displayLevel(double radiance, const Display& display) {
    return levelOf(displayThresholds().data(), radiance, display.exposure);
}

namespace {

std::vector<std::uint8_t> emptyBytes(ivec2 size) {
    return std::vector<std::uint8_t>(std::size_t(size.x) * std::size_t(size.y) * 4);
}

/// Returns a look that sets the bytes of the pixels that it visits.
PixelLook rawBytes(std::vector<std::uint8_t>& rgba, const Display& display) {
    return [thresholds = displayThresholds().data(), curve = displayCurve(), exposure = double(display.exposure),
            bytes = rgba.data()](std::size_t pixel, const Moments& known) {
        std::uint8_t* out = bytes + pixel * 4;
        for (int channel = 0; channel < 3; ++channel)
            out[channel] = levelNear(thresholds, curve, known.mean[channel], exposure);
        out[3] = 255;
    };
}

/// Computes the image in one pass with the status, since both are limited by reading the film's memory.
Image rawImageOf(const Film& film, const Display& display) {
    if (!display.surveyed)
        return {toneMap(film, display), film.counts(), false, false};
    Image image{emptyBytes(film.size()), {}};
    image.status = film.status(display.exposure, rawBytes(image.rgba, display));
    return image;
}

}  // namespace

Image denoisedImageOf(const Film& film, const denoise::Colours& smooth, double unit, const Display& display) {
    const ivec2 size = smooth[0].size();
    Image image{std::vector<std::uint8_t>(std::size_t(size.x) * std::size_t(size.y) * 4, 255),
                display.surveyed ? film.status(display.exposure) : film.counts(), true, display.surveyed};
    denoise::eachBand(size.y, {}, [&](int begin, int end) {
        std::uint8_t* out = &image.rgba[std::size_t(begin) * std::size_t(size.x) * 4];
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < size.x; ++x, out += 4)
                for (int c = 0; c < 3; ++c)
                    out[c] = levelNear(displayThresholds().data(), displayCurve(), unit * smooth[c].row(y)[x],
                                       display.exposure);
    });
    return image;
}

Image imageOf(const Film& film, const Display& display, const std::stop_token& stop) {
    return Development().image(film, display, stop);
}

Image Development::image(const Film& film, const Display& display, const std::stop_token& stop) {
    if (!display.denoised)
        return rawImageOf(film, display);
    if (!denoised_ || !denoised_->shows(film, display.exposure)) {
        const NoisyFilm noisy = noisyFilm(film, stop);
        if (stop.stop_requested())
            return {};
        denoise::Colours radiance = smoothRadiance(noisy, stop);
        if (stop.stop_requested())
            return {};
        denoised_ = DenoisedFilm{film.revision(), film.progress(), noisy.unit, std::move(radiance), display.exposure};
    }
    denoised_->exposure = display.exposure;
    return denoisedImageOf(film, denoised_->radiance, denoised_->unit, display);
}

std::vector<std::uint8_t> toneMap(const Film& film, const Display& display) {
    if (display.denoised)
        return imageOf(film, display).rgba;
    std::vector<std::uint8_t> rgba = emptyBytes(film.size());
    film.each(rawBytes(rgba, display));
    return rgba;
}

}  // namespace pdr
