#pragma once
/// The scenes that leases refer to: one for the viewport and one for a final render, which has priority. Not
/// thread-safe: see pool_state.h.

#include <cstdint>
#include <memory>

#include "render/scene/scene.h"

namespace pdr {

/// Purpose of an image. There may be one image of each purpose at a time: workers then sample the final render, and the
/// viewport continues with its own device alone.
enum class Purpose {
    viewport,    ///< the interactive image
    finalRender  ///< an image for a file
};

/// The scene that leases refer to.
struct PublishedScene {
    std::uint64_t number = 0;            ///< unique; 0: nothing was published yet
    std::shared_ptr<const Scene> scene;  ///< null: withdrawn, workers erase what they have
    Purpose purpose = Purpose::viewport;
};

class PublishedScenes {
  public:
    /// Sets the scene for that purpose; null: there is none. Returns its number.
    std::uint64_t publish(Purpose purpose, std::shared_ptr<const Scene> scene);
    /// Removes the scene with that number. False: it was removed or replaced before.
    bool withdraw(std::uint64_t number);
    /// Returns the scene that workers are to load: that of the final render, if there is one.
    const PublishedScene& current() const { return finalRender_.scene ? finalRender_ : viewport_; }

  private:
    std::uint64_t set(PublishedScene& published, std::shared_ptr<const Scene> scene);

    PublishedScene viewport_{}, finalRender_{0, nullptr, Purpose::finalRender};
    std::uint64_t last_ = 0;  ///< number of the last published scene
};

}  // namespace pdr
