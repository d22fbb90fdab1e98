#pragma once
/// What others ask of the render thread: a mailbox with one slot for each kind of command, where the newest wins.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/scene/scene.h"
#include "render/session/session.h"

namespace pdr {

class RenderCommands {
  public:
    struct SceneOrder {
        Scene scene;
        bool moving;
    };

    struct SnapshotRequest {
        std::uint64_t revision;  ///< of the scene that is to be looked at
        SnapshotObserver look;
    };

    /// How far the full picture is that was shown last.
    struct Progress {
        std::optional<double> displayError;  ///< of its region where that is more; none: there is no such picture
        double seconds = 0;
        std::uint64_t samples = 0;  ///< per pixel
    };

    /// Where the render thread stands.
    struct LoopState {
        bool scene = false;          ///< there is one
        bool film = false;           ///< there is one of it
        std::uint64_t revision = 0;  ///< of the scene
        bool owed = false;           ///< its first full picture is still to come, or an iteration is half made; that
                                     ///< much is made even while paused
        bool lingers = false;        ///< what comes next may be in vain, or in the way: a hand that moves soon moves on
        Progress progress;
        bool unshown = false;      ///< the film holds what has not been shown
        bool unjudged = false;     ///< what is said of its smoothed picture is of fewer samples
        bool canSnapshot = false;  ///< it can be looked at
        bool unmeasured = false;   ///< what effects cost is to be measured, and can be now
    };

    /// What the render thread does next, in the order in which it does it.
    struct Iteration {
        bool clear = false;                         ///< forget the scene
        std::vector<SnapshotRequest> unanswerable;  ///< looks at what is not there and will not come
        DeviceOpener device;                        ///< go on there; empty: as before
        std::optional<EffectsWatch> watch;          ///< who looks at what effects cost; none: as before
        std::optional<SceneOrder> order;
        bool idle = false;       ///< the picture can stay as it is
        bool render = false;     ///< more iterations, if there is a film
        bool redisplay = false;  ///< the display is another one: first show what is there
        FrameBudget pace;
        std::stop_token stop;    ///< of this step
        std::stop_token detour;  ///< of what is no part of its picture: another display ends that, too
    };

    void submit(Scene scene, bool moving);
    void setDisplay(const Display& display);
    /// What is there is shown again, with a map.
    void setErrorMap(bool wanted);
    /// What is there is shown again, with how good that part is.
    void setRegion(const std::optional<Region>& region);
    void setPace(const FrameBudget& pace);
    void setDevice(DeviceOpener open);
    void setPaused(bool paused);
    /// What is there is shown again, with whether it is as good as is wanted now.
    void setStop(const StopRule& rule);
    /// Also beyond that, until there is another scene or another rule.
    void goOn();
    void clear();
    void requestSnapshot(std::uint64_t revision, SnapshotObserver look);
    void watchEffects(EffectsWatch watch);
    StopRule stop();
    /// Whether a picture that is so far is left as it is.
    bool holdsAt(const Progress& progress);
    /// Whether one is wanted.
    bool errorMap();
    std::optional<Region> region();
    /// The newest: what a step shows at its end is not what was wanted at its beginning.
    Display display();
    /// Cancels the running step.
    void cancel();

    /// Waits until there is something to do; nothing after a stop request.
    std::optional<Iteration> next(const LoopState& state, std::stop_token stop);
    /// Whether somebody wants to look at the scene of `revision`, and all who do.
    bool snapshotRequested(std::uint64_t revision);
    std::vector<SnapshotRequest> takeSnapshotRequests(std::uint64_t revision);

  private:
    /// How long a hand may stand still before it counts as one that rests.
    static constexpr auto kStill = std::chrono::milliseconds(100);

    bool asked(const LoopState& state) const;
    bool isReached(const Progress& progress) const;
    bool renders(const LoopState& state) const;
    std::vector<SnapshotRequest> takeUnanswerable(const LoopState& state, const Iteration& step);
    void breakOff();

    std::mutex mutex_;  ///< of all that follows
    std::condition_variable_any changed_;
    std::optional<SceneOrder> scene_;
    std::optional<std::uint64_t> newest_;  ///< revision of the scene that was submitted last
    DeviceOpener device_;
    std::optional<EffectsWatch> watch_;
    Display display_;
    bool displayChanged_ = false;
    bool errorMap_ = false;
    std::optional<Region> region_;
    FrameBudget pace_;
    bool paused_ = false;
    StopRule stop_;
    bool beyond_ = false;  ///< it does not count for this scene
    bool clear_ = false;
    std::vector<SnapshotRequest> looks_;
    std::stop_source running_, detour_;  ///< see Iteration
};

}  // namespace pdr
