#pragma once
/// Progress reports of long steps, and their cancellation.

#include <functional>
#include <string_view>

namespace pdr {

/// Function that a long step calls now and then from its own thread.
///   fraction  part done so far, [0, 1]        step  what is being done, for the user ("reading slices")
/// Returns false to cancel: the step then ends soon with the Error cancelled() (base/errors.h).
using Progress = std::function<bool(double fraction, std::string_view step)>;

/// Ignores progress and never cancels.
inline bool noProgress(double, std::string_view) {
    return true;
}

/// Returns the Progress of a step that advances `progress` from `from` to `to`. It must not outlive `progress`.
inline Progress partOf(const Progress& progress, double from, double to) {
    return [&progress, from, to](double fraction, std::string_view step) {
        return progress(from + (to - from) * fraction, step);
    };
}

}  // namespace pdr
