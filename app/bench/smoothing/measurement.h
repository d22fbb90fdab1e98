#pragma once
/// What the smoothed view of a film is worth, and what it costs.

#include <optional>

#include "render/accuracy/true_error.h"
#include "render/film/display.h"
#include "render/film/error/smoothing_judgement.h"

namespace pdr::bench {

struct Seconds {
    double wall = 0, processor = 0;
};
/// Medians of `rounds` rounds, in each of which all are made after one another.
struct Costs {
    Seconds raw, smoothed, judgement;
};
Costs costsOf(const Film& film, const Display& display, int rounds);

}  // namespace pdr::bench
