#pragma once
/// The render thread of a session: takes commands, renders, and sends frames.

#include <memory>
#include <optional>
#include <thread>

#include "render/session/bias_tracker.h"
#include "render/session/checkpoint.h"
#include "render/session/display_pipeline.h"
#include "render/session/edited_view.h"
#include "render/session/featured_view.h"
#include "render/session/film_on_device.h"
#include "render/session/frame_scheduler.h"
#include "render/session/kept_films.h"
#include "render/session/live_effect_costs.h"
#include "render/session/quality_tracker.h"
#include "render/session/render_commands.h"
#include "render/session/session.h"

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
    bool begin(const RenderCommands::SceneOrder& order, const std::stop_token& stop);
    void work(const RenderCommands::Iteration& step);
    void finish(const RenderCommands::Iteration& step, Result<void> done);
    void measureEffects(const RenderCommands::Iteration& step);

    // Parts of work(). Errors: the device's.
    Result<void> accumulate(const FrameBudget& pace, const std::stop_token& stop);
    Result<void> show(const RenderCommands::Iteration& step, bool adds);
    Result<void> renderBefore();
    int dividerForEdit() const;
    Result<void> prepareEdit(const std::stop_token& stop);
    Result<void> prepareEdit(int divider, const std::stop_token& stop);
    bool showsFeatures(const RenderCommands::Iteration& step, const Display& display, bool adds);
    void findFeatures(const std::stop_token& stop);
    Result<DisplayPipeline::Images> makeHelped(const Display& asked, const Display& display, bool adds,
                                               const std::stop_token& stop);
    Result<void> showCoarser(const RenderCommands::Iteration& step);
    Result<void> timeDisplay(const Display& display, std::uint32_t n, double frameSeconds);
    Result<void> judge(const RenderCommands::Iteration& step);
    Result<void> judgeShown(const RenderCommands::Iteration& step);
    Result<void> updateQuality(const Display& asked, const std::stop_token& stop);
    Result<void> takeSnapshots();
    void send(DisplayPipeline::Images images, std::uint32_t n);
    std::shared_ptr<Frame> frameOf(DisplayedImage image, std::uint32_t n);
    /// Completes a frame of the film with what changes without it: the scene's number and texts, the stop rule, and the
    /// device.
    void label(Frame& frame);

    // Starting and continuing films.
    void beginFilm();
    void beginFiner(const std::stop_token& stop);
    void goOnFrom(std::shared_ptr<const Film> film);
    void keepFilm();
    bool comeBack(const std::stop_token& stop);
    bool showReturning();
    KeptScene keptScene() const;
    Result<bool> moveTo(Result<std::unique_ptr<Device>> device, std::shared_ptr<const Film> from);
    Scene divided(Scene scene) const;
    static Scene dividedBy(int divider, Scene scene, std::uint64_t pattern);

    // A device that fails or refuses.
    void recover(const Text& reason);
    void failedOnDevice(const Error& error);
    void threw() noexcept;
    void fail(const Text& sentence);
    void notify(const Text& sentences);

    Tile nextPart();
    Result<void> beginFrame(const FrameBudget& pace);
    FrameScheduler::Demand demand(const FrameBudget& pace) {
        const bool isHelped = (edits_.hasOld() && !coarse()) || features_.helps(scheduler_.samples().least);
        return {pace,
                display_.coarserSamples(),
                keepsFirst(),
                isHelped && smooths(commands.display()),
                place_.film()->orderSize().isShared && !coarse(),
                commands.stopRequest().samples()};
    }
    bool overlaps() const { return place_.film()->maxInFlight() > 1; }
    bool hasSamples() const { return scheduler_.samples().least > 0; }
    bool isHalfMade() const { return scheduler_.sweep().isHalfMade(); }
    std::uint64_t partSamples() const { return scheduler_.sweep().partSamples(); }
    bool coarse() const { return scheduler_.isCoarse(); }
    ImageProgress progress() const { return quality_.progress(scheduler_.samples().least); }
    bool smooths(const Display& asked) const { return asked.denoised && canBeDenoised(scene_); }
    /// Returns whether an image in progress is postponed for another display, because an older image can be shown
    /// on that at once.
    bool givesWay() const { return !display_.awaitsFirst() || (display_.hasCoarser() && !coarse()); }
    /// Returns whether the image after the first samples is kept, for the next edit.
    bool keepsFirst() const { return (!coarse() || scheduler_.isCoarseEdit()) && EditedView::canKeep(scene_); }
    /// Returns whether the image is made with the one before the edit.
    bool showsEdit(const Display& display) const {
        const std::uint64_t samples = scheduler_.samples().least;
        return display.denoised && (scheduler_.isCoarseEdit() ? edits_.helpsCoarse(place_.size(), samples)
                                                              : !coarse() && edits_.helps(samples));
    }
    /// Returns whether a denoised image of the film, without one before an edit, is made on features where there are
    /// any.
    bool seeksFeatures() const {
        return !coarse() && EditedView::canKeep(scene_) && !edits_.helps(scheduler_.samples().least);
    }
    /// Returns whether there is a denoised image whose error can be judged.
    bool canJudge() { return !coarse() && !moving_ && smooths(commands.display()); }
    /// Returns whether that image is the film denoised, nothing else.
    bool judgesFilm() {
        return canJudge() && !showsEdit(commands.display()) && !features_.helps(scheduler_.samples().least);
    }
    /// Returns whether the film is worth keeping for when its scene comes back.
    bool isWorthKeeping() const {
        return place_.film() != nullptr && !coarse() && !display_.awaitsFirst() && hasSamples() &&
               quality_.seconds() >= kLeastKeptSeconds && scene_.schedule.kind == Schedule::Kind::pd;
    }
    bool canSnapshot() const {
        return place_.film() != nullptr && !moving_ && !coarse() && !display_.awaitsFirst() && !isHalfMade();
    }

    /// Rendering time that makes a film worth keeping; a film of less comes back as soon by being rendered again.
    static constexpr double kLeastKeptSeconds = 0.5;

    FrameSink sink_;
    DeviceOpener fallback_;
    SessionClock clock_;
    FilmOnDevice place_;
    bool onFallback_ = false;
    Scene scene_;                 ///< scene as submitted
    Text notShown_;               ///< what its image does not show; many frames state it
    std::uint64_t revision_ = 0;  ///< revision of the scene submitted last, even if it failed
    bool moving_ = false;
    FrameTimes times_;        ///< those of the scene and of its image in progress
    bool brightens_ = false;  ///< the display of a denoised image has just changed

    FrameScheduler scheduler_{clock_};
    DisplayPipeline display_;
    EditedView edits_;
    FeaturedView features_;
    QualityTracker quality_{clock_};
    BiasTracker bias_{clock_};
    Checkpoint checkpoint_{clock_};
    LiveEffectCosts effectCosts_{clock_};
    KeptFilms kept_;
    std::shared_ptr<const Frame> shown_;      ///< last full image of the film; null: none since it lost samples
    std::shared_ptr<const Frame> returning_;  ///< last image of a film that came back, until it or a newer one is shown

    std::jthread thread_;  ///< declared last, because it uses all members above
};

}  // namespace pdr
