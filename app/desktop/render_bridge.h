#pragma once
/// The render Session for the window: scenes go in at once, frames come out as signals on the window's thread. When the
/// window is behind, frames are dropped; it never waits for the renderer, nor the renderer for it.

#include <QObject>
#include <QPointF>
#include <QRectF>
#include <QString>
#include <memory>
#include <mutex>
#include <optional>

#include "render/scene/scene.h"
#include "render/session/effect_ledger.h"
#include "render/session/session.h"
#include "render/tiles/shared_device.h"
#include "ui/annotation/annotations.h"

namespace pdr::app {

class RenderBridge : public QObject {
    Q_OBJECT

  public:
    /// `threads`: of the CPU, where the picture goes on when `device` fails or another is chosen; 0 = one per core.
    explicit RenderBridge(std::unique_ptr<Device> device, int threads = 0);

    bool paused() const { return paused_; }
    /// The picture is as good as rendering makes it by itself; setPaused(false) goes on.
    bool reached() const { return reached_; }
    /// The device that it began with.
    const DeviceInfo& firstDevice() const { return firstDevice_; }
    const StopRule& stop() const { return stop_; }
    /// Pictures that leave the window are annotated, unless it is said otherwise.
    bool captioned() const { return captioned_; }
    /// The picture on the screen; null when there is none.
    const std::shared_ptr<const Frame>& lastFrame() const { return lastFrame_; }
    /// Opens another device of the kind in use, or where that cannot be the CPU, for a picture that goes into a file:
    /// workers who make its bits take samples of that picture first. Any thread's.
    DeviceOpener finalRenderDevice() const;
    /// What effects cost, as far as it is known; null while nobody looks.
    const std::shared_ptr<const EffectLedger>& lastLedger() const { return lastLedger_; }

  public slots:
    /// Scenes of a moving hand are taken one at a time, the newest next, so that every one of them is seen.
    void submit(const pdr::Scene& scene, bool moving);
    void setDisplay(const pdr::Display& display);
    /// Whether frames come with a map of their error.
    void setErrorMap(bool wanted);
    /// Which part of the pictures gets its samples first, in fractions of their width and height; none: all alike.
    void setRegion(const std::optional<QRectF>& box);
    /// How far the picture may be off at `place`, in fractions of its width and height, and over 1 mm around. Ends
    /// with errorFound(), unless the picture is coarse or goes away.
    void askErrorAt(QPointF place);
    void setPace(const pdr::FrameBudget& pace);
    /// The picture goes on there. A device that cannot be used ends with noticed().
    void setDevice(const QString& name);
    /// The device takes samples together with the workers of `pool` from now on, or alone (null); the picture goes on.
    void setPool(std::shared_ptr<pdr::WorkerPool> pool);
    /// When rendering holds by itself.
    void setStop(const pdr::StopRule& rule);
    /// The same, but for the levels.
    void setTarget(double levels);
    void setCaptioned(bool captioned) { captioned_ = captioned; }
    void setPaused(bool paused);
    /// Holds as well, as long as nobody can see the picture; the user's own pause stays what it is.
    void setUnseen(bool unseen);
    /// Nothing is rendered any more, and nothing of the scenes so far is kept.
    void clear();
    /// What effects cost is measured, on the CPU, or not any more.
    void watchEffects(bool watch);
    /// Writes the picture that is on the screen, with the samples that it has by then, and `annotations` of it over it,
    /// if there are any; the name's end says the format:
    /// ".exr" or ".png". Ends with saved() or saveFailed(), the latter also when another picture has taken its place.
    void save(const QString& file, const std::optional<ui::Annotations>& annotations = {});

  signals:
    /// The device in use takes samples together with others, which have to make the same bits as it does:
    /// referenceTiles() of it.
    void sharedWith(const std::vector<std::byte>& bits);
    void frameReady(const std::shared_ptr<const pdr::Frame>& frame);
    /// lastLedger() is another one.
    void ledgerChanged();
    void pausedChanged(bool paused);
    void stopChanged(const pdr::StopRule& rule);
    /// Frames come from this device from now on; said again with each notice.
    void deviceChanged(const QString& name);
    /// Something did not go as it was asked, and the rendering goes on: sentences for the user.
    void noticed(const QString& sentences);
    /// The square is 1 mm large in the sharp plane; of side 0 where a pixel is larger.
    void errorFound(QPointF place, const pdr::LevelErrorsAt& errors);
    void saved(const QString& file);
    void saveFailed(const pdr::Error& error);

  private:
    void take(std::shared_ptr<const Frame> frame);
    void deliver();
    void takeLedger(std::shared_ptr<const EffectLedger> ledger);
    void openAndGoOn(const QString& device);
    Result<std::unique_ptr<Device>> shared(std::unique_ptr<Device> device);

    mutable std::mutex mutex_;
    std::shared_ptr<WorkerPool> pool_;      ///< guarded by mutex_: who renders along; null: nobody
    std::vector<std::byte> bits_;           ///< guarded by mutex_: those that they make
    std::shared_ptr<const Frame> waiting_;  ///< guarded by mutex_: the newest frame that the window has not seen
    std::shared_ptr<const Frame> lastFrame_;
    std::shared_ptr<const EffectLedger> lastLedger_;
    bool watching_ = false;
    std::optional<Scene> next_;      ///< of a moving hand, as long as the one before has not been seen
    bool movingUnseen_ = false;      ///< the renderer is at a moving hand's scene
    std::uint64_t submitted_ = 0;    ///< revision that the renderer is at
    std::uint64_t newest_ = 0;       ///< revision of the newest scene
    std::uint64_t oldestShown_ = 0;  ///< frames of earlier revisions are stale
    Display display_;
    StopRule stop_;
    bool paused_ = false;
    bool unseen_ = false;
    bool captioned_ = true;
    bool reached_ = false;
    int threads_;
    DeviceInfo firstDevice_;
    QString device_;                 ///< that the last frame came from
    std::optional<QString> chosen_;  ///< that is to be another, as long as it has not been heard of
    Session session_;                ///< last, so that it ends first: its thread calls take()
};

}  // namespace pdr::app
