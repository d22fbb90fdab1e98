#pragma once
/// Estimates by how much two images differ, separated from their noise. The difference of two noisy images is never
/// zero. But each image consists of two independent halves of samples, and the differences of both halves agree only by
/// chance if there is no difference.
///   levels   of a display of 255, through the tone curve, each channel
///   subject  the pixels in which either image shows something, tissue or light: empty background around the anatomy
///            changes nothing

#include <span>

#include "render/accuracy/forecast.h"
#include "render/film/display.h"
#include "render/film/film.h"

namespace pdr {

struct ImageChange {
    Foretold mean;         ///< mean of |difference| [levels]
    Foretold ninetyFifth;  ///< value that 95 % of the differences do not exceed [levels]
};

/// Differences of a pixel's channels according to either half of the samples [levels].
struct HalfDifferences {
    vec3 even{0.0f}, odd{0.0f};
};

/// Estimates the change from pixels whose halves are independent and equally noisy. Both intervals hold the truth in at
/// least 95 of 100 cases. The values in between are those of a distribution with the mean and variance on which the
/// halves agree, and the shape that is observed (Louis 1984, "Estimating a population of parameter values using Bayes
/// and empirical Bayes methods").
ImageChange changeOf(std::span<const HalfDifferences> pixels);

/// Estimates the change between two images as `display` shows them without denoising. Both films have the same size and
/// as many samples; if they use the same random numbers, little noise is left. Without pixels: no change.
ImageChange imageChange(const Film& with, const Film& without, const Display& display);

}  // namespace pdr
