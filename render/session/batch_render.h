#pragma once
/// Renders one picture to its end, on the thread that asks for it: no window, no session.

#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>

#include "render/base/result.h"
#include "render/device/accumulator.h"

namespace pdr {

/// When to stop; whichever comes first. At least one must be there.
struct Stops {
    std::optional<std::uint64_t> samples;  ///< per pixel; >= 1
    std::optional<double> seconds;         ///< of rendering; > 0; the sample that is on its way is still finished, and
                                           ///< so is the first one after all were found wrong
    std::optional<double> relativeError;   ///< FilmStatus::relativeError; > 0
    std::optional<double> levels;          ///< FilmStatus::displayError; > 0
};

enum class StopReason { samples, seconds, error, levels, interrupted };

/// How far it is. `fraction` is a guess where only an error is asked for.
struct BatchState {
    FilmStatus film;
    double seconds = 0;
    double fraction = 0;                ///< [0, 1]
    std::optional<double> secondsLeft;  ///< absent while nothing can be said
};

struct BatchResult {
    StopReason reason = StopReason::samples;
    FilmStatus film;
    double seconds = 0;  ///< of rendering
};

/// What becomes of the samples that are there when a stop is requested.
enum class WhenStopped {
    keep,    ///< the one that is on its way is finished, so that the film stays right; the very first is given up
    discard  ///< it ends at once, and the film is worthless
};

class BatchRender {
  public:
    using Report = std::function<void(const BatchState&)>;

    /// `film` is empty, of the scene that its device holds, and outlives this. `display`: what levels are those of.
    BatchRender(Accumulator& film, const Stops& stops, const Display& display,
                WhenStopped whenStopped = WhenStopped::keep)
        : film_(film), stops_(stops), display_(display), whenStopped_(whenStopped) {}

    /// Renders until the first stop, or a stop request. `report` is called after the first sample and then about twice
    /// a second. Where an error stops, the number of samples does not depend on the machine's speed.
    Result<BatchResult> run(std::stop_token stop, const Report& report);

  private:
    std::uint32_t wantedSamples(double elapsed) const;
    std::uint32_t toBlockEnd(std::uint32_t wanted) const;
    std::optional<StopReason> reached(double elapsed) const;
    BatchState state(double elapsed) const;
    Result<void> takeSamples(double elapsed, std::stop_token stop);
    Result<void> look();
    bool stopsByError() const { return stops_.relativeError || stops_.levels; }
    bool errorIsDue() const;
    bool isFilmRight(StopReason reason) const;

    Accumulator& film_;
    Stops stops_;
    Display display_;
    WhenStopped whenStopped_;
    std::uint64_t done_ = 0;  ///< samples of every pixel
    double begunAt_ = 0;      ///< when the first of them was asked for, in seconds of rendering
    FilmStatus status_;       ///< of the film when it was last looked at
};

}  // namespace pdr
