#pragma once
/// How the steps of this room end early: they ask at checkpoints, a few milliseconds apart, whether to go on.

#include <functional>
#include <string_view>

#include "render/base/errors.h"
#include "render/base/progress.h"

namespace pdr::segment {

/// Thrown by a checkpoint after a stop was asked for; orCancelled() catches it. It never leaves the room.
struct Stopped {};

/// Throws Stopped where a stop was asked for. Called from the thread that began the step only, since Progress is.
using Checkpoint = std::function<void()>;

/// The Checkpoint of a step that nobody stops.
inline void goOn() {}

/// The Checkpoint that reports `fraction` of `step` to `progress`. Lives no longer than `progress`.
inline Checkpoint checkpointOf(const Progress& progress, double fraction, std::string_view step) {
    return [&progress, fraction, step] {
        if (!progress(fraction, step))
            throw Stopped{};
    };
}

/// What `step` returns, a Result; cancelled() where a checkpoint stopped it.
template <typename Step>
auto orCancelled(const Step& step) -> decltype(step()) {
    try {
        return step();
    } catch (const Stopped&) {
        return cancelled();
    }
}

}  // namespace pdr::segment
