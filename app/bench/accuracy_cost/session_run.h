#pragma once
/// A picture that a session makes as it makes them for a window, and what it took beside its samples.

#include <cstdint>
#include <vector>

#include "render/base/result.h"
#include "render/film/display.h"
#include "render/scene/scene.h"

namespace pdr::bench {

/// What is asked of a session beside the picture, each with all that stands before it.
enum class Beside {
    nothing,    ///< samples and bytes for the screen
    status,     ///< errors, history, forecast, bias: the sentence in the foot of the window
    judgement,  ///< of the smoothed picture: what is always on
    errorMap,   ///< always on, and the map
    ledger,     ///< always on, and what effects cost
    lattice     ///< always on, of a march, whose bias is measured
};

struct RunPlan {
    Scene scene;
    float exposure = 1;
    std::vector<std::uint64_t> samples;  ///< at which it is looked at, ascending
    int iterations = 1;                  ///< of a displayed frame
    int threads = 0;                     ///< of the CPU; 0: one per core
};

/// Since the first full picture, processor time [s].
struct RunCost {
    std::uint64_t samples = 0;
    double sampling = 0;
    double rest = 0;     ///< of the whole program
    double lattice = 0;  ///< of that, what measures the bias
};

/// At each of plan.samples. Errors: those that the session tells.
Result<std::vector<RunCost>> runSession(const RunPlan& plan, Beside beside);

}  // namespace pdr::bench
