#pragma once
/// How far a picture is from a converged one, when there is one: what all that is stated without it is held against.

#include "render/film/display.h"
#include "render/film/film.h"

namespace pdr {

/// Of a picture's tissue.
struct TrueError {
    double relative = 0;  ///< root mean square of the luminance over its mean, the reference's own noise taken off
    double levels = 0;    ///< that 95 % of the pixels do not exceed in any channel [display levels of 255]
};

/// Of `film` as it is shown with `display`. `reference`: of the same size, its samples independent of the film's.
TrueError trueError(const Film& film, const Display& display, const Film& reference);

}  // namespace pdr
