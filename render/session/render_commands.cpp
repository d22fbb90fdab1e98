#include "render/session/render_commands.h"

#include <algorithm>
#include <utility>

namespace pdr {

namespace {

/// Removes and returns the snapshot requests for which `wanted` is true.
template <class Wanted>
std::vector<RenderCommands::SnapshotRequest> taken(std::vector<RenderCommands::SnapshotRequest>& looks,
                                                   Wanted&& wanted) {
    const auto first =
        std::stable_partition(looks.begin(), looks.end(), [&](const auto& look) { return !wanted(look); });
    std::vector<RenderCommands::SnapshotRequest> out(std::make_move_iterator(first),
                                                     std::make_move_iterator(looks.end()));
    looks.erase(first, looks.end());
    return out;
}

}  // namespace

/// When a drag ends without a change, the same revision is submitted again: its film continues. The image of a drag
/// that is being made is not broken off by the next scene of the drag: a mouse that reports faster than images are made
/// would leave none.
void RenderCommands::submit(Scene scene, bool moving) {
    const std::lock_guard lock(mutex_);
    if (newest_ != scene.revision) {
        if (!moving || !passing_)
            breakOff();
        stop_.isSuspended = false;
    }
    newest_ = scene.revision;
    scene_ = SceneOrder{std::move(scene), moving};
    changed_.notify_one();
}

void RenderCommands::setDisplay(const Display& display) {
    const std::lock_guard lock(mutex_);
    if (display == display_)
        return;
    displayChanged_ = true;
    display_ = display;
    detour_.request_stop();
    changed_.notify_one();
}

Display RenderCommands::display() {
    const std::lock_guard lock(mutex_);
    return display_;
}

void RenderCommands::setErrorMap(bool wanted) {
    const std::lock_guard lock(mutex_);
    displayChanged_ = displayChanged_ || wanted != errorMap_;
    errorMap_ = wanted;
    changed_.notify_one();
}

bool RenderCommands::errorMap() {
    const std::lock_guard lock(mutex_);
    return errorMap_;
}

void RenderCommands::setPace(const FrameBudget& pace) {
    const std::lock_guard lock(mutex_);
    pace_ = pace.clamped();
}

void RenderCommands::setKeptMemory(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    keptMemory_ = bytes;
    changed_.notify_one();
}

void RenderCommands::setRegion(const std::optional<Region>& region) {
    const std::lock_guard lock(mutex_);
    displayChanged_ = displayChanged_ || region != region_;
    region_ = region;
    changed_.notify_one();
}

std::optional<Region> RenderCommands::region() {
    const std::lock_guard lock(mutex_);
    return region_;
}

// The running step is not cancelled, so that the new device gets its samples, too.
void RenderCommands::setDevice(DeviceOpener open) {
    const std::lock_guard lock(mutex_);
    device_ = std::move(open);
    changed_.notify_one();
}

void RenderCommands::setPaused(bool paused) {
    const std::lock_guard lock(mutex_);
    stop_.isPaused = paused;
    changed_.notify_one();
}

void RenderCommands::setYielding(bool yielding) {
    const std::lock_guard lock(mutex_);
    yields_ = yielding;
    changed_.notify_one();
}

void RenderCommands::setStop(const StopRule& rule) {
    const std::lock_guard lock(mutex_);
    if (rule == stop_.rule)
        return;
    stop_.rule = rule;
    stop_.isSuspended = false;
    displayChanged_ = true;
    changed_.notify_one();
}

void RenderCommands::goOn() {
    const std::lock_guard lock(mutex_);
    stop_.isSuspended = true;
    changed_.notify_one();
}

StopRequest RenderCommands::stopRequest() {
    const std::lock_guard lock(mutex_);
    return stop_;
}

void RenderCommands::clear() {
    const std::lock_guard lock(mutex_);
    scene_.reset();
    newest_.reset();
    clear_ = true;
    breakOff();
    changed_.notify_one();
}

void RenderCommands::requestSnapshot(std::uint64_t revision, SnapshotObserver look) {
    const std::lock_guard lock(mutex_);
    looks_.push_back({revision, std::move(look)});
    changed_.notify_one();
}

void RenderCommands::watchEffects(EffectsWatch watch) {
    const std::lock_guard lock(mutex_);
    watch_ = std::move(watch);
    changed_.notify_one();
}

void RenderCommands::cancel() {
    const std::lock_guard lock(mutex_);
    breakOff();
}

void RenderCommands::breakOff() {
    running_.request_stop();
    detour_.request_stop();
}

/// Returns whether a scene is waiting that can be taken now.
bool RenderCommands::isDue(const LoopState& state) const {
    return scene_ && !(scene_->moving && state.passing);
}

/// Returns whether the scene of `revision` is waiting, whether or not it can be taken now.
bool RenderCommands::isToCome(std::uint64_t revision) const {
    return scene_ && scene_->scene.revision == revision;
}

/// Returns whether a request is waiting that can be handled now.
bool RenderCommands::asked(const LoopState& state) const {
    const bool look = std::any_of(looks_.begin(), looks_.end(), [&](const SnapshotRequest& look) {
        return !state.film || state.canSnapshot || (look.revision != state.revision && !isToCome(look.revision));
    });
    return clear_ || isDue(state) || device_ || displayChanged_ || keptMemory_ || look;
}

bool RenderCommands::renders(const LoopState& state) const {
    return !yields_ && (!stop_.stopsAt(state.progress) || state.owed);
}

std::optional<RenderCommands::Iteration> RenderCommands::next(const LoopState& state, std::stop_token stop) {
    std::unique_lock lock(mutex_);
    // Wait for a request or for work
    if (state.lingers)
        changed_.wait_for(lock, stop, kStill, [&] { return asked(state); });
    const auto busy = [&] {
        return asked(state) || (state.film && (renders(state) || state.unshown || state.unjudged));
    };
    changed_.wait(lock, stop, [&] { return asked(state) || (!yields_ && (busy() || watch_ || state.unmeasured)); });
    if (stop.stop_requested())
        return std::nullopt;
    // Take all waiting requests
    running_ = std::stop_source();
    detour_ = std::stop_source();
    Iteration step;
    step.idle = !busy();
    step.clear = std::exchange(clear_, false);
    step.device = std::exchange(device_, nullptr);
    step.watch = std::exchange(watch_, std::nullopt);
    if (isDue(state))
        step.order = std::exchange(scene_, std::nullopt);
    passing_ = step.order ? step.order->moving : state.passing;
    step.render = renders(state) || step.order;
    step.redisplay = displayChanged_;
    step.pace = pace_;
    step.keptMemory = std::exchange(keptMemory_, std::nullopt);
    step.stop = running_.get_token();
    step.detour = detour_.get_token();
    step.unanswerable = takeUnanswerable(state, step);
    displayChanged_ = false;
    return step;
}

/// Removes and returns the snapshot requests that can never be answered. A scene is submitted before its snapshot is
/// requested, so a scene that is neither current nor in this step nor waiting will not come.
std::vector<RenderCommands::SnapshotRequest> RenderCommands::takeUnanswerable(const LoopState& state,
                                                                              const Iteration& step) {
    const bool stays = !step.clear && (state.film || (state.scene && step.device));
    const std::uint64_t revision = step.order ? step.order->scene.revision : state.revision;
    return taken(looks_, [&](const SnapshotRequest& look) {
        return !isToCome(look.revision) && (!(step.order || stays) || look.revision != revision);
    });
}

bool RenderCommands::snapshotRequested(std::uint64_t revision) {
    const std::lock_guard lock(mutex_);
    return std::any_of(looks_.begin(), looks_.end(),
                       [&](const SnapshotRequest& look) { return look.revision == revision; });
}

std::vector<RenderCommands::SnapshotRequest> RenderCommands::takeSnapshotRequests(std::uint64_t revision) {
    const std::lock_guard lock(mutex_);
    return taken(looks_, [&](const SnapshotRequest& look) { return look.revision == revision; });
}

}  // namespace pdr
