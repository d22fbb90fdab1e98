#pragma once
/// Renders one image to its end on the calling thread, without window or session.

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

#include "render/accuracy/stop_rule.h"
#include "render/base/result.h"
#include "render/device/accumulator.h"

namespace pdr {

/// Limits at which rendering stops, at the first one reached. At least one must be set.
struct Stops {
    std::optional<std::uint64_t> samples;  ///< per pixel; >= 1
    /// Rendering time, > 0. The sample in progress is still finished, and so is the first one after all samples were
    /// found wrong.
    std::optional<double> seconds;
    std::optional<double> relativeError;  ///< FilmStatus::relativeError; > 0
    std::optional<double> levels;         ///< FilmStatus::displayError; > 0
};

enum class StopReason { samples, seconds, error, levels, interrupted };

/// Progress of a rendering. `fraction` is a guess if only an error limit is set.
struct BatchState {
    FilmStatus film;  ///< as last read; its mean samples per pixel are those of now
    double seconds = 0;
    double fraction = 0;                ///< [0, 1]
    std::optional<double> secondsLeft;  ///< none while it cannot be estimated
};

struct BatchResult {
    StopReason reason = StopReason::samples;
    FilmStatus film;
    double seconds = 0;  ///< rendering time
};

/// What happens to the samples so far when a stop is requested.
enum class WhenStopped {
    /// Finish the sample in progress, so that the film stays valid; the very first one is abandoned. A film that is
    /// extended tile by tile keeps the finished tiles, and the others get a sample.
    keep,
    discard  ///< end at once; the film is worthless
};

class BatchRender {
  public:
    using Report = std::function<void(const BatchState&)>;

    /// `film` must be empty, belong to the scene that its device holds, and outlive this object. `display` defines the
    /// display levels.
    BatchRender(Accumulator& film, const Stops& stops, const Display& display,
                WhenStopped whenStopped = WhenStopped::keep)
        : film_(film), stops_(stops), display_(display), whenStopped_(whenStopped) {}

    /// Renders until the first limit or a stop request. `report` is called after the first sample and then about twice
    /// a second. If an error limit ends rendering, the number of samples does not depend on the machine's speed.
    Result<BatchResult> run(std::stop_token stop, const Report& report);

  private:
    std::uint32_t wantedSamples(const OrderSize& order, double elapsed) const;
    std::uint32_t toBlockEnd(std::uint32_t wanted) const;
    std::optional<StopReason> reached(double elapsed) const;
    double samplesInTime(const OrderSize& order, bool isWhole, double elapsed) const;
    BatchState state(double elapsed, const SampleCounts& samples) const;
    bool isTimeOver(double elapsed) const;
    /// Takes the next order; `elapsed` goes on while it is taken.
    Result<void> takeSamples(const double& elapsed, std::stop_token stop, const Extended& told);
    Result<void> keepFinished(std::uint64_t there);
    Result<void> look();
    bool stopsByError() const { return stops_.relativeError || stops_.levels; }
    bool errorIsDue() const;
    void planLook();
    bool isFilmRight(StopReason reason) const;

    Accumulator& film_;
    Stops stops_;
    Display display_;
    WhenStopped whenStopped_;
    std::uint64_t done_ = 0;                   ///< samples of every pixel
    double begunAt_ = 0;                       ///< rendering time when the first of them was requested [s]
    std::uint64_t nextLook_ = kSamplesToStop;  ///< samples after which the error is looked at
    FilmStatus status_;                        ///< status of the film when last read
};

}  // namespace pdr
