#include "render/film/display/tone_map.h"

#include <cmath>
#include <utility>

#include "render/base/srgb.h"
#include "render/film/display_transform.h"
#include "render/film/error/noisy_film.h"

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

}  // namespace

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
    return [transform = displayTransform(display), bytes = rgba.data()](std::size_t pixel, const Moments& known) {
        std::uint8_t* out = bytes + pixel * 4;
        transform.setLevels(known.mean, out);
        out[3] = 255;
    };
}

/// Computes the image in one pass with the status, since both are limited by reading the film's memory.
Image rawImageOf(const Film& film, const Display& display) {
    if (!display.surveyed)
        return {toneMap(film, display), film.counts(), false, false};
    Image image{emptyBytes(film.size()), {}};
    image.status = film.status(display, rawBytes(image.rgba, display));
    return image;
}

}  // namespace

Image denoisedImageOf(const Film& film, const denoise::Colours& smooth, double unit, const Display& display) {
    const ivec2 size = smooth[0].size();
    Image image{std::vector<std::uint8_t>(std::size_t(size.x) * std::size_t(size.y) * 4, 255),
                display.surveyed ? film.status(display) : film.counts(), true, display.surveyed};
    const DisplayTransform transform = displayTransform(display);
    denoise::eachBand(size.y, {}, [&](int begin, int end) {
        std::uint8_t* out = &image.rgba[std::size_t(begin) * std::size_t(size.x) * 4];
        for (int y = begin; y < end; ++y)
            for (int x = 0; x < size.x; ++x, out += 4)
                transform.setLevels(unit * dvec3(smooth[0].row(y)[x], smooth[1].row(y)[x], smooth[2].row(y)[x]), out);
    });
    return image;
}

Image imageOf(const Film& film, const Display& display, const std::stop_token& stop) {
    return Development().image(film, display, stop);
}

Image Development::image(const Film& film, const Display& display, const std::stop_token& stop) {
    if (!display.denoised)
        return rawImageOf(film, display);
    if (!denoised_ || !denoised_->shows(film, display)) {
        const NoisyFilm noisy = noisyFilm(film, stop);
        if (stop.stop_requested())
            return {};
        denoise::Colours radiance = smoothRadiance(noisy, stop);
        if (stop.stop_requested())
            return {};
        denoised_ = DenoisedFilm{film.revision(), film.progress(), noisy.unit, std::move(radiance), display};
    }
    denoised_->tone = display;
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
