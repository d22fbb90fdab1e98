#include "app/render_bridge.h"

#include <utility>

namespace pdr::app {

RenderBridge::RenderBridge(std::unique_ptr<Device> device)
    : session_(std::move(device), [this](std::shared_ptr<const Frame> frame) { take(std::move(frame)); }) {}

/// While the hand moves, a picture that is a little behind is better than none; at rest only the newest scene counts.
void RenderBridge::submit(const Scene& scene, bool moving) {
    newest_ = scene.revision;
    if (!moving)
        oldestShown_ = newest_;
    session_.submit(scene, moving);
}

void RenderBridge::setDisplay(const Display& display) {
    session_.setDisplay(display);
}

void RenderBridge::setIterationsPerFrame(int n) {
    session_.setIterationsPerFrame(n);
}

void RenderBridge::setPaused(bool paused) {
    paused_ = paused;
    session_.setPaused(paused);
    emit pausedChanged(paused);
}

void RenderBridge::dropFrames() {
    oldestShown_ = newest_ + 1;
}

/// On the render thread.
void RenderBridge::take(std::shared_ptr<const Frame> frame) {
    const std::lock_guard lock(mutex_);
    const bool windowIsAsked = waiting_ != nullptr;
    waiting_ = std::move(frame);
    if (!windowIsAsked)
        QMetaObject::invokeMethod(this, &RenderBridge::deliver, Qt::QueuedConnection);
}

/// On the window's thread.
void RenderBridge::deliver() {
    std::shared_ptr<const Frame> frame;
    {
        const std::lock_guard lock(mutex_);
        frame = std::exchange(waiting_, nullptr);
    }
    if (frame->revision < oldestShown_)
        return;
    oldestShown_ = frame->revision;
    emit frameReady(frame);
}

}  // namespace pdr::app
