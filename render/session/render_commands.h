#pragma once
/// Requests to the render thread: a mailbox with one slot for each kind of command, where the newest wins.

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/scene/scene.h"
#include "render/session/session.h"
#include "render/session/stop_request.h"

namespace pdr {

class RenderCommands {
  public:
    struct SceneOrder {
        Scene scene;
        bool moving;
    };

    struct SnapshotRequest {
        std::uint64_t revision;  ///< revision of the scene to look at
        SnapshotObserver look;
    };

    /// State of the render thread.
    struct LoopState {
        bool scene = false;          ///< the thread has a scene
        bool film = false;           ///< the scene has a film
        std::uint64_t revision = 0;  ///< revision of the scene; 0 without one
        /// The first full image is still to come, or an iteration is incomplete; both are completed even while paused.
        bool owed = false;
        /// The next work may be wasted or in the way, because a user who has just moved soon moves on: wait kStill
        /// first.
        bool lingers = false;
        /// A scene of a drag still waits for its first image; newer ones of the drag wait for that.
        bool passing = false;
        ImageProgress progress;
        bool unshown = false;      ///< the film holds samples that have not been shown
        bool unjudged = false;     ///< its denoised image was judged with fewer samples
        bool canSnapshot = false;  ///< a snapshot can be taken
        bool unmeasured = false;   ///< costs of effects are still to be measured, and can be now
    };

    /// Next step of the render thread; members are in the order of execution.
    struct Iteration {
        bool clear = false;                         ///< forget the scene
        std::vector<SnapshotRequest> unanswerable;  ///< snapshot requests that can never be answered
        DeviceOpener device;                        ///< opens the device to continue on; empty: no change
        std::optional<EffectsWatch> watch;          ///< observer of the costs of effects; none: no change
        std::optional<SceneOrder> order;
        bool idle = false;       ///< the image can stay as it is
        bool render = false;     ///< take more iterations, if there is a film
        bool redisplay = false;  ///< the display changed: first show the existing image
        FrameBudget pace;
        std::optional<std::size_t> keptMemory;  ///< most memory of kept films [bytes]; none: no change
        std::stop_token stop;                   ///< stops this step
        std::stop_token detour;  ///< stops work that is no part of its image; another display does so, too
    };

    void submit(Scene scene, bool moving);
    void setDisplay(const Display& display);
    /// Sets whether an error map is requested, and shows the current image again.
    void setErrorMap(bool wanted);
    /// Sets the region, and shows the current image again with the region's status.
    void setRegion(const std::optional<Region>& region);
    void setPace(const FrameBudget& pace);
    void setKeptMemory(std::size_t bytes);
    void setDevice(DeviceOpener open);
    void setPaused(bool paused);
    void setYielding(bool yielding);
    /// Sets the stop rule, and shows the current image again with whether it meets the rule.
    void setStop(const StopRule& rule);
    /// Continues beyond the stop rule, until another scene or another rule is set.
    void goOn();
    void clear();
    void requestSnapshot(std::uint64_t revision, SnapshotObserver look);
    void watchEffects(EffectsWatch watch);
    /// Returns the stop rule with what suspends it, and the pause.
    StopRequest stopRequest();
    /// Returns whether an error map is requested.
    bool errorMap();
    std::optional<Region> region();
    /// Returns the newest display. It may change between the beginning and the end of a step.
    Display display();
    /// Cancels the running step.
    void cancel();

    /// Waits until there is something to do. Returns nothing after a stop request.
    std::optional<Iteration> next(const LoopState& state, std::stop_token stop);
    /// Returns whether snapshots of the scene of `revision` are requested; takeSnapshotRequests() removes and returns
    /// them.
    bool snapshotRequested(std::uint64_t revision);
    std::vector<SnapshotRequest> takeSnapshotRequests(std::uint64_t revision);

  private:
    /// How long the pointer may stand still before it counts as resting.
    static constexpr auto kStill = std::chrono::milliseconds(100);

    bool asked(const LoopState& state) const;
    bool isDue(const LoopState& state) const;
    bool isToCome(std::uint64_t revision) const;
    bool renders(const LoopState& state) const;
    std::vector<SnapshotRequest> takeUnanswerable(const LoopState& state, const Iteration& step);
    void breakOff();

    std::mutex mutex_;  ///< guards all members below
    std::condition_variable_any changed_;
    std::optional<SceneOrder> scene_;
    std::optional<std::uint64_t> newest_;  ///< revision of the scene that was submitted last
    bool passing_ = false;                 ///< see LoopState; of the running step
    DeviceOpener device_;
    std::optional<EffectsWatch> watch_;
    Display display_;
    bool displayChanged_ = false;
    bool errorMap_ = false;
    std::optional<Region> region_;
    FrameBudget pace_;
    std::optional<std::size_t> keptMemory_;
    StopRequest stop_;
    bool yields_ = false;  ///< nothing is done that no request asks for
    bool clear_ = false;
    std::vector<SnapshotRequest> looks_;
    std::stop_source running_, detour_;  ///< see Iteration
};

}  // namespace pdr
