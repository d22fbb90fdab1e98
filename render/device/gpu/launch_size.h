#pragma once
/// Chooses how many samples of every pixel one launch takes: many, so that its fixed cost is paid rarely, but no more
/// than a hundredth of a second's, so that an edit does not wait, nor more than there is memory for.

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace pdr {

class LaunchSize {
  public:
    explicit LaunchSize(std::int64_t pixels) : most_(mostFor(pixels)) {}

    /// Returns the number of samples that there is memory for.
    std::uint32_t most() const { return most_; }
    /// Returns the number of samples of the next launch, at least 1.
    std::uint32_t samples() const {
        const double affordable = kSeconds / std::max(secondsPerSample_, 1e-12);
        return std::uint32_t(std::clamp(affordable, 1.0, double(most_)));
    }

    /// Records that a launch of `samples` was enqueued, and that the one before it has ended.
    void ended(std::uint32_t samples) {
        const Clock::time_point now = Clock::now();
        if (samplesBefore_ > 0) {
            const double seconds = std::chrono::duration<double>(now - before_).count();
            const double perSample = seconds / samplesBefore_;
            // A faster launch counts at once; a slower one, which may be the host's fault, counts gradually.
            secondsPerSample_ = std::min(perSample, 0.75 * secondsPerSample_ + 0.25 * perSample);
        }
        before_ = now;
        samplesBefore_ = samples;
    }

  private:
    using Clock = std::chrono::steady_clock;
    static constexpr double kSeconds = 0.01;
    static constexpr std::int64_t kRadiances = 20'000'000;  ///< 240 MB
    static constexpr std::uint32_t kMostSamples = 256;

    static std::uint32_t mostFor(std::int64_t pixels) {
        return std::uint32_t(std::clamp<std::int64_t>(kRadiances / pixels, 1, kMostSamples));
    }

    std::uint32_t most_;
    double secondsPerSample_ = kSeconds;  ///< seconds per sample of every pixel; one sample until more is known
    Clock::time_point before_{};
    std::uint32_t samplesBefore_ = 0;
};

}  // namespace pdr
