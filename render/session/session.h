#pragma once
/// The render loop on its own thread: newest Scene in, frames out. A device that fails costs seconds of samples at
/// most: the picture goes on on another.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/accuracy/bias.h"
#include "render/accuracy/forecast.h"
#include "render/accuracy/stop_rule.h"
#include "render/device/device.h"
#include "render/film/display.h"
#include "render/film/display/smoothed_view.h"
#include "render/film/error/level_error_map.h"
#include "render/film/error/shown_status.h"
#include "render/film/film.h"
#include "render/scene/camera.h"
#include "render/scene/clip.h"
#include "render/scene/model.h"
#include "render/session/region.h"
#include "render/timing/frame_budget.h"

namespace pdr {

struct EffectLedger;
struct Scene;

/// One displayed picture, or a word to the user.
struct Frame {
    std::uint64_t revision = 0;  ///< of the Scene that it shows
    // Of that Scene, so that nothing else is written beside the picture:
    Camera camera;
    std::string lookName;
    bool maskAwaited = false;
    Text notShown;  ///< what its mask hides, in sentences
    Clip clip;
    Estimator estimator = Estimator::unbiased;
    bool coarse = false;             ///< a first picture, or one during interaction; better ones follow when it ends
    ivec2 size{0};                   ///< pixels; fewer than scene.film where it is coarse: stretch it
    Display display;                 ///< that it was made for, as it was asked for
    std::vector<std::uint8_t> rgba;  ///< 4 bytes a pixel, row by row from the top; empty with an error or a notice
    FilmStatus status;
    bool smoothed = false;                       ///< `rgba` is; the status is still that of the film
    std::optional<SmoothedError> smoothedError;  ///< none: not known yet
    std::vector<denoise::LostLine> lostLines;    ///< that are missing in it; empty: none is known to be, or not yet
    BiasFacts bias;                              ///< all but its size on the screen and the smoothed error
    double seconds = 0;                          ///< spent on this revision
    std::vector<QualityStep> steps;              ///< when they were and will be reached; see ErrorHistory::steps()
    double iterationsPerSecond = 0;              ///< lately
    std::uint32_t iterations = 0;                ///< n, the iterations from one frame to the next
    double efficiency = 0;  ///< lately: the part of the time that went into iterations, (0, 1]; 0 = not known
    std::string device;     ///< its name: "cpu"
    Schedule schedule;
    StopRule stop;                    ///< when rendering holds
    bool reached = false;             ///< it does, until more is asked for
    Text error;                       ///< for the user, when rendering failed and holds
    Text notice;                      ///< for the user, when it goes on, but not as was asked: whole sentences
    std::vector<ErrorPoint> history;  ///< see ErrorHistory::points()
    /// Of the film, of no more samples than it has; null: not wanted, or coarse.
    std::shared_ptr<const LevelErrorMap> errorMap;
    std::optional<RegionStatus> region;  ///< none: it was not asked for, or nothing is known of it yet
};

/// How good the image of a frame is.
inline ShownStatus shownOf(const Frame& frame) {
    return shownStatus(frame.status, frame.smoothed, frame.smoothedError);
}

/// Called on the render thread; must return soon.
using FrameSink = std::function<void(std::shared_ptr<const Frame>)>;

/// All that is known about a picture.
struct FilmView {
    const Film& film;
    const Scene& scene;         ///< that it shows
    double seconds;             ///< spent
    const std::string& device;  ///< its name: "cpu"
    MeasuredBiases bias;        ///< of ways that only measuring tells it of
    StopRule stop;              ///< as in Frame
    /// What is known of the denoised image, and stated on the screen; who judges it anew changes that, too. Null: none
    /// is shown.
    SmoothedView* denoised = nullptr;
};

/// Called on the render thread: with the film, or with the reason why there is none.
using SnapshotObserver = std::function<void(const Result<FilmView>&)>;

/// Opens a device; called on the render thread, so it may take its time.
using DeviceOpener = std::function<Result<std::unique_ptr<Device>>()>;

/// Called on the render thread with what is known by now of what effects cost; must return soon.
using EffectsObserver = std::function<void(std::shared_ptr<const EffectLedger>)>;

/// Who looks at what effects cost, and where that is measured: apart from the picture. Nobody: both are empty.
struct EffectsWatch {
    DeviceOpener device;  ///< called twice: for pictures with an effect and without
    EffectsObserver look;
};

/// Seconds since some moment; called on the render thread.
using SessionClock = std::function<double()>;
/// That of the wall, which never goes back.
double steadySeconds();

class Session {
  public:
    /// `fallback` is opened when the device in use fails or refuses a scene; none: that is then an error. `clock` tells
    /// what things take.
    Session(std::unique_ptr<Device> device, FrameSink sink, DeviceOpener fallback = {},
            SessionClock clock = steadySeconds);
    ~Session();  ///< stops within one launch

    /// Renders `scene` from now on; a running launch for an older one is cancelled. The first frame comes soon and
    /// coarse, unless the device makes a full one as soon; finer ones follow as soon as they are no worse. `moving`:
    /// the user still drags, so they follow only where he holds still; submit again with false when it rests.
    void submit(Scene scene, bool moving);
    /// Shows what is there with other display settings, without a restart.
    void setDisplay(const Display& display);
    /// Whether full pictures come with a map of their error. What is there gets one at once.
    void setErrorMap(bool wanted);
    /// The part of the pictures that gets its samples first, until it is within the target; none: all of it. It stays
    /// where it is when the scene changes.
    void setRegion(const std::optional<Region>& region);
    /// How many iterations a displayed frame gets.
    void setPace(const FrameBudget& pace);
    /// n, the iterations per displayed frame, by hand; [1, 10000].
    void setIterationsPerFrame(int n);
    /// The picture goes on on another device, from the samples that it has. One that cannot be opened or refuses the
    /// scene changes nothing; a notice says why.
    void setDevice(DeviceOpener open);
    /// Holds or goes on.
    void setPaused(bool paused);
    /// When it holds by itself: within kFinestStep at first.
    void setStop(const StopRule& rule);
    /// Goes on beyond that, until there is another scene or another rule.
    void goOn();
    /// Shows nothing: scene, film and what the device keeps of them are given back soon.
    void clear();
    /// Calls `look` once, between two launches, as soon as the scene of `revision` has samples and interaction has
    /// ended. Errors: another scene has taken its place, it was closed, or it could not be rendered.
    void requestSnapshot(std::uint64_t revision, SnapshotObserver look);
    /// Measures what the effects of the scene cost while somebody looks: a launch now and then where the picture is at
    /// rest, in a twentieth of the time, and in all of it where rendering holds. Another scene comes first.
    void watchEffects(EffectsWatch watch);

  private:
    class Loop;
    std::unique_ptr<Loop> loop_;
};

}  // namespace pdr
