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
    std::uint64_t revision = 0;  ///< of the Scene that it shows
    ivec2 size{0};               ///< pixels; smaller than scene.film while the hand moves: stretch it
    std::vector<std::uint8_t> rgba;  ///< 4 bytes a pixel, row by row from the top
    FilmStatus status;
    double seconds = 0;              ///< spent on this revision
    double iterationsPerSecond = 0;  ///< lately
    std::string error;               ///< for the user, when rendering failed; the picture is then empty
};

/// Called on the render thread; must return soon.
using FrameSink = std::function<void(std::shared_ptr<const Frame>)>;

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

  private:
    class Loop;
    std::unique_ptr<Loop> loop_;
};

}  // namespace pdr
