#pragma once
/// What went wrong with samples, by cause, and where it can be seen again. Never hidden, never turned into black: a
/// sample that is no radiance is left out of the mean and of the count.

#include <cstdint>

#include "render/base/portable.h"

namespace pdr {

enum class Fault : std::uint32_t {
    notANumber,    ///< left out: NaN
    infinite,      ///< left out: infinite, or beyond what float holds
    negative,      ///< left out: light that is taken away
    overMajorant,  ///< extinction above its bound was met: the sample counts, but is not exact
    cutPath,       ///< a path was ended at maxBounces with light still on it: the sample counts, but is too dark
    overTolerance  ///< a deterministic ray could not keep its error bound: the sample counts
};
inline constexpr int kFaults = 6;
inline constexpr int kLeftOut = 3;  ///< the first so many faults leave the sample out

/// Its word in reports: "notANumber".
inline constexpr const char* kFaultNames[kFaults] = {"notANumber",   "infinite", "negative",
                                                     "overMajorant", "cutPath",  "overTolerance"};

/// How often something happened, and the first sample that it happened to: the lowest sample, then the lowest pixel.
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
    /// Samples that were left out.
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
