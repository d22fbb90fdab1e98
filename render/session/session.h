#pragma once
/// The render session: a render thread that takes the newest Scene and delivers frames. If a device fails, at most a
/// few seconds of samples are lost, and rendering continues on another device.

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
#include "render/film/display/denoised_view.h"
#include "render/film/error/level_error_map.h"
#include "render/film/error/shown_status.h"
#include "render/film/film.h"
#include "render/scene/camera.h"
#include "render/scene/clip.h"
#include "render/scene/model.h"
#include "render/session/region.h"
#include "render/timing/frame_budget.h"

namespace pdr {

struct EffectCosts;
struct Scene;

/// When an image was made, on the session's clock [s].
struct FrameTimes {
    double taken = 0;    ///< the render thread took the scene
    double begun = 0;    ///< the device had the scene
    double sampled = 0;  ///< the image had its samples
    double made = 0;     ///< the frame was complete
};

/// One displayed image, or an error or notice for the user.
struct Frame {
    std::uint64_t revision = 0;  ///< revision of the scene that the frame belongs to
    // Copied from that scene, so that the text beside the image always matches it:
    Camera camera;
    std::string lookName;
    bool maskAwaited = false;
    Text notShown;  ///< what the scene's mask hides, in sentences; empty without a mask
    Clip clip;
    bool ctDenoised = false;  ///< whether the scene's volume is a scan with less noise
    Estimator estimator = Estimator::unbiased;
    bool coarse = false;             ///< first image of an edit or image during interaction; finer ones follow at rest
    ivec2 size{0};                   ///< pixels; fewer than Scene::film if coarse: stretch the image
    Display display;                 ///< requested display that the image was made for
    std::vector<std::uint8_t> rgba;  ///< 4 bytes per pixel, row by row from the top; empty with an error or a notice
    FilmStatus status;
    bool denoised = false;                       ///< `rgba` is denoised; the status is still that of the film
    std::optional<DenoisedError> denoisedError;  ///< error of the denoised image; none if not known yet
    std::vector<denoise::LostLine> lostLines;  ///< known to be missing in the denoised image; empty: none, or not known
    BiasFacts bias;                            ///< complete except for `image`, `view` and `denoised`
    double seconds = 0;                        ///< rendering time of the film [s]
    std::vector<QualityStep> steps;  ///< with the times when they were or will be reached; see ErrorHistory::steps()
    double iterationsPerSecond = 0;  ///< median of recent frames
    std::uint32_t iterations = 0;    ///< n, the iterations per displayed frame
    double efficiency = 0;           ///< fraction of recent time spent on iterations, (0, 1]; 0: not known
    std::string device;              ///< its name: "cpu"
    Schedule schedule;
    StopRule stop;                    ///< rule that decides when rendering stops
    bool reached = false;             ///< the rule is met: rendering stops until more is requested
    Text error;                       ///< message for the user if rendering failed and stopped; else empty
    Text notice;                      ///< sentences for the user if rendering continues, but not as requested
    FrameTimes times;                 ///< zeros in a frame that repeats an earlier image
    std::vector<ErrorPoint> history;  ///< error over time; see ErrorHistory::points()
    /// Error map of the image, from at most as many samples as the film has; null if not requested or coarse.
    std::shared_ptr<const LevelErrorMap> errorMap;
    std::optional<RegionStatus> region;  ///< status of the region; none if no region is set or nothing is known yet
};

/// Returns how good the image of a frame is.
inline ShownStatus shownOf(const Frame& frame) {
    return shownStatus(frame.status, frame.denoised, frame.denoisedError);
}

/// Receives each frame. Called on the render thread; must return soon.
using FrameSink = std::function<void(std::shared_ptr<const Frame>)>;

/// Everything known about the current image.
struct FilmView {
    const Film& film;
    const Scene& scene;         ///< scene that the film shows
    double seconds;             ///< rendering time spent on the film
    const std::string& device;  ///< its name: "cpu"
    MeasuredBiases bias;        ///< biases that are known only by measurement
    StopRule stop;              ///< see Frame::stop
    /// State of the denoised image that the screen shows; null if none is shown. A caller that judges the image anew
    /// also changes what the screen states.
    DenoisedView* denoised = nullptr;
};

/// Receives the film, or the reason why there is none. Called on the render thread.
using SnapshotObserver = std::function<void(const Result<FilmView>&)>;

/// Opens a device. Called on the render thread, so it may take its time.
using DeviceOpener = std::function<Result<std::unique_ptr<Device>>()>;

/// Receives the current cost table of the effects. Called on the render thread; must return soon.
using EffectsObserver = std::function<void(std::shared_ptr<const EffectCosts>)>;

/// Observer of the costs of effects, and the device on which they are measured apart from the image. Both are empty if
/// nobody observes.
struct EffectsWatch {
    DeviceOpener device;  ///< called twice: for images with an effect and for images without it
    EffectsObserver look;
};

/// Returns the seconds since a fixed moment. Called on the render thread.
using SessionClock = std::function<double()>;
/// Returns the seconds of the monotonic system clock.
double steadySeconds();

class Session {
  public:
    /// Takes over `device`. `fallback` opens a replacement if the device in use fails or refuses a scene; without
    /// it, that is an error. `clock` measures how long things take.
    Session(std::unique_ptr<Device> device, FrameSink sink, DeviceOpener fallback = {},
            SessionClock clock = steadySeconds);
    ~Session();  ///< stops rendering within one launch

