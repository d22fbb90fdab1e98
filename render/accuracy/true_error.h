#pragma once
/// Measures how far an image is from a converged one, if there is one, to check all errors that are stated without it.

#include "render/film/display.h"
#include "render/film/film.h"

namespace pdr {

/// Error of an image's tissue.
struct TrueError {
    double relative = 0;  ///< root mean square error of the luminance over its mean, without the reference's own noise
    double levels = 0;    ///< error that 95 % of the pixels do not exceed in any channel [display levels of 255]
};

/// Returns the error of `film` as shown with `display`. `reference` must have the same size, and samples that are
/// independent of the film's.
TrueError trueError(const Film& film, const Display& display, const Film& reference);

}  // namespace pdr
