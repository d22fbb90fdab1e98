#include "render/edit/edited_image.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/edit/mixture.h"

namespace pdr {
namespace {

using denoise::Colours;
using denoise::combined;
using denoise::Plane;

/// The greatest factor by which light changes as a quotient; what is beyond is added as smooth light, since where the
/// old image was dark, nothing sharp is known.
constexpr float kMostFactor = 4;
/// Part of the mean luminance below which light is too little to form a quotient.
constexpr float kDimPart = 0.02f;
/// Most samples of which the fresh image is not denoised, which takes too long for the first image of an edit.
constexpr std::uint64_t kFirstImage = 1;

/// Pixels of a half of the first sample that share their noise: a sample counts for its own pixel and for a quarter of
/// each around it, by which the variance of a sum of pixels is 2 of a sample's, and their mean variance 5 / 8.
constexpr float kChessboardAlike = 3.2f;

/// Returns the radius of the box that smooths images of `mark` samples, twice: 1, 4, 16, 64.
int radiusOf(std::uint64_t mark) {
    return mark <= 1 ? 5 : mark <= 4 ? 3 : mark <= 16 ? 2 : 1;
}

template <class F, class... All>
Colours eachChannel(const F& f, const All&... all) {
    return {combined(f, all[0]...), combined(f, all[1]...), combined(f, all[2]...)};
}

Colours scaled(const Colours& colours, float factor) {
    return eachChannel([factor](float value) { return factor * value; }, colours);
}

/// Returns the image smoothed by a box, twice: nearly a Gaussian of standard deviation sqrt(2 / 3 * r * (r + 1)).
Colours smoothed(const Colours& image, int radius) {
    Colours out;
    for (std::size_t c = 0; c < 3; ++c)
        out[c] = denoise::boxed(denoise::boxed(image[c], radius), radius);
    return out;
}

HalfImages smoothed(const HalfImages& halves, int radius) {
    return {smoothed(halves.even, radius), smoothed(halves.odd, radius)};
}

/// Returns `old` with the change from `before` to `after`.
Colours laidOn(const Colours& old, const Colours& before, const Colours& after, float dim) {
    const auto change = [dim](float light, float was, float is) {
        const float factor = std::clamp((is + dim) / (was + dim), 1 / kMostFactor, kMostFactor);
        return std::max(factor * light + (is - factor * was), 0.0f);
    };
    return eachChannel(change, old, before, after);
}

float meanOf(const Plane& plane) {
    double sum = 0;
    for (int y = 0; y < plane.size().y; ++y)
        for (int x = 0; x < plane.size().x; ++x)
            sum += plane.row(y)[x];
    return float(sum / (double(plane.size().x) * plane.size().y));
}

}  // namespace

std::shared_ptr<const KeptImage> keptImage(const NoisyFilm& noisy, const SmoothHalves& denoised, std::uint64_t samples,
                                           const FirstSamples& first) {
    const auto unit = float(noisy.unit);
    const SmoothHalves halves{scaled(denoised.even, unit), scaled(denoised.odd, unit)};
    return std::make_shared<const KeptImage>(KeptImage{samples, halves, first});
}

/// The laid image, and its two halves.
struct EditedImage::Laid {
    Colours all;
    SmoothHalves halves;
    std::shared_ptr<const HalfImages> samples;  ///< the new image after the mark's samples
    HalfImages fresh;                           ///< `samples`, smoothed
    float dim;
};

/// Lays the change after `mark` samples on the old image, once for all images until the next mark. A half of the old
/// image knows nothing of the numbers of the other half. The first sample of all is an even one, so that the old
/// image's odd half knows neither colour of the chessboard.
const EditedImage::Laid& EditedImage::lay(const FirstSamples& first, std::uint64_t mark) {
    const std::shared_ptr<const HalfImages> samples = first.at(mark);
    if (laid_ && laid_->samples == samples)
        return *laid_;
    const HalfImages before = smoothed(*old_->first.at(mark), radiusOf(mark));
    const SmoothHalves& old = old_->halves;
    const Colours all = meanOf(old.even, old.odd);
    Laid laid{{}, {}, samples, smoothed(*samples, radiusOf(mark)), kDimPart * meanOf(denoise::luminance(all))};
    laid.all = laidOn(all, meanOf(before.even, before.odd), meanOf(laid.fresh.even, laid.fresh.odd), laid.dim);
    laid.halves.even = laidOn(mark > 1 ? old.even : old.odd, before.even, laid.fresh.even, laid.dim);
    laid.halves.odd = laidOn(old.odd, before.odd, laid.fresh.odd, laid.dim);
    laid_ = std::make_shared<const Laid>(std::move(laid));
    return *laid_;
}

Colours EditedImage::radiance(const Film& film, const FirstSamples& first, const std::stop_token& stop) {
    const std::uint64_t samples = film.samplesPerPixel(), mark = lastMark(first, samples);
    const Laid& laid = lay(first, mark);
    const Plane share = share_.size().x > 0
                            ? share_
                            : shareOfSecond(laid.halves, {laid.fresh.even, laid.fresh.odd}, laid.samples->even,
                                            laid.samples->odd, laid.dim, mark > 1 ? 1 : kChessboardAlike);
    if (samples <= kFirstImage)
        return mixed(share, laid.all, meanOf(laid.fresh.even, laid.fresh.odd));
    const NoisyFilm noisy = noisyFilm(film, stop);
    if (stop.stop_requested())
        return laid.all;  // the noisy film lacks planes
    return mixed(share, laid.all, scaled(smoothRadiance(noisy, stop), float(noisy.unit)));
}

SmoothHalves EditedImage::halves(const NoisyFilm& noisy, const SmoothHalves& denoised, std::uint64_t samples,
                                 const FirstSamples& first) {
    const auto unit = float(noisy.unit);
    const Laid& laid = lay(first, lastMark(first, samples));
    const SmoothHalves mine{scaled(laid.halves.even, 1 / unit), scaled(laid.halves.odd, 1 / unit)};
    share_ = shareOfSecond(mine, denoised, noisy.even.mean, noisy.odd.mean, laid.dim / unit);
    return {mixed(share_, mine.even, denoised.even), mixed(share_, mine.odd, denoised.odd)};
}

}  // namespace pdr
