#pragma once
/// The image of an edited scene from two films: that of the scene before, with many samples, and that of the scene now,
/// with few. The first samples of both were made with the same random numbers, so that the quotient of both, smoothed,
/// is the change with little noise; laid on the old image it gives the new one, as sharp as the old (a ratio estimator:
/// Heitz, Hill & McGuire 2018, "Combining analytic direct illumination and stochastic shadows"). Where that fails, the
/// new samples alone count: both images are mixed around each pixel in the proportion whose error is least, which each
/// half of the new samples tells of what the other made (stacked regression: Breiman 1996; control variates over an
/// image: Rousselle, Jarosz & Novak 2016).
///   laid     the old image with the change
///   fresh    the new samples alone, smoothed
///   marks    numbers of samples at which images are kept; see first_samples.h

#include <cstdint>
#include <memory>
#include <stop_token>
#include <utility>

#include "render/edit/kept_image.h"

namespace pdr {

class EditedImage {
  public:
    explicit EditedImage(std::shared_ptr<const KeptImage> old) : old_(std::move(old)) {}

    /// Returns the image of `film`, whose first samples are `first`; they share a mark with those of the old image.
    /// Units: radiance. Worthless after a stop request, but of the same size.
    denoise::Colours radiance(const Film& film, const FirstSamples& first, const std::stop_token& stop);
    /// Returns two such images, each made without the samples of one half of `noisy`, in its units; from now on
    /// radiance() mixes as they do. `noisy`: a film of `samples` samples, at least 4; `denoised`: its denoised halves.
    SmoothHalves halves(const NoisyFilm& noisy, const SmoothHalves& denoised, std::uint64_t samples,
                        const FirstSamples& first);
    /// Returns the last mark that both images have reached when the new one has `samples`; 0: none, so that the old
    /// image does not help.
    std::uint64_t lastMark(const FirstSamples& first, std::uint64_t samples) const {
        return old_->first.lastShared(first, samples);
    }
    const KeptImage& old() const { return *old_; }
    std::shared_ptr<const KeptImage> shareOld() const { return old_; }

  private:
    struct Laid;
    const Laid& lay(const FirstSamples& first, std::uint64_t mark);

    std::shared_ptr<const KeptImage> old_;
    std::shared_ptr<const Laid> laid_;  ///< what was laid last; null: nothing yet
    denoise::Plane share_;              ///< share of the fresh image at the last judgement; no pixels: none yet
};

}  // namespace pdr
