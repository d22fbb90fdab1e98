#pragma once
/// Films whose error is known in closed form, and the status that a screen gets for them.

#include <cmath>
#include <vector>

#include "render/device/emulated/emulated_gpu.h"
#include "render/film/display/tone_map.h"
#include "render/kernel/pixel.h"

namespace pdr::test {

inline std::size_t pixelsOf(const Film& film) {
    return std::size_t(film.size().x) * std::size_t(film.size().y);
}

/// Continues a film to `count` samples of radiance value(pixel, sample); seen(pixel) returns kSeen... flags.
template <class Value, class Seen>
void grow(Film& film, std::uint64_t count, Value&& value, Seen&& seen) {
    const Tile whole = wholeImage(film.size());
    while (film.samplesPerPixel() < count) {
        const SampleRange range =
            film.nextSamples(std::uint32_t(std::min<std::uint64_t>(64, count - film.samplesPerPixel())));
        for (std::size_t pixel = 0; pixel < pixelsOf(film); ++pixel) {
            PixelSums& sums = film.sums(whole).pixels[pixel];
            sums.seen |= seen(pixel);
            for (std::uint32_t i = 0; i < range.count; ++i)
                addSample(sums, vec3(float(value(pixel, range.first + i))), range.first + i);
        }
        film.commit(range);
    }
}

/// A pixel of a film with n samples, n even: the mean of the even samples is mean + off and the mean of the odd samples
/// is mean - off, so that `off` is the draw of the error; `spread` is the standard deviation of the samples. Nothing is
/// random.
struct Known {
    double mean, off, spread = off;
    std::uint32_t seen = kSeenTissue | kSeenChance;
};
inline Film knownFilm(const std::vector<Known>& pixels, std::uint32_t n) {
    FilmContent content = Film(ivec2(int(pixels.size()), 1), 1).content();
    content.progress.advance(content.progress.area(), n);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const auto& [mean, off, spread, seen] = pixels[i];
        content.moments[i] = {dvec3(mean), dvec3(n * spread * spread), n, vec3(float(mean + off)), n / 2};
        content.block[i].seen = seen;
    }
    return Film(1, std::move(content));
}

/// Returns the status that a screen gets, from the CPU and from a GPU's programs; an empty status if they disagree.
inline FilmStatus shownStatus(const Film& film, const Tone& tone) {
    const Display display{.exposure = tone.exposure, .curve = tone.curve};
    const FilmStatus cpu = imageOf(film, display).status;
    const auto device = makeEmulatedGpu();
    const auto live = *device->film(film.size(), 1, {});
    if (!live->resume(film) || !live->resolve(display))
        return {};
    const Result<Image> image = live->readback();
    if (!image || image->status.displayError != cpu.displayError || image->status.tissuePixels != cpu.tissuePixels ||
        image->status.fewBrightSamples != cpu.fewBrightSamples || image->status.unseenShare != cpu.unseenShare ||
        !(std::fabs(image->status.relativeError - cpu.relativeError) <= 1e-12 * cpu.relativeError ||
          image->status.relativeError == cpu.relativeError))
        return {};
    return cpu;
}

/// The tone curve, implemented a second time and unrounded.
inline double curve(double radiance, double exposure) {
    const double light = -std::expm1(-std::max(radiance, 0.0) / exposure);
    return 255 * (light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1 / 2.4) - 0.055);
}

/// Returns the draw of a pixel's error with which the screen is `levels` off: downwards, where an error spans more
/// levels.
inline double drawFor(double levels, double mean, double exposure) {
    double low = 0, high = mean;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (curve(mean, exposure) - curve(mean - middle, exposure) < levels ? low : high) = middle;
    }
    return -high;
}

}  // namespace pdr::test
