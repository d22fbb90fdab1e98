#pragma once
/// What others ask of the render thread: a letter box with one place for each matter, where the newest wins.

#include <condition_variable>
#include <mutex>
#include <optional>
#include <stop_token>
#include <vector>

#include "render/session/session.h"

namespace pdr {

class Orders {
  public:
    struct SceneOrder {
        Scene scene;
        bool moving;
    };

    struct LookOrder {
        std::uint64_t revision;  ///< of the scene that is to be looked at
        FilmLook look;
    };

    /// Where the render thread stands.
    struct Situation {
        bool scene = false;     ///< there is one
        bool film = false;      ///< there is one of it
        std::uint64_t revision = 0;  ///< of the scene
        bool first = false;     ///< its first picture is still to come; that one is made even while paused
        bool unshown = false;   ///< the film holds what has not been shown
        bool lookable = false;  ///< it can be looked at
    };

    /// What the render thread does next, in the order in which it does it.
    struct Step {
        bool clear = false;                ///< forget the scene
        std::vector<LookOrder> unanswerable;  ///< looks at what is not there and will not come
        DeviceOpener device;  ///< go on there; empty: as before
        std::optional<Schedule> schedule;
        std::optional<SceneOrder> order;
        bool render = false;  ///< more iterations, if there is a film
        Pace pace;
        std::stop_token stop;  ///< of this step
    };

    void submit(Scene scene, bool moving);
    void setDisplay(const Display& display);
    void setPace(const Pace& pace);
    void setSchedule(const Schedule& schedule);
    void setDevice(DeviceOpener open);
    void setPaused(bool paused);
    void clear();
    void inspect(std::uint64_t revision, FilmLook look);
    /// The newest: what a step shows at its end is not what was wanted at its beginning.
    Display display();
    /// Cancels the running step.
    void cancel();

    /// Waits until there is something to do; nothing after a stop request.
    std::optional<Step> next(const Situation& situation, std::stop_token stop);
    /// Whether somebody wants to look at the scene of `revision`, and all who do.
    bool lookAsked(std::uint64_t revision);
    std::vector<LookOrder> takeLooks(std::uint64_t revision);

  private:
    bool somethingToDo(const Situation& situation) const;
    std::vector<LookOrder> takeUnanswerable(const Situation& situation, const Step& step);

    std::mutex mutex_;  ///< of all that follows
    std::condition_variable_any changed_;
    std::optional<SceneOrder> scene_;
    std::optional<Schedule> schedule_;
    DeviceOpener device_;
    Display display_;
    bool displayChanged_ = false;
    Pace pace_;
    bool paused_ = false;
    bool clear_ = false;
    std::vector<LookOrder> looks_;
    std::stop_source running_;
};

}  // namespace pdr
