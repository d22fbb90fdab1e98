#pragma once
/// What the smoothed view of a film is worth, and what it costs.

#include <optional>

#include "render/film/display.h"
#include "render/film/smoothing_judgement.h"

namespace pdr::bench {

/// The error of a picture against a converged one, over its tissue.
struct TrueError {
    double relative = 0;  ///< root mean square of the luminance over its mean, the reference's own noise taken off
    double levels = 0;    ///< that 95 % of the pixels do not exceed in any channel [display levels of 255]
};
/// Of `film` as it is shown with `display`. `reference`: of the same size, its samples independent of the film's.
TrueError trueError(const Film& film, const Display& display, const Film& reference);

struct Seconds {
    double wall = 0, processor = 0;
};
/// Medians of `rounds` rounds, in each of which all are made after one another.
struct Costs {
    Seconds raw, smoothed, judgement;
};
Costs costsOf(const Film& film, const Display& display, int rounds);

}  // namespace pdr::bench