    /// Renders `scene` from now on; a running launch for an older scene is cancelled. The first frame comes soon and is
    /// coarse, unless the device can render a full one equally soon. Finer frames follow as soon as they are no worse.
    /// `moving`: the user still drags, so finer frames follow only while the pointer stands still; such scenes are
    /// taken one at a time, so that each that is taken is seen, and the newest comes next. Submit the scene again with
    /// false when the drag ends.
    void submit(Scene scene, bool moving);
    /// Shows the current film with other display settings; rendering does not restart.
    void setDisplay(const Display& display);
    /// Sets whether full images come with an error map. The current image gets one at once.
    void setErrorMap(bool wanted);
    /// Sets the part of the image that gets its samples first, until it is within the target; none: the whole image.
    /// The region stays where it is when the scene changes.
    void setRegion(const std::optional<Region>& region);
    /// Sets how many iterations a displayed frame gets.
    void setPace(const FrameBudget& pace);
    /// Sets the most memory that films of earlier scenes take together [bytes], which come back at once with their
    /// scene; at first KeptFilms::kMostBytes.
    void setKeptMemory(std::size_t bytes);
    /// Sets n, a fixed number of iterations per displayed frame, [1, 10000].
    void setIterationsPerFrame(int n);
    /// Continues on another device, from the samples taken so far. If the device cannot be opened or refuses the scene,
    /// nothing changes and a notice says why.
    void setDevice(DeviceOpener open);
    /// Pauses or resumes rendering.
    void setPaused(bool paused);
    /// Sets whether rendering waits, after the running launch, since the processor is needed for something that must
    /// not wait. Unlike with a pause, an incomplete image stays incomplete. Requests are still answered.
    void setYielding(bool yielding);
    /// Sets when rendering stops by itself; initially within kFinestStep.
    void setStop(const StopRule& rule);
    /// Continues beyond the stop rule, until another scene or another rule is set.
    void goOn();
    /// Shows nothing. The scene, the film and what the device keeps of them are freed soon.
    void clear();
    /// Calls `look` once, between two launches, as soon as the scene of `revision` has samples and interaction has
    /// ended. Errors: another scene replaced it, it was closed, or it could not be rendered.
    void requestSnapshot(std::uint64_t revision, SnapshotObserver look);
    /// Measures what the effects of the scene cost while there is an observer. While the image is at rest, this is an
    /// occasional launch, in a twentieth of the time; while rendering is stopped, it is all of the time. Another scene
    /// takes precedence.
    void watchEffects(EffectsWatch watch);

  private:
    class Loop;
    std::unique_ptr<Loop> loop_;
};

}  // namespace pdr
