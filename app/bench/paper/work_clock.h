#pragma once
/// Which time is measured.

#include <functional>

namespace pdr::bench::paper {

enum class TimeOf {
    wall,       ///< the clock's: what a user waits
    processor,  ///< what the program's threads spent on the processor, over their number: what others took is left out.
                ///< With one thread it is the clock's time of a processor that is nobody else's; with more, what only
                ///< one of them can do counts too little.
};

/// Seconds since some moment.
using WorkClock = std::function<double()>;

/// `threads` as for processorLoad().
WorkClock clockOf(TimeOf time, int threads);

}  // namespace pdr::bench::paper
