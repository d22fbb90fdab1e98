#pragma once
/// The render loop on its own thread: newest Scene in, frames out.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/device/device.h"
#include "render/film/display.h"
#include "render/film/film.h"
#include "render/scene/scene.h"

namespace pdr {

/// One displayed picture.
struct Frame {
    std::uint64_t revision = 0;      ///< of the Scene that it shows
    ivec2 size{0};                   ///< pixels; smaller than scene.film while the hand moves: stretch it
    std::vector<std::uint8_t> rgba;  ///< 4 bytes a pixel, row by row from the top
    FilmStatus status;
    double seconds = 0;              ///< spent on this revision
    double iterationsPerSecond = 0;  ///< lately
    std::string error;               ///< for the user, when rendering failed; the picture is then empty
};

/// Called on the render thread; must return soon.
using FrameSink = std::function<void(std::shared_ptr<const Frame>)>;

/// Called on the render thread with all that is known about the picture, the scene that it shows, and the seconds
/// spent.
using FilmLook = std::function<void(const Film& film, const Scene& scene, double seconds)>;

class Session {
  public:
    Session(std::unique_ptr<Device> device, FrameSink sink);
    ~Session();  ///< stops within one launch

    /// Renders `scene` from now on; a running launch for an older one is cancelled. `moving`: the hand still drags, so
    /// frames come soon and coarse; submit again with false when it rests.
    void submit(Scene scene, bool moving);
    /// Shows what is there with other display settings, without a restart.
    void setDisplay(const Display& display);
    /// n, the iterations per displayed frame; [1, 10000].
    void setIterationsPerFrame(int n);
    /// Holds or goes on.
    void setPaused(bool paused);
    /// Calls `look` once, between two launches, as soon as the newest scene has a picture and the hand rests.
    void inspect(FilmLook look);

  private:
    class Loop;
    std::unique_ptr<Loop> loop_;
};

}  // namespace pdr
