#pragma once
/// How many samples of every pixel one launch takes: many, so that its fixed cost is paid rarely, but no more than a
/// hundredth of a second's, so that an edit does not wait, nor more than there is room for.

#include <algorithm>
#include <chrono>
#include <cstdint>

namespace pdr {

class LaunchSize {
  public:
    explicit LaunchSize(std::int64_t pixels) : most_(mostFor(pixels)) {}

    /// That there is room for.
    std::uint32_t most() const { return most_; }
    /// At least 1.
    std::uint32_t samples() const {
        const double affordable = kSeconds / std::max(secondsPerSample_, 1e-12);
        return std::uint32_t(std::clamp(affordable, 1.0, double(most_)));
    }

    /// A launch of so many samples was ordered, and the one before it has ended.
    void ended(std::uint32_t samples) {
        const Clock::time_point now = Clock::now();
        if (samplesBefore_ > 0) {
            const double seconds = std::chrono::duration<double>(now - before_).count();
            const double perSample = seconds / samplesBefore_;
            // Faster is believed at once; slower, which may be the host's fault, by and by.
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
    double secondsPerSample_ = kSeconds;  ///< of every pixel; one until more is known
    Clock::time_point before_{};
    std::uint32_t samplesBefore_ = 0;
};

}  // namespace pdr
