#pragma once
/// A film as input of the filters in denoise/, and its denoised radiance.

#include "render/denoise/smoothing.h"
#include "render/film/film.h"

namespace pdr {

/// Planes of the film's size, in units of `unit`.
struct NoisyFilm {
    /// Estimates from some of the samples of each pixel.
    struct Part {
        denoise::Colours mean;
        denoise::Plane variance;  ///< variance of the mean's luminance if all samples were independent
    };

    /// The radiance that is 1 in the planes: a power of two near the film's mean luminance, so that brightness changes
    /// no bit.
    double unit = 1;
    Part all, even, odd;
    denoise::Plane ratio;  ///< real variance over the presumed one
};

/// Returns the planes of `film`. Below 2 samples there are no halves: then `even` and `odd` equal `all`, and the
/// variance is estimated from the neighbours. Worthless after a stop request.
NoisyFilm noisyFilm(const Film& film, const std::stop_token& stop = {});

/// Returns the denoised radiance of all samples, in units of `noisy.unit`; the denoised view shows it. Worthless after
/// a stop request. `features`: see denoise::denoised().
denoise::Colours smoothRadiance(const NoisyFilm& noisy, const std::stop_token& stop = {},
                                const denoise::Features* features = nullptr);

/// Returns the memory that this thread keeps for planes to the system, so that nothing is left of an image that is
/// closed.
void dropNoisyFilms();

}  // namespace pdr
