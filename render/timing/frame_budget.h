#pragma once
/// How many iterations a displayed frame gets: by hand, or as many as make the display cheap without making it slow.

#include <cstdint>

#include "render/timing/recent.h"

namespace pdr {

struct FrameBudget {
    bool automatic = false;
    int iterations = 1;           ///< by hand; [1, 10000]
    double framesPerSecond = 10;  ///< automatic: at least so many where the device can; [0.1, 60]
    double efficiency = 0.98;     ///< automatic: the part of the time that should go into iterations; (0, 1)

    /// With every number in its range.
    FrameBudget clamped() const;
    bool operator==(const FrameBudget&) const = default;
};

/// What one displayed frame costs on a device, from recent frames. Medians: a frame that another program delayed does
/// not count.
class FrameTimer {
  public:
    void clear() { *this = {}; }
    /// A frame of n iterations that took that long, and its display, one after the other; seconds.
    void addFrame(std::uint32_t n, double iterationSeconds, double displaySeconds);
    /// A frame of n iterations came `seconds` after the one before, whatever went on at the same time.
    void addPeriod(std::uint32_t n, double seconds);

    /// Whether there are as many measured frames as medians are taken of.
    bool settled() const;
    /// n for the next frame; 1 as long as nothing is known.
    std::uint32_t iterations(const FrameBudget& pace) const;
    /// The part of the time that goes into iterations, (0, 1]; 0 as long as nothing is known.
    double efficiency() const;
    double iterationsPerSecond() const { return rates_.median(); }

  private:
    static constexpr std::size_t kFrames = 9;

    Recent iterationSeconds_{kFrames};  ///< Tp, of one iteration
    Recent displaySeconds_{kFrames};    ///< Tt + Tc, of one tone map and copy
    std::uint32_t lastMeasured_ = 0;    ///< n of the last frame whose times are known
    Recent rates_{kFrames};             ///< iterations per second, all in all
};

}  // namespace pdr
