#pragma once
/// Records all frames that a session has shown, and makes a scene that it shows coarse first.

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "render/session/session.h"
#include "tests/support/scenes/scenes.h"

namespace pdr::test {

/// Makes a scene with more pixels than a session expects a processor to render at once.
inline Scene largeScene(std::uint64_t revision) {
    Scene scene = plainScene(bumpyVolume({20, 20, 20}, dvec3(1), 3), 1);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 600, .opacity = 1}};
    scene.film = {400, 300};
    scene.revision = revision;
    scene.camera.eyeMm.x += double(revision);
    scene.lookName = "look " + std::to_string(revision);
    return scene;
}

/// Records all frames in their order.
class Reel {
  public:
    FrameSink sink() {
        return [this](std::shared_ptr<const Frame> frame) {
            const std::lock_guard lock(mutex_);
            frames_.push_back(std::move(frame));
        };
    }
    std::vector<std::shared_ptr<const Frame>> frames() {
        const std::lock_guard lock(mutex_);
        return frames_;
    }
    /// Returns the frames of one scene.
    std::vector<std::shared_ptr<const Frame>> of(std::uint64_t revision) {
        std::vector<std::shared_ptr<const Frame>> chosen;
        for (const auto& frame : frames())
            if (frame->revision == revision)
                chosen.push_back(frame);
        return chosen;
    }
    /// Whether `count` full frames of a scene have arrived.
    bool full(std::uint64_t revision, int count = 1) {
        for (const auto& frame : of(revision))
            count -= !frame->coarse && !frame->rgba.empty();
        return count <= 0;
    }

  private:
    std::mutex mutex_;
    std::vector<std::shared_ptr<const Frame>> frames_;
};

}  // namespace pdr::test
