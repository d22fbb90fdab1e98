#pragma once
/// When rendering is to stop by itself, and the decision whether an image is good enough for that.

#include <cstdint>
#include <optional>

#include "render/accuracy/stop_rule.h"

namespace pdr {

/// Progress of the full image that was shown last.
struct ImageProgress {
    std::optional<double> displayError;  ///< the larger of its error and its region's [levels]; none: no such image
    double seconds = 0;                  ///< rendering time of its film [s]
    std::uint64_t samples = 0;           ///< samples of every pixel
};

struct StopRequest {
    StopRule rule;
    bool isSuspended = false;  ///< the rule does not count for the current scene: more was requested
    bool isPaused = false;     ///< rendering stops whatever the progress

    /// Returns the samples per pixel at which rendering stops; 0: no limit.
    std::uint64_t samples() const { return isSuspended ? 0 : rule.samples; }
    /// Returns whether the rule counts and is met.
    bool isMet(const ImageProgress& progress) const {
        return progress.displayError && !isSuspended &&
               rule.isMet(*progress.displayError, progress.seconds, progress.samples);
    }
    /// Returns whether rendering stops at that progress.
    bool stopsAt(const ImageProgress& progress) const { return isPaused || isMet(progress); }
};

}  // namespace pdr
