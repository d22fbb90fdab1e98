#pragma once
/// The prepared scene that all look-ups of places share: crosshair, measurements, clicks and the menu ask about one
/// image, which is prepared once for all of them.

#include <memory>
#include <mutex>
#include <optional>

#include "render/prepare/flatten.h"
#include "render/scene/scene.h"

namespace pdr::app {

/// Prepares scenes for several threads, and keeps the newest.
class PlaceScene {
  public:
    /// Returns `scene` prepared; it must have passed Scene::check(). Threads that ask for the same one share it, and
    /// wait for the one that prepares it. Can be called on any thread.
    std::shared_ptr<const PreparedScene> prepared(const Scene& scene);
    /// Returns how many scenes have been prepared. Can be called on any thread.
    int preparations() const;

  private:
    mutable std::mutex mutex_;
    Flattener flattener_;
    std::optional<Scene> scene_;  ///< the newest; none before the first
    std::shared_ptr<const PreparedScene> prepared_;
    int preparations_ = 0;
};

/// What several PlaceJobs share. Used on the window's thread alone; only what current() returns goes to others.
class PlaceScenes {
  public:
    const std::shared_ptr<PlaceScene>& current() const { return current_; }
    /// Releases the volume, as soon as the jobs that still look at it have ended.
    void drop() { current_ = std::make_shared<PlaceScene>(); }

  private:
    std::shared_ptr<PlaceScene> current_ = std::make_shared<PlaceScene>();
};

}  // namespace pdr::app
