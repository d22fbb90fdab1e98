#pragma once
/// Measures the time of successive frames.

#include <cstdint>
#include <limits>
#include <stop_token>

#include "app/bench/paper/work_clock.h"
#include "render/device/accumulator.h"

namespace pdr::bench::paper {

struct Lap {
    double seconds = 0;
    std::uint64_t frames = 0;
    /// Standard deviation of one sample of a pixel over the image's mean (both luminance; root mean square over the
    /// pixels), from the status of the last image; infinite if unknown.
    double sampleNoise = std::numeric_limits<double>::infinity();
};

/// Renders frames of n iterations each, for at least `seconds`, with as many requested ahead as the film allows. The
/// time of a frame is that from one readback to the next. The first frame warms up and is not counted, unless it alone
/// takes `seconds`. After a stop request, returns the frames that were complete before it.
Result<Lap> timeFrames(Accumulator& film, std::uint32_t n, const Display& display, double seconds, const WorkClock& now,
                       std::stop_token stop);

}  // namespace pdr::bench::paper
