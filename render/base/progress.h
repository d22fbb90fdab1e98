#pragma once
/// How a long step says how far it is, and learns that it should stop.

#include <functional>
#include <string_view>

namespace pdr {

/// Called now and then from the thread that works.
///   fraction  done so far, [0, 1]        step  what is being done, for the user ("reading slices")
/// Returns false to cancel: the step then ends soon with the Error cancelled() (base/errors.h).
using Progress = std::function<bool(double fraction, std::string_view step)>;

/// The Progress of somebody who does not care.
inline bool noProgress(double, std::string_view) {
    return true;
}

/// That of a step which fills `progress` from `from` to `to`. Lives no longer than `progress`.
inline Progress partOf(const Progress& progress, double from, double to) {
    return [&progress, from, to](double fraction, std::string_view step) {
        return progress(from + (to - from) * fraction, step);
    };
}

}  // namespace pdr
