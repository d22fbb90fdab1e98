#pragma once
/// Run of a session that renders an image as for a window, and the processor time that it takes beside its samples.

#include <cstdint>
#include <vector>

#include "render/base/result.h"
#include "render/film/display.h"
#include "render/scene/scene.h"

namespace pdr::bench {

/// What a session does beside the image. Each of the first three includes those before it; each of the others adds to
/// `judgement`.
enum class Beside {
    nothing,      ///< samples and the bytes for the screen
    status,       ///< errors, history, forecast, bias: the sentence in the status bar
    judgement,    ///< the judgement of the denoised image: all that is always on
    errorMap,     ///< all that is always on, and the error map
    effectCosts,  ///< all that is always on, and the cost table of effects
    lattice       ///< all that is always on, for a march, whose bias is measured
};

struct RunPlan {
    Scene scene;
    float exposure = 1;
    std::vector<std::uint64_t> samples;  ///< samples per pixel at which costs are read, ascending
    int iterations = 1;                  ///< iterations per displayed frame
    int threads = 0;                     ///< CPU threads; 0: one per core
};

/// Processor time since the first full image [s].
struct RunCost {
    std::uint64_t samples = 0;
    double sampling = 0;
    double rest = 0;     ///< time of the whole program beside the samples
    double lattice = 0;  ///< part of `rest` that measures the bias
};

/// Runs a session and returns its costs at each of plan.samples. Errors: those that the session reports.
Result<std::vector<RunCost>> runSession(const RunPlan& plan, Beside beside);

}  // namespace pdr::bench
