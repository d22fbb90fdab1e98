#include "ui/view/edited_camera.h"

#include <chrono>

namespace pdr::ui {
namespace {

constexpr auto kRestAfter = std::chrono::milliseconds(250);

}  // namespace

EditedCamera::EditedCamera() {
    restTimer_.setSingleShot(true);
    restTimer_.setInterval(kRestAfter);
    connect(&restTimer_, &QTimer::timeout, this, &EditedCamera::rest);
}

void EditedCamera::set(const std::optional<Camera>& camera) {
    camera_ = camera;
    if (!camera_)
        moved_ = false;
}

void EditedCamera::edit(const Camera& camera) {
    camera_ = camera;
    moved_ = true;
    emit edited(camera, true);
}

void EditedCamera::step(const Camera& camera) {
    edit(camera);
    restTimer_.start();
}

void EditedCamera::letGo() {
    held_ = false;
    rest();
}

void EditedCamera::rest() {
    if (held_ || !moved_)
        return;
    restTimer_.stop();
    moved_ = false;
    emit edited(*camera_, false);
}

}  // namespace pdr::ui
