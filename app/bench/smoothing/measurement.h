#pragma once
/// Time to make the raw and the denoised image of a film, and the judgement of the denoised one.

#include <optional>

#include "render/accuracy/true_error.h"
#include "render/film/display.h"
#include "render/film/error/smoothing_judgement.h"

namespace pdr::bench {

struct Seconds {
    double wall = 0, processor = 0;
};
/// Medians of `rounds` rounds, in each of which all are made one after the other.
struct Costs {
    Seconds raw, denoised, judgement;
};
Costs costsOf(const Film& film, const Display& display, int rounds);

}  // namespace pdr::bench
