#include "render/session/orders.h"

#include <algorithm>
#include <utility>

namespace pdr {

namespace {

/// Takes the looks out that `wanted` holds for.
template <class Wanted>
std::vector<Orders::LookOrder> taken(std::vector<Orders::LookOrder>& looks, Wanted&& wanted) {
    const auto first = std::stable_partition(looks.begin(), looks.end(), [&](const auto& look) { return !wanted(look); });
    std::vector<Orders::LookOrder> out(std::make_move_iterator(first), std::make_move_iterator(looks.end()));
    looks.erase(first, looks.end());
    return out;
}

}  // namespace

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

Display Orders::display() {
    const std::lock_guard lock(mutex_);
    return display_;
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

void Orders::clear() {
    const std::lock_guard lock(mutex_);
    scene_.reset();
    clear_ = true;
    running_.request_stop();
    changed_.notify_one();
}

void Orders::inspect(std::uint64_t revision, FilmLook look) {
    const std::lock_guard lock(mutex_);
    looks_.push_back({revision, std::move(look)});
    changed_.notify_one();
}

void Orders::cancel() {
    const std::lock_guard lock(mutex_);
    running_.request_stop();
}

bool Orders::somethingToDo(const Situation& situation) const {
    const bool look = std::any_of(looks_.begin(), looks_.end(), [&](const LookOrder& look) {
        return !situation.film || situation.lookable || look.revision != situation.revision;
    });
    const bool asked = clear_ || scene_ || schedule_ || device_ || displayChanged_ || look;
    return asked || (situation.film && (!paused_ || situation.first || situation.unshown));
}

std::optional<Orders::Step> Orders::next(const Situation& situation, std::stop_token stop) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, stop, [&] { return somethingToDo(situation); });
    if (stop.stop_requested())
        return std::nullopt;
    running_ = std::stop_source();
    Step step;
    step.clear = std::exchange(clear_, false);
    step.device = std::exchange(device_, nullptr);
    step.schedule = std::exchange(schedule_, std::nullopt);
    step.order = std::exchange(scene_, std::nullopt);
    step.render = !paused_ || situation.first || step.order || step.schedule;
    step.pace = pace_;
    step.stop = running_.get_token();
    step.unanswerable = takeUnanswerable(situation, step);
    displayChanged_ = false;
    return step;
}

/// Scenes are submitted before they are looked at: what is neither there nor in this step will not come.
std::vector<Orders::LookOrder> Orders::takeUnanswerable(const Situation& situation, const Step& step) {
    const bool stays = !step.clear && (situation.film || (situation.scene && (step.schedule || step.device)));
    const std::uint64_t revision = step.order ? step.order->scene.revision : situation.revision;
    return taken(looks_, [&](const LookOrder& look) { return !(step.order || stays) || look.revision != revision; });
}

bool Orders::lookAsked(std::uint64_t revision) {
    const std::lock_guard lock(mutex_);
    return std::any_of(looks_.begin(), looks_.end(), [&](const LookOrder& look) { return look.revision == revision; });
}

std::vector<Orders::LookOrder> Orders::takeLooks(std::uint64_t revision) {
    const std::lock_guard lock(mutex_);
    return taken(looks_, [&](const LookOrder& look) { return look.revision == revision; });
}

}  // namespace pdr
