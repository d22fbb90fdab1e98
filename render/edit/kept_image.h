#pragma once
/// The image of a scene before an edit, kept for the images after it.

#include <cstdint>
#include <memory>

#include "render/edit/first_samples.h"
#include "render/film/error/smoothing_judgement.h"

namespace pdr {

/// Radiance.
struct KeptImage {
    std::uint64_t samples = 0;  ///< samples that every pixel has; at least 2
    SmoothHalves halves;        ///< its denoised halves
    denoise::Colours all;       ///< their mean
    FirstSamples first;

    /// Returns the memory that it takes without the first samples, which the film's owner has, too.
    std::size_t bytes() const {
        return denoise::bytesOf(all) + denoise::bytesOf(halves.even) + denoise::bytesOf(halves.odd);
    }
};

/// Returns the image of `noisy`, a film with `samples` samples in every pixel, whose first ones are `first` and whose
/// halves are `denoised`, as denoisedHalves() returns them.
std::shared_ptr<const KeptImage> keptImage(const NoisyFilm& noisy, const SmoothHalves& denoised, std::uint64_t samples,
                                           const FirstSamples& first);

}  // namespace pdr
