#pragma once
/// Several images measured in turn, so that what else the machine does meets all of them alike.

#include <cstdint>
#include <vector>

#include "app/bench/live_image.h"
#include "render/base/processor_time.h"

namespace pdr::bench {

/// Takes `samples` samples per pixel of each image, round after round, and appends the processor time of one sample to
/// its `nanoseconds`. Timed: a type with an `image` of `size` pixels and `nanoseconds`. Errors: those of the device.
template <class Timed>
Result<void> takeTurns(std::vector<Timed>& all, ivec2 size, int samples, int rounds) {
    for (int round = 0; round < rounds; ++round)
        for (Timed& one : all) {
            const double start = processorSeconds();
            if (const auto taken = one.image.live->accumulate(std::uint32_t(samples), {}); !taken)
                return taken.error();
            one.nanoseconds.push_back(1e9 * (processorSeconds() - start) / (double(samples) * size.x * size.y));
        }
    return {};
}

}  // namespace pdr::bench
