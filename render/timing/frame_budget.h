#pragma once
/// How many iterations a displayed frame gets: a fixed number, or as many as make the display cheap without making it
/// slow.

#include <cstdint>

#include "render/timing/recent.h"

namespace pdr {

struct FrameBudget {
    bool automatic = false;
    int iterations = 1;           ///< if not automatic; [1, 10000]
    double framesPerSecond = 10;  ///< if automatic: least frame rate, where the device can; [0.1, 60]
    double efficiency = 0.98;     ///< if automatic: fraction of the time that should go into iterations; (0, 1)

    /// Returns a copy with every number in its range.
    FrameBudget clamped() const;
    bool operator==(const FrameBudget&) const = default;
};

/// Measures what a displayed frame costs on a device, from recent frames. It uses medians, so that a frame delayed by
/// another program does not count.
class FrameTimer {
  public:
    void clear() { *this = {}; }
    /// Adds a frame of n iterations, with the times that its iterations and its display took, one after the other [s].
    void addFrame(std::uint32_t n, double iterationSeconds, double displaySeconds);
    /// Adds a frame of n iterations that came `seconds` after the one before, whatever else ran at the same time.
    void addPeriod(std::uint32_t n, double seconds);

    /// Returns whether as many frames have been measured as the medians are taken of.
    bool settled() const;
    /// Returns n for the next frame; if automatic, 1 while nothing is known.
    std::uint32_t iterations(const FrameBudget& pace) const;
    /// Returns the fraction of the time that goes into iterations, (0, 1]; 0 while nothing is known.
    double efficiency() const;
    double iterationsPerSecond() const { return rates_.median(); }

  private:
    static constexpr std::size_t kFrames = 9;

    Recent iterationSeconds_{kFrames};  ///< T_p, of one iteration
    Recent displaySeconds_{kFrames};    ///< T_t + T_c, of one tone mapping and copy
    std::uint32_t lastMeasured_ = 0;    ///< n of the last frame whose times are known
    Recent rates_{kFrames};             ///< iterations per second, display included
};

}  // namespace pdr
