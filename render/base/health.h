#pragma once
/// Faults of samples, counted by cause, with the first sample at which each can be reproduced. Faults are never hidden
/// or replaced by black: a sample that is no valid radiance is excluded from the mean and from the count.

#include <cstdint>

#include "render/base/portable.h"

namespace pdr {

enum class Fault : std::uint32_t {
    notANumber,    ///< excluded: NaN
    infinite,      ///< excluded: infinite, or beyond the range of float
    negative,      ///< excluded: negative radiance
    overMajorant,  ///< an extinction exceeded its bound: the sample counts, but is not exact
    cutPath,       ///< a path ended at maxBounces with throughput left: the sample counts, but is too dark
    overTolerance  ///< a deterministic ray exceeded its error bound: the sample counts
};
inline constexpr int kFaults = 6;
inline constexpr int kLeftOut = 3;  ///< number of faults, from the first, that exclude the sample

/// Names of the faults in reports: "notANumber".
inline constexpr const char* kFaultNames[kFaults] = {"notANumber",   "infinite", "negative",
                                                     "overMajorant", "cutPath",  "overTolerance"};

/// The number of occurrences of a fault, and its first one: the lowest sample, then the lowest pixel.
struct FaultCount {
    std::uint64_t count = 0;
    std::uint64_t sample = 0;
    std::uint32_t pixel = 0;  ///< y * width + x

    PDR_HD void add(const FaultCount& other) {
        if (other.count == 0)
            return;
        const bool earlier = other.sample < sample || (other.sample == sample && other.pixel < pixel);
        if (count == 0 || earlier) {
            sample = other.sample;
            pixel = other.pixel;
        }
        count += other.count;
    }
};

struct Health {
    FaultCount faults[kFaults];

    PDR_HD void add(Fault fault, std::uint64_t sample, std::uint32_t pixel) {
        faults[std::uint32_t(fault)].add({1, sample, pixel});
    }
    PDR_HD void add(const Health& other) {
        for (int i = 0; i < kFaults; ++i)
            faults[i].add(other.faults[i]);
    }
    PDR_HD const FaultCount& of(Fault fault) const { return faults[std::uint32_t(fault)]; }
    /// Returns the number of excluded samples.
    PDR_HD std::uint64_t rejected() const {
        std::uint64_t sum = 0;
        for (int i = 0; i < kLeftOut; ++i)
            sum += faults[i].count;
        return sum;
    }
    PDR_HD bool perfect() const {
        bool none = true;
        for (const FaultCount& fault : faults)
            none = none && fault.count == 0;
        return none;
    }
};

}  // namespace pdr
