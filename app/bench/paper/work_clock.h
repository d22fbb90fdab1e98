#pragma once
/// Choice of the time that is measured.

#include <functional>

namespace pdr::bench::paper {

enum class TimeOf {
    wall,  ///< wall-clock time, for which a user waits
    /// Processor time of the program's threads over their number, which excludes what other programs took. With one
    /// thread it is the wall-clock time on a processor of its own. With more threads, work that only one of them can do
    /// counts too little.
    processor,
};

/// Callback that returns the seconds since a fixed moment.
using WorkClock = std::function<double()>;

/// Returns the clock for `time`. `threads` is as for processorLoad().
WorkClock clockOf(TimeOf time, int threads);

}  // namespace pdr::bench::paper
