#include "app/rendering/render_bridge.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/scene/scene.h"
#include "ui/text/room_text.h"

namespace pdr::app {
namespace {

/// Returns the errors of the pixel at `place` and of a square of 1 mm around it in the plane of focus.
LevelErrorsAt errorsAt(const FilmView& view, QPointF place, const Tone& tone) {
    const ivec2 size = view.film.size();
    const ivec2 pixel(int(place.x() * size.x), int(place.y() * size.y));
    const int side = int(std::lround(size.y / view.scene.camera.heightInFocusMm()));
    LevelErrorsAt errors = levelErrorsAt(view.film, glm::clamp(pixel, ivec2(0), size - 1), std::max(side, 1), tone);
    errors.side = side;
    return errors;
}

}  // namespace

RenderBridge::RenderBridge(std::unique_ptr<Device> device, int threads)
    : devices_(threads, [this](bool begins) { tellPreparing(begins); }),
      firstDevice_(device->info()),
      device_(QString::fromStdString(firstDevice_.name)),
      session_(
          std::move(device), [this](std::shared_ptr<const Frame> frame) { take(std::move(frame)); },
          [this] { return devices_.openCpu(); }) {}

/// While the user drags, an image that is a little behind is better than none; at rest only the newest scene counts.
void RenderBridge::submit(const Scene& scene, bool moving) {
    newest_ = scene.revision;
    if (!moving)
        oldestShown_ = newest_;
    session_.submit(scene, moving);
}

void RenderBridge::setDisplay(const Display& display) {
    display_ = display;
    session_.setDisplay(display);
}

void RenderBridge::setErrorMap(bool wanted) {
    session_.setErrorMap(wanted);
}

void RenderBridge::setRegion(const std::optional<QRectF>& box) {
    session_.setRegion(box ? std::optional(Region{{box->left(), box->top()}, {box->right(), box->bottom()}})
                           : std::nullopt);
}

void RenderBridge::askErrorAt(QPointF place) {
    if (!lastFrame_ || lastFrame_->coarse)
        return;
    lookAtImage([this, place, tone = Tone(display_)](const Result<FilmView>& view) -> std::function<void()> {
        if (!view)
            return [] {};
        return [this, place, errors = errorsAt(*view, place, tone)] { emit errorFound(place, errors); };
    });
}

void RenderBridge::setPace(const FrameBudget& pace) {
    session_.setPace(pace);
}

void RenderBridge::setKeptMemory(std::size_t bytes) {
    session_.setKeptMemory(bytes);
}

void RenderBridge::setDevice(const QString& name) {
    chosen_ = name;
    openAndGoOn(name);
}

/// Opens the same device again, since a film in progress cannot become shared or unshared.
void RenderBridge::setPool(const std::shared_ptr<SharedWork>& pool) {
    if (devices_.setPool(pool))
        openAndGoOn(chosen_.value_or(device_));
}

void RenderBridge::tellPreparing(bool begins) {
    QMetaObject::invokeMethod(this, [this, begins] {
        preparing_ = begins;
        emit preparingChanged(begins);
    });
}

DeviceOpener RenderBridge::finalRenderDevice() {
    return devices_.forFinalRender(device_.toStdString(), [this](const Error& why) {
        const Text notice = phrase("The CPU renders the image for the file, since the GPU cannot: %1", why.text());
        QMetaObject::invokeMethod(this, [this, notice = ui::inWords(notice)] { emit noticed(notice); });
    });
}

void RenderBridge::openAndGoOn(const QString& device) {
    session_.setDevice([this, name = device.toStdString()] { return devices_.open(name); });
}

void RenderBridge::setStop(const StopRule& rule) {
    stop_ = rule;
    session_.setStop(rule);
    emit stopChanged(rule);
}

void RenderBridge::setTarget(double levels) {
    StopRule rule = stop_;
    rule.levels = levels;
    setStop(rule);
}

void RenderBridge::setPaused(bool paused) {
    paused_ = paused;
    session_.setPaused(paused_ || unseen_);
    if (!paused && std::exchange(reached_, false))
        session_.goOn();
    emit pausedChanged(paused);
}

void RenderBridge::setUnseen(bool unseen) {
    unseen_ = unseen;
    session_.setPaused(paused_ || unseen_);
}

void RenderBridge::setYielding(bool yielding) {
    if (std::exchange(yielding_, yielding) != yielding)
        session_.setYielding(yielding);
}

void RenderBridge::clear() {
    session_.clear();
    oldestShown_ = newest_ + 1;
    lastFrame_.reset();
}

void RenderBridge::lookAtImage(ImageLook look) {
    session_.requestSnapshot(lastFrame_->revision, [this, look = std::move(look)](const Result<FilmView>& view) {
        QMetaObject::invokeMethod(this, look(view));
    });
}

void RenderBridge::observeEffects(EffectsObserver observer) {
    if (!observer)
        return session_.watchEffects({});
    session_.watchEffects(
        {devices_.cpuAlone(), [this, observer = std::move(observer)](std::shared_ptr<const EffectCosts> table) {
             QMetaObject::invokeMethod(this, [observer, table = std::move(table)] { observer(table); });
         }});
}

/// Passes a frame on to the window's thread, in place of one that still waits. Called on the render thread.
void RenderBridge::take(std::shared_ptr<const Frame> frame) {
    if (!frame->notice.empty()) {
        QMetaObject::invokeMethod(this, [this, frame, notice = ui::inWords(frame->notice)] {
            chosen_.reset();
            device_ = QString::fromStdString(frame->device);
            emit noticed(notice);
            emit deviceChanged(device_);
        });
        return;
    }
    const std::lock_guard lock(mutex_);
    if (!waiting_)  // else deliver() is queued already; queued before waiting_ is set, since queueing may throw
        QMetaObject::invokeMethod(this, &RenderBridge::deliver, Qt::QueuedConnection);
    waiting_ = std::move(frame);
}

/// Delivers the newest frame. Called on the window's thread.
void RenderBridge::deliver() {
    std::shared_ptr<const Frame> frame;
    {
        const std::lock_guard lock(mutex_);
        frame = std::exchange(waiting_, nullptr);
    }
    if (frame->revision < oldestShown_)
        return;
    oldestShown_ = frame->revision;
    lastFrame_ = frame->error.empty() ? frame : nullptr;
    reached_ = frame->reached;
    if (const QString device = QString::fromStdString(frame->device); !device.isEmpty() && device != device_) {
        device_ = device;
        emit deviceChanged(device_);
    }
    if (chosen_ == device_)
        chosen_.reset();
    emit frameReady(frame);
}

}  // namespace pdr::app
