#pragma once
/// The render thread.

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "render/accuracy/shown_history.h"
#include "render/film/display/smoothed_view.h"
#include "render/film/error/error_map_view.h"
#include "render/session/bias_measurements.h"
#include "render/session/film_on_device.h"
#include "render/session/live_ledger.h"
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
    struct DisplayedPicture {
        Picture picture;
        Display display;
        ivec2 size;
    };

    void run(std::stop_token stop);
    void take(const RenderCommands::Iteration& step);
    RenderCommands::LoopState state();

    // What a step may ask for. Each leaves either a film that can go on, or none and a frame that says why.
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
    Result<std::vector<DisplayedPicture>> made(const Display& asked, const Display& display, bool atOnce,
                                               const std::stop_token& stop);
    Result<std::vector<DisplayedPicture>> madeOnGuide(const Display& asked, bool adds);
    Result<std::vector<DisplayedPicture>> takeAllBut(std::size_t left);
    bool findGuide(const std::stop_token& stop);
    Result<void> measureDisplay(const Display& display, std::uint32_t n, double frameSeconds);
    Result<void> mapErrors(const Display& display, const std::stop_token& stop);
    Result<void> judgeSmoothing(const RenderCommands::Iteration& step);
    Result<void> measureBias(const RenderCommands::Iteration& step);
    BiasLattice* nextLattice();
    MeasuredBiases knownBias(float exposure);
    Result<void> keepCheckpoint();
    Result<void> takeSnapshots();
    void send(std::vector<DisplayedPicture> pictures, std::uint32_t n);
    std::shared_ptr<Frame> frameOf(DisplayedPicture picture, std::uint32_t n);
    bool isSurveyDue(const Display& asked) const;
    void remember(DisplayedPicture& picture);
    ShownStatus shown(const FilmStatus& film, bool denoised, float exposure);
    void addTimes(std::uint32_t n, double iterationSeconds, double displaySeconds);

    // Beginnings.
    void beginFilm(int divider);
    void beginFiner();
    void startOver();
    void goOnFrom(std::shared_ptr<const Film> film);
    Scene dividedScene() const;

    // When a device fails or refuses.
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
    Result<void> lookAtRegion(const Display& display);
    RenderCommands::Progress progress() const;
    double secondsAhead() const;
    std::vector<QualityStep> steps(ErrorOf of) const;
    bool smooths(const Display& asked) const { return asked.smoothed && canBeSmoothed(scene_); }
    double pixels() const { return double(place_.size().x) * place_.size().y; }
    /// Of the part that is being sampled; samples that each of them has.
    double partPixels() const { return double(sweep_.part().width) * sweep_.part().height; }
    std::uint64_t partSamples() const { return sweep_.samplesOf(sweep_.part()); }
    bool isWhole(const Tile& part) const { return part == wholeImage(place_.size()); }
    /// Whether no part is further than another.
    bool isEven() const {
        const SampleCounts samples = sweep_.samples();
        return samples.least == samples.most;
    }
    /// Whether the film is not yet the scene's own.
    bool coarse() const { return divider_ > 1 || passing_; }
    /// Whether an image in the making is put off for another display: there is one to show on that at once.
    bool givesWay() const { return !first_ || (coarser_ && !coarse()); }
    /// Whether there is a smoothed picture of which something is to be said.
    bool canJudge() { return !coarse() && !moving_ && smooths(commands.display()); }
    bool canSnapshot() const {
        return place_.film() != nullptr && !moving_ && !coarse() && !first_ && !sweep_.isHalfMade();
    }

    double secondsSince(double moment) const { return clock_() - moment; }

    FrameSink sink_;
    DeviceOpener fallback_;
    SessionClock clock_;
    FilmOnDevice place_;
    bool onFallback_ = false;
    Scene scene_;                 ///< as it was submitted
    std::uint64_t revision_ = 0;  ///< of the scene submitted last, whatever became of it
    bool moving_ = false;
    int divider_ = 1;       ///< of the film: see ResolutionLadder
    bool passing_ = false;  ///< it was begun while the user dragged: with random numbers of its own
    std::shared_ptr<const Film>
        coarser_;  ///< whose picture stays until the film's own is no worse; null: there is none
    std::shared_ptr<const GuidedFilm> coarserGuided_;  ///< that one on its guide; null: it has none
    Development coarserPictures_;

    // Of the film:
    Sweep sweep_;                                  ///< how far it is
    std::uint32_t done_ = 0;                       ///< iterations since it was last shown
    bool wholeFrame_ = true;                       ///< those of the frame in the making give to all pixels alike
    std::deque<Display> waiting_;                  ///< what the pictures that were ordered and not taken are made for
    bool first_ = false;                           ///< its first picture is still to come
    bool fresh_ = false;                           ///< the first one from this device is
    bool broken_ = false;                          ///< its first image was broken off, and comes before more samples
    std::shared_ptr<const denoise::Guide> guide_;  ///< that its pictures are drawn on; null: none, or not yet
    bool guideSought_ = false;                     ///< the device was asked for it
    std::shared_ptr<const GuidedFilm> guided_;     ///< the film on it, as it was shown; null: it was not
    std::optional<double> shownError_;             ///< of its full picture that was shown last; none: there is none
    ErrorOf shownOf_ = ErrorOf::film;              ///< image that it speaks of
    ShownHistory history_;                         ///< of its full pictures
    float historyExposure_ = 0;                    ///< of the display that its errors are those of
    double frameSeconds_ = 0;                      ///< of the frame in the making
    double seconds_ = 0;                           ///< of all of them
    FilmStatus surveyed_;                          ///< what the last picture that was surveyed told
    double judgeSeconds_ = 0, judgedAt_ = 0;       ///< of that, what judging smoothedView_ took last, and when it ended
    double mapSeconds_ = 0;                        ///< of that, spent on errorMap_
    SmoothedView smoothedView_;
    std::optional<BiasMeasurements> biasMeasurements_;  ///< of the same picture; none: not asked for yet
    double biasAt_ = 0;                                 ///< when a round of one was last
    double biasSeconds_ = 0;                            ///< what that cost
    MeasuredBiases bias_;                               ///< that they tell, on a display of this exposure (0: of none)
    float biasExposure_ = 0;
    ErrorMapView errorMap_;
    RegionView region_;
    double aheadSeconds_ = 0;  ///< spent on it alone, ...
    double aheadSamples_ = 0;  ///< ... and samples that each of its pixels got
    bool brightens_ = false;   ///< its picture, a smoothed one, was just shown on another display

    FrameTimer meter_;
    bool measuring_ = false;  ///< the frame in the making, with nothing behind it
    double measuredAt_ = 0;   ///< when one was last

    std::shared_ptr<const Film> checkpoint_;  ///< what is left when the device is lost; null: nothing
    double checkpointAt_ = 0;
    double checkpointSeconds_ = 0;  ///< what the last one cost

    ResolutionLadder ladder_;
    LiveLedger ledger_{clock_};

    std::jthread thread_;  ///< last: it uses all of the above
};

}  // namespace pdr
