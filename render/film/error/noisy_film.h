#pragma once
/// A film as the filters of denoise/ read it, and what they make of it.

#include "render/denoise/smoothing.h"
#include "render/film/film.h"

namespace pdr {

/// Planes of the film's size, in units of `unit`.
struct NoisyFilm {
    /// Some of the samples of each pixel.
    struct Part {
        denoise::Colours mean;
        denoise::Plane variance;  ///< of its luminance, if all samples were independent
    };

    double unit = 1;  ///< radiance; a power of two near the film's mean luminance, so that brightness changes no bit
    Part all, even, odd;
    denoise::Plane ratio;  ///< of the real noise to the presumed one
};

/// Below 2 samples there are no halves: then `even` and `odd` are all, and the variance is that of the neighbours.
/// Worthless after a stop request.
NoisyFilm noisyFilm(const Film& film, const std::stop_token& stop = {});

/// The radiance of all samples without its noise, in units of `noisy.unit`: what the smoothed view shows. Worthless
/// after a stop request.
denoise::Colours smoothRadiance(const NoisyFilm& noisy, const std::stop_token& stop = {});

}  // namespace pdr
