#pragma once
/// How long frames take that come one after the other.

#include <cstdint>
#include <limits>
#include <stop_token>

#include "app/bench/paper/work_clock.h"
#include "render/device/accumulator.h"

namespace pdr::bench::paper {

struct Lap {
    double seconds = 0;
    std::uint64_t frames = 0;
    /// Standard deviation of one sample of a pixel over the picture's mean (both luminance; root mean square over the
    /// pixels), as the last picture knew it; infinite where it did not.
    double sampleNoise = std::numeric_limits<double>::infinity();
};

/// Frames of n iterations each, for at least `seconds`, with as many ordered ahead as the film allows: a frame's time
/// is that from one take to the next. The first frame warms up and is not counted, unless it takes `seconds` alone.
/// After a stop request: what was whole before it.
Result<Lap> timeFrames(Accumulator& film, std::uint32_t n, const Display& display, double seconds, const WorkClock& now,
                       std::stop_token stop);

}  // namespace pdr::bench::paper
