#include "render/edit/edited_image.h"

#include <utility>

#include "render/edit/foretold.h"
#include "render/edit/light_change.h"
#include "render/edit/mixture.h"

namespace pdr {
namespace {

using denoise::Colours;
using denoise::Plane;

/// Most samples of which the fresh image is not denoised, which takes too long for the first image of an edit.
constexpr std::uint64_t kFirstImage = 1;

}  // namespace

/// The laid image, and its two halves.
struct EditedImage::Laid {
    Colours all;
    SmoothHalves halves;
    std::shared_ptr<const HalfImages> samples;           ///< the new image after the mark's samples
    std::shared_ptr<const denoise::Colours> unshadowed;  ///< light of the new scene's guide; null: none
    HalfImages fresh;                                    ///< `samples`, smoothed
    float dim;
};

/// Lays the change on the old image, as it is foretold and then what `mark` samples add to that, once for all images
/// until the next mark. A half of the old image knows nothing of the numbers of the other half. The first sample of all
/// is an even one, so that the old image's odd half knows neither colour of the chessboard.
const EditedImage::Laid& EditedImage::lay(const FirstSamples& first, std::uint64_t mark) {
    const std::shared_ptr<const HalfImages> samples = first.at(mark);
    if (laid_ && laid_->samples == samples && laid_->unshadowed == first.unshadowed())
        return *laid_;
    Laid laid{{}, {}, samples, first.unshadowed(), smoothed(*samples, mark), dimOf(old_->all)};
    const std::optional<Colours> gain = foretoldGain(old_->first, first);
    const HalfImages before = smoothedForChange(withGain(gain, *old_->first.at(mark)), mark),
                     after = smoothedForChange(*samples, mark);
    const SmoothHalves old{withGain(gain, mark > 1 ? old_->halves.even : old_->halves.odd),
                           withGain(gain, old_->halves.odd)};
    const LightChange even = changeBetween(before.even, after.even, laid.dim),
                      odd = changeBetween(before.odd, after.odd, laid.dim),
                      all = changeBetween(meanOf(before.even, before.odd), meanOf(after.even, after.odd), laid.dim);
    const Plane share = shareOfChange(old, {laidOn(old.even, even), laidOn(old.odd, odd)}, laid.dim);
    laid.all = laidOn(withGain(gain, old_->all), partOf(all, share));
    laid.halves = {laidOn(old.even, partOf(even, share)), laidOn(old.odd, partOf(odd, share))};
    laid_ = std::make_shared<const Laid>(std::move(laid));
    return *laid_;
}

Colours EditedImage::radiance(const Film& film, const FirstSamples& first, const std::stop_token& stop) {
    const std::uint64_t samples = film.samplesPerPixel(), mark = lastMark(first, samples);
    const Laid& laid = lay(first, mark);
    const Plane share = share_.size().x > 0
                            ? share_
                            : shareOfSecond(laid.halves, {laid.fresh.even, laid.fresh.odd}, laid.samples->even,
                                            laid.samples->odd, laid.dim, pixelsAlike(mark));
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
