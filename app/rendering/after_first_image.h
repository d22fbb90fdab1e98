#pragma once
/// Work of the window that waits for the first image of a series: it must not keep that image waiting.

#include <QObject>
#include <QTimer>
#include <functional>

namespace pdr::app {

class AfterFirstImage : public QObject {
  public:
    AfterFirstImage();

    /// Calls `work` once the image stands, or at once if it does. Of several works the newest is called. Without an
    /// image, because rendering is paused or fails, it is called after five seconds.
    void call(std::function<void()> work);
    /// Tells that the image stands, and calls what waits for it.
    void imageStands();
    /// Drops what waits, and waits for the next series' image.
    void reset();

  private:
    bool stands_ = false;
    std::function<void()> waiting_;
    QTimer late_;
};

}  // namespace pdr::app
