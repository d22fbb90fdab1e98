#pragma once
/// By how much two pictures differ, told apart from their noise. The difference of two noisy pictures is never nothing;
/// but each is made of two independent halves of samples, and the differences of both halves agree by chance only where
/// there is none.
///   levels   of a display of 255, through the tone curve, each channel
///   subject  the pixels in which either picture shows something, tissue or light: empty ground around the anatomy
///            changes nothing

#include <span>

#include "render/accuracy/forecast.h"
#include "render/film/display.h"
#include "render/film/film.h"

namespace pdr {

struct PictureChange {
    Foretold mean;         ///< of |difference| [levels]
    Foretold ninetyFifth;  ///< that 95 % of the differences do not exceed [levels]
};

/// What a pixel's channels differ by, as either half of the samples says [levels].
struct HalfDifferences {
    vec3 even{0.0f}, odd{0.0f};
};

/// Of pixels whose halves are independent and equally noisy. Both intervals hold the truth in at least 95 of 100 cases;
/// the values between are those of a distribution with the mean and variance that the halves agree on, and the shape
/// that is seen (Louis 1984, "Estimating a population of parameter values using Bayes and empirical Bayes methods").
PictureChange changeOf(std::span<const HalfDifferences> pixels);

/// Of pictures as `display` shows them without smoothing. Both films have the same size and as many samples;
/// where these are made of the same random numbers, little noise is left. Without pixels: no change.
PictureChange pictureChange(const Film& with, const Film& without, const Display& display);

}  // namespace pdr
