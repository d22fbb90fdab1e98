#include "app/render_bridge.h"

#include <utility>

#include "app/provenance.h"
#include "render/film/image_file.h"
#include "ui/to_qt.h"

namespace pdr::app {

RenderBridge::RenderBridge(std::unique_ptr<Device> device)
    : session_(std::move(device), [this](std::shared_ptr<const Frame> frame) { take(std::move(frame)); }) {}

/// While the hand moves, a picture that is a little behind is better than none; at rest only the newest scene counts.
void RenderBridge::submit(const Scene& scene, bool moving) {
    newest_ = scene.revision;
    if (!moving)
        oldestShown_ = newest_;
    if (moving && movingUnseen_) {
        next_ = scene;
        return;
    }
    next_.reset();
    movingUnseen_ = moving;
    submitted_ = scene.revision;
    session_.submit(scene, moving);
}

void RenderBridge::setDisplay(const Display& display) {
    display_ = display;
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
    next_.reset();
    movingUnseen_ = false;
    lastFrame_.reset();
}

void RenderBridge::save(const QString& file) {
    const bool exr = file.endsWith(".exr", Qt::CaseInsensitive);
    if (!exr && !file.endsWith(".png", Qt::CaseInsensitive)) {
        emit saveFailed({"the name says no format that pictures are saved in", file.toStdString(),
                         "Choose a name that ends in .png or .exr."});
        return;
    }
    session_.inspect([this, file, exr, display = display_](const Film& film, const Scene& scene, double seconds) {
        const Provenance provenance = provenanceOf(scene, film.status(), seconds);
        const std::filesystem::path path = ui::fromQt(file);
        const Result<void> written = exr ? writeExr(film, provenance, path) : writePng(film, display, provenance, path);
        QMetaObject::invokeMethod(this, [this, file, written] {
            if (written)
                emit saved(file);
            else
                emit saveFailed(written.error());
        });
    });
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
    lastFrame_ = frame;
    if (frame->revision == submitted_)
        movingUnseen_ = false;
    if (next_ && !movingUnseen_)
        submit(*std::exchange(next_, std::nullopt), true);
    emit frameReady(frame);
}

}  // namespace pdr::app
