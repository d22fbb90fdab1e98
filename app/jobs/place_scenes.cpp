#include "app/jobs/place_scenes.h"

namespace pdr::app {

std::shared_ptr<const PreparedScene> PlaceScene::prepared(const Scene& scene) {
    const std::lock_guard lock(mutex_);
    if (scene_ != scene) {
        prepared_ = flattener_.prepare(scene);
        scene_ = scene;
        ++preparations_;
    }
    return prepared_;
}

int PlaceScene::preparations() const {
    const std::lock_guard lock(mutex_);
    return preparations_;
}

}  // namespace pdr::app
