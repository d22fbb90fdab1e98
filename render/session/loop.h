#pragma once
/// The render thread of a session: takes commands, renders, and sends frames.

#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "render/session/bias_tracker.h"
#include "render/session/checkpoint.h"
#include "render/session/display_pipeline.h"
#include "render/session/film_on_device.h"
#include "render/session/live_ledger.h"
#include "render/session/quality_tracker.h"
#include "render/session/render_commands.h"
#include "render/session/resolution_ladder.h"
#include "render/session/session.h"
#include "render/session/sweep.h"

namespace pdr {

class Session::Loop {
  public:
    Loop(std::unique_ptr<Device> device, FrameSink sink, DeviceOpener fallback, SessionClock clock);
    ~Loop();

    RenderCommands commands;

  private:
    void run(std::stop_token stop);
    void take(const RenderCommands::Iteration& step);
    RenderCommands::LoopState state();

    // Actions of a step. Each leaves either a film that can continue, or no film and a frame that says why.
    void clear();
    void answer(const RenderCommands::Iteration& step) const;
    void switchTo(const DeviceOpener& open);
    void begin(const RenderCommands::SceneOrder& order);
    void work(const RenderCommands::Iteration& step);
    void finish(const RenderCommands::Iteration& step, Result<void> done);
    void measureEffects(const RenderCommands::Iteration& step);

    // Parts of work(). Errors: the device's.
    Result<void> accumulate(const RenderCommands::Iteration& step);
    Result<void> show(const RenderCommands::Iteration& step, bool adds);
    Result<void> showCoarser(const RenderCommands::Iteration& step);
    Result<void> measureDisplay(const Display& display, std::uint32_t n, double frameSeconds);
    Result<void> judge(const RenderCommands::Iteration& step);
    Result<void> updateQuality(const Display& asked, const std::stop_token& stop);
    Result<void> takeSnapshots();
    void send(DisplayPipeline::Pictures pictures, std::uint32_t n);
    std::shared_ptr<Frame> frameOf(DisplayedPicture picture, std::uint32_t n);
    void addTimes(std::uint32_t n, double iterationSeconds, double displaySeconds);

    // Starting and continuing films.
    void beginFilm(int divider);
    void beginFiner();
    void goOnFrom(std::shared_ptr<const Film> film);
    Scene dividedScene() const;

    // A device that fails or refuses.
    void recover(const Text& reason);
    void failedOnDevice(const Error& error);
    void threw() noexcept;
    void fail(const Text& sentence);
    void notify(const Text& sentences);

    std::uint32_t wanted(const FrameBudget& pace) const;
    std::uint32_t launch(std::uint32_t wanted) const;
    double piecePixels() const;
    Tile nextPart();
    Result<void> beginFrame(const FrameBudget& pace);
    bool late() const;
    ImageProgress progress() const { return quality_.progress(sweep_.samples().least); }
    double secondsAhead() const;
    bool smooths(const Display& asked) const { return asked.smoothed && canBeSmoothed(scene_); }
    double pixels() const { return double(place_.size().x) * place_.size().y; }
    /// Number of pixels in the part that is being sampled; partSamples(): samples that each of them has.
    double partPixels() const { return double(sweep_.part().width) * sweep_.part().height; }
    std::uint64_t partSamples() const { return sweep_.samplesOf(sweep_.part()); }
    bool isWhole(const Tile& part) const { return part == wholeImage(place_.size()); }
    /// Returns whether all pixels have equally many samples.
    bool isEven() const {
        const SampleCounts samples = sweep_.samples();
        return samples.least == samples.most;
    }
    /// Returns whether the film is a coarse one or was begun during a drag, and so is not yet the scene's final film.
    bool coarse() const { return divider_ > 1 || passing_; }
    /// Returns whether an image in progress is postponed for another display, because an older image can be shown
    /// on that at once.
    bool givesWay() const { return !display_.awaitsFirst() || (display_.hasCoarser() && !coarse()); }
    /// Returns whether there is a denoised image whose error can be judged.
    bool canJudge() { return !coarse() && !moving_ && smooths(commands.display()); }
    bool canSnapshot() const {
        return place_.film() != nullptr && !moving_ && !coarse() && !display_.awaitsFirst() && !sweep_.isHalfMade();
    }

    double secondsSince(double moment) const { return clock_() - moment; }

    FrameSink sink_;
    DeviceOpener fallback_;
    SessionClock clock_;
    FilmOnDevice place_;
    bool onFallback_ = false;
    Scene scene_;                 ///< scene as submitted
    std::uint64_t revision_ = 0;  ///< revision of the scene submitted last, even if it failed
    bool moving_ = false;
    int divider_ = 1;       ///< divider of the film; see ResolutionLadder
    bool passing_ = false;  ///< the film was begun during a drag, with random numbers of its own
    DisplayPipeline display_;

    // State of the current film:
    Sweep sweep_;              ///< its progress
    std::uint32_t done_ = 0;   ///< iterations since it was last shown
    bool wholeFrame_ = true;   ///< the current frame's iterations cover all pixels equally
    double frameSeconds_ = 0;  ///< time spent on the current frame
    QualityTracker quality_{clock_};
    BiasTracker bias_{clock_};
    double aheadSeconds_ = 0;  ///< time spent on the region alone
    double aheadSamples_ = 0;  ///< samples per pixel of the region in that time
    bool brightens_ = false;   ///< the display of a denoised image has just changed

    FrameTimer meter_;
    bool measuring_ = false;  ///< the current frame is timed, with no other work in flight
    double measuredAt_ = 0;   ///< clock time of the last timed frame

    Checkpoint checkpoint_{clock_};
    ResolutionLadder ladder_;
    LiveLedger ledger_{clock_};

    std::jthread thread_;  ///< declared last, because it uses all members above
};

}  // namespace pdr
