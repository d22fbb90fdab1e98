#pragma once
/// What others ask of the render thread: a mailbox with one slot for each kind of command, where the newest wins.

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

    /// Where the render thread stands.
    struct LoopState {
        bool scene = false;          ///< there is one
        bool film = false;           ///< there is one of it
        std::uint64_t revision = 0;  ///< of the scene
        bool first = false;          ///< its first picture is still to come; that one is made even while paused
        bool unshown = false;        ///< the film holds what has not been shown
        bool canSnapshot = false;    ///< it can be looked at
    };

    /// What the render thread does next, in the order in which it does it.
    struct Iteration {
        bool clear = false;                         ///< forget the scene
        std::vector<SnapshotRequest> unanswerable;  ///< looks at what is not there and will not come
        DeviceOpener device;                        ///< go on there; empty: as before
        std::optional<SceneOrder> order;
        bool render = false;  ///< more iterations, if there is a film
        FrameBudget pace;
        std::stop_token stop;  ///< of this step
    };

    void submit(Scene scene, bool moving);
    void setDisplay(const Display& display);
    void setPace(const FrameBudget& pace);
    void setDevice(DeviceOpener open);
    void setPaused(bool paused);
    void clear();
    void requestSnapshot(std::uint64_t revision, SnapshotObserver look);
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
    bool somethingToDo(const LoopState& state) const;
    std::vector<SnapshotRequest> takeUnanswerable(const LoopState& state, const Iteration& step);

    std::mutex mutex_;  ///< of all that follows
    std::condition_variable_any changed_;
    std::optional<SceneOrder> scene_;
    DeviceOpener device_;
    Display display_;
    bool displayChanged_ = false;
    FrameBudget pace_;
    bool paused_ = false;
    bool clear_ = false;
    std::vector<SnapshotRequest> looks_;
    std::stop_source running_;
};

}  // namespace pdr
