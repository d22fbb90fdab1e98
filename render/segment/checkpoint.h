#pragma once
/// Early stops for segmentation: its steps ask at checkpoints, a few milliseconds apart, whether to go on.

#include <functional>
#include <string_view>

#include "render/base/errors.h"
#include "render/base/progress.h"

namespace pdr::segment {

/// The exception that a checkpoint throws after a stop request; orCancelled() catches it. It never leaves this folder.
struct Stopped {};

/// A checkpoint throws Stopped after a stop request. It is called only from the thread that began the step, as Progress
/// must be.
using Checkpoint = std::function<void()>;

/// The Checkpoint of a step that is never stopped.
inline void goOn() {}

/// Returns the Checkpoint that reports `fraction` of `step` to `progress`, which must outlive it.
inline Checkpoint checkpointOf(const Progress& progress, double fraction, std::string_view step) {
    return [&progress, fraction, step] {
        if (!progress(fraction, step))
            throw Stopped{};
    };
}

/// Returns the Result of `step`; cancelled() where a checkpoint stopped it.
template <typename Step>
auto orCancelled(const Step& step) -> decltype(step()) {
    try {
        return step();
    } catch (const Stopped&) {
        return cancelled();
    }
}

}  // namespace pdr::segment
