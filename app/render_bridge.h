#pragma once
/// The render Session for the window: scenes go in at once, frames come out as signals on the window's thread. When the
/// window is behind, frames are dropped; it never waits for the renderer, nor the renderer for it.

#include <QObject>
#include <memory>
#include <mutex>

#include "render/session/session.h"

namespace pdr::app {

class RenderBridge : public QObject {
    Q_OBJECT

  public:
    explicit RenderBridge(std::unique_ptr<Device> device);

    bool paused() const { return paused_; }

  public slots:
    void submit(const pdr::Scene& scene, bool moving);
    void setDisplay(const pdr::Display& display);
    void setIterationsPerFrame(int n);
    void setPaused(bool paused);
    /// Frames of the scenes so far are not wanted any more.
    void dropFrames();

  signals:
    void frameReady(const std::shared_ptr<const pdr::Frame>& frame);
    void pausedChanged(bool paused);

  private:
    void take(std::shared_ptr<const Frame> frame);
    void deliver();

    std::mutex mutex_;
    std::shared_ptr<const Frame> waiting_;  ///< guarded by mutex_: the newest frame that the window has not seen
    std::uint64_t newest_ = 0;       ///< revision submitted last
    std::uint64_t oldestShown_ = 0;  ///< frames of earlier revisions are stale
    bool paused_ = false;
    Session session_;                ///< last, so that it ends first: its thread calls take()
};

}  // namespace pdr::app
