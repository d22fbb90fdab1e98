#pragma once
/// The widget that shows the image and passes pointer, wheel and keys to its tools: those of the camera, and those that
/// others add. Setters emit no signals.

#include <QPoint>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <optional>

#include "ui/annotation/orientation_letters.h"
#include "ui/view/camera_drag.h"
#include "ui/view/camera_steps.h"
#include "ui/view/edited_camera.h"
#include "ui/view/shown_image.h"
#include "ui/view/view_tools.h"

class QHelpEvent;

namespace pdr::ui {

class Viewport : public QWidget {
    Q_OBJECT

  public:
    explicit Viewport(QWidget* parent = nullptr);

    void setImage(const ShownImage& image);
    void clearImage();
    /// Returns the view's tools, to which others can be added.
    ViewTools& tools() { return tools_; }
    /// Returns the orientation letters at the edges of the image; empty without an image.
    EdgeLetters letters() const;
    /// Shows a tool tip if the pointer still rests at `place`, which rested() reported. Empty: no tool tip.
    void showTip(QPointF place, const QString& text);
    /// Sets the camera that the next edit starts from, which may be ahead of the image's. None: edits are ignored.
    void setCamera(const std::optional<Camera>& camera) { camera_.set(camera); }
    /// Sets the function that returns the lines in the image's upper left corner; it is called at each painting.
    void setOverlay(std::function<QStringList()> lines) { overlay_ = std::move(lines); }
    void setCaptionShown(bool shown);
    /// Sets the text in the middle of the view while there is no image.
    void setMessage(const QString& message);
    /// Returns the text in the middle of the view; empty while there is an image.
    QString message() const { return image_ ? QString() : message_; }

    /// Returns the view's size in screen pixels.
    QSize sizeInPixels() const;
    /// Returns `at` [px] in fractions of the image's width and height; none outside of an image.
    std::optional<QPointF> fractionsAt(QPoint at) const;

    QSize sizeHint() const override { return {900, 700}; }
    QSize minimumSizeHint() const override { return {200, 150}; }

  signals:
    /// Reports a camera edited by a drag, the wheel or an arrow key. `moving`: the gesture goes on; the last edit of a
    /// gesture comes with false.
    void cameraEdited(const pdr::Camera& camera, bool moving);
    /// Reports that the pointer rests on the image: at `place`, in fractions of its width and height.
    void rested(QPointF place);
    /// Reports a click with the left button on the image: at `place`, in fractions of its width and height.
    void clicked(QPointF place);
    /// Requests the first view, on Home. A signal of the view and no key of the window, since the accuracy strip and
    /// the number fields use Home themselves.
    void resetRequested();
    /// Requests the context menu at `place` [px], on a right click or the menu key.
    void menuRequested(QPoint place);
    /// Reports the view's size in screen pixels. While an image is shown, only when the size has settled; until then
    /// the image is scaled. The size may be the old one.
    void sizeInPixelsChanged(QSize size);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void bindTools();
    void forwardTools();
    void followTools();
    void press(const QMouseEvent& event);
    ImagePlace place() const;
    void changeSize();
    void tellPlace(const QHelpEvent& event);
    void paintMessage(QPainter& painter) const;
    void paintImage(QPainter& painter) const;
    void paintRing(QPainter& painter) const;

    std::optional<ShownImage> image_;
    QString message_;
    std::function<QStringList()> overlay_ = [] { return QStringList(); };
    bool reachedByKey_ = false;  ///< the focus came here by Tab
    bool captionShown_ = false;
    EditedCamera camera_;
    CameraDrag orbit_, pan_, zoom_;
    CameraSteps steps_;
    ViewTools tools_;
    std::optional<QPointF> resting_;  ///< place reported last by rested(); none: the pointer has moved on
    QPoint restingAt_;                ///< resting_ in screen coordinates
    QTimer settleTimer_;              ///< the size has settled when this runs out
};

}  // namespace pdr::ui
