#pragma once
/// Connects the window to the render session: scenes go in at once, frames come out as signals on the window's thread.
/// Frames are dropped when the window is behind; neither ever waits for the other.

#include <QObject>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>

#include "app/rendering/device_choice.h"
#include "render/scene/scene.h"
#include "render/session/effect_costs.h"
#include "render/session/session.h"

namespace pdr::app {

class RenderBridge : public QObject {
    Q_OBJECT

  public:
    /// `threads`: number of CPU threads if the image goes on on the CPU, because `device` fails or another is chosen;
    /// 0: one per core.
    explicit RenderBridge(std::unique_ptr<Device> device, int threads = 0);

    bool paused() const { return paused_; }
    /// Whether the session leaves the processor to the window for now; see setYielding().
    bool isYielding() const { return yielding_; }
    /// Whether rendering has stopped by itself, since the stop rule is met; setPaused(false) goes on.
    bool reached() const { return reached_; }
    /// Whether a GPU is being prepared for its first image.
    bool isPreparing() const { return preparing_; }
    /// Tells the window that a GPU is being prepared, or is not any more. May be called on any thread.
    void tellPreparing(bool begins);
    /// The device that was passed to the constructor.
    const DeviceInfo& firstDevice() const { return firstDevice_; }
    const StopRule& stop() const { return stop_; }
    /// The frame on the screen; null if there is none.
    const std::shared_ptr<const Frame>& lastFrame() const { return lastFrame_; }
    /// The devices that render, and how they are shared.
    const DeviceChoice& devices() const { return devices_; }
    /// Returns an opener of a device for an image that goes into a file: another device of the kind in use; noticed()
    /// says why if the CPU takes over. See DeviceChoice::forFinalRender().
    DeviceOpener finalRenderDevice();
    /// How radiance becomes display levels, as set last.
    const Display& display() const { return display_; }

    /// Looks at the film of the image on the screen once it has samples: on the render thread, between two launches.
    /// Returns what is then to be done on the window's thread.
    using ImageLook = std::function<std::function<void()>(const Result<FilmView>& view)>;
    /// Calls `look` once. Errors: another image replaced this one, or it was closed or could not be rendered. There
    /// must be an image.
    void lookAtImage(ImageLook look);
    /// Receives cost tables of the effects, on the window's thread.
    using EffectsObserver = std::function<void(const std::shared_ptr<const EffectCosts>& table)>;
    /// Measures what effects cost, on the CPU, while there is an observer.
    void observeEffects(EffectsObserver observer);

  public slots:
    /// Renders `scene`. `moving`: the user is dragging; see Session::submit().
    void submit(const pdr::Scene& scene, bool moving);
    void setDisplay(const pdr::Display& display);
    /// Sets whether frames come with an error map.
    void setErrorMap(bool wanted);
    /// Sets the part of the images that gets its samples first, in fractions of their width and height; none: all parts
    /// alike.
    void setRegion(const std::optional<QRectF>& box);
    /// Asks how far the image may be off at `place`, in fractions of its width and height, and over 1 mm around.
    /// errorFound() answers, unless the image is coarse or is replaced.
    void askErrorAt(QPointF place);
    void setPace(const pdr::FrameBudget& pace);
    /// Sets the most memory that images of earlier scenes take together [bytes].
    void setKeptMemory(std::size_t bytes);
    /// Continues the image on another device. If that cannot be used, noticed() says why.
    void setDevice(const QString& name);
    /// Shares the work of the device with the workers of `pool` from now on, or with none (null). The image goes on.
    void setPool(const std::shared_ptr<pdr::SharedWork>& pool);
    /// Sets when rendering stops by itself.
    void setStop(const pdr::StopRule& rule);
    /// Changes only the levels of the stop rule.
    void setTarget(double levels);
    void setPaused(bool paused);
    /// Also stops rendering while the user cannot see the image; paused() stays as it is.
    void setUnseen(bool unseen);
    /// Sets whether the session leaves the processor to the window; see Session::setYielding().
    void setYielding(bool yielding);
    /// Stops rendering and releases everything of the scenes so far.
    void clear();

  signals:
    void frameReady(const std::shared_ptr<const pdr::Frame>& frame);
    void pausedChanged(bool paused);
    void preparingChanged(bool preparing);
    void stopChanged(const pdr::StopRule& rule);
    /// Emitted when frames come from another device, and again with each notice.
    void deviceChanged(const QString& name);
    /// Emitted when a request failed but rendering goes on, with sentences for the user.
    void noticed(const QString& sentences);
    /// Answers askErrorAt(). The square of `errors` is 1 mm large in the plane of focus; its side is 0 if 1 mm is less
    /// than half a pixel.
    void errorFound(QPointF place, const pdr::LevelErrorsAt& errors);

  private:
    void take(std::shared_ptr<const Frame> frame);
    void deliver();
    void openAndGoOn(const QString& device);

    DeviceChoice devices_;
    std::mutex mutex_;
    std::shared_ptr<const Frame> waiting_;  ///< guarded by mutex_: the newest frame that the window has not seen
    std::shared_ptr<const Frame> lastFrame_;
    std::uint64_t newest_ = 0;       ///< revision of the newest scene
    std::uint64_t oldestShown_ = 0;  ///< frames of earlier revisions are stale
    Display display_;
    StopRule stop_;
    bool paused_ = false;
    bool unseen_ = false;
    bool yielding_ = false;
    bool reached_ = false;
    bool preparing_ = false;
    DeviceInfo firstDevice_;
    QString device_;                 ///< name of the device that made the last frame
    std::optional<QString> chosen_;  ///< requested device, until a frame comes from it or a notice says why not
    Session session_;                ///< last member, destroyed first: its thread calls take()
};

}  // namespace pdr::app
