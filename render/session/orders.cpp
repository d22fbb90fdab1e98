#include "render/session/orders.h"

#include <utility>

namespace pdr {

void Orders::submit(Scene scene, bool moving) {
    const std::lock_guard lock(mutex_);
    scene_ = SceneOrder{std::move(scene), moving};
    running_.request_stop();
    changed_.notify_one();
}

void Orders::setDisplay(const Display& display) {
    const std::lock_guard lock(mutex_);
    display_ = display;
    displayChanged_ = true;
    changed_.notify_one();
}

void Orders::setPace(const Pace& pace) {
    const std::lock_guard lock(mutex_);
    pace_ = pace.clamped();
}

void Orders::setSchedule(const Schedule& schedule) {
    const std::lock_guard lock(mutex_);
    schedule_ = schedule;
    running_.request_stop();
    changed_.notify_one();
}

// The running step is not cancelled: its samples are to go along.
void Orders::setDevice(DeviceOpener open) {
    const std::lock_guard lock(mutex_);
    device_ = std::move(open);
    changed_.notify_one();
}

void Orders::setPaused(bool paused) {
    const std::lock_guard lock(mutex_);
    paused_ = paused;
    changed_.notify_one();
}

void Orders::inspect(FilmLook look) {
    const std::lock_guard lock(mutex_);
    looks_.push_back(std::move(look));
    changed_.notify_one();
}

void Orders::cancel() {
    const std::lock_guard lock(mutex_);
    running_.request_stop();
}

bool Orders::somethingToDo(const Situation& situation) const {
    const bool asked = scene_ || schedule_ || device_ || displayChanged_ || (situation.lookable && !looks_.empty());
    return asked || (situation.film && (!paused_ || situation.first || situation.unshown));
}

std::optional<Orders::Step> Orders::next(const Situation& situation, std::stop_token stop) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, stop, [&] { return somethingToDo(situation); });
    if (stop.stop_requested())
        return std::nullopt;
    running_ = std::stop_source();
    Step step;
    step.device = std::exchange(device_, nullptr);
    step.schedule = std::exchange(schedule_, std::nullopt);
    step.order = std::exchange(scene_, std::nullopt);
    step.render = !paused_ || situation.first || step.order || step.schedule;
    step.display = display_;
    step.pace = pace_;
    step.stop = running_.get_token();
    displayChanged_ = false;
    return step;
}

bool Orders::lookAsked() {
    const std::lock_guard lock(mutex_);
    return !looks_.empty();
}

std::vector<FilmLook> Orders::takeLooks() {
    const std::lock_guard lock(mutex_);
    return std::exchange(looks_, {});
}

}  // namespace pdr
