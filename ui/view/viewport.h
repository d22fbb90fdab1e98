#pragma once
/// The picture and its interaction: drags and wheels become camera edits. Setters are silent.

#include <QPoint>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <optional>

#include "render/scene/camera.h"
#include "ui/annotation/orientation_letters.h"
#include "ui/view/shown_picture.h"

class QHelpEvent;

namespace pdr::ui {

class Viewport : public QWidget {
    Q_OBJECT

  public:
    explicit Viewport(QWidget* parent = nullptr);

    void setPicture(const ShownPicture& picture);
    void clearPicture();
    /// The letters at the edges of the picture; none without one.
    EdgeLetters letters() const;
    /// A tip where the mouse rests, if it still does at `place`; see rested(). Empty: none.
    void showTip(QPointF place, const QString& text);
    /// The camera that the next edit starts from, which may be ahead of the picture's. None: edits are ignored.
    void setCamera(const std::optional<Camera>& camera);
    /// Lines in the upper left corner of a picture, asked for at each painting.
    void setOverlay(std::function<QStringList()> lines) { overlay_ = std::move(lines); }
    void setCaptionShown(bool shown);
    /// What the next click picks; it turns nothing then.
    enum class Picking { nothing, tissue, focus };
    void setPicking(Picking picking);
    /// What stands in the middle as long as there is no picture.
    void setMessage(const QString& message);
    /// What stands there now; nothing with a picture.
    QString message() const { return picture_ ? QString() : message_; }

    /// The view's size in the screen's own pixels.
    QSize sizeInPixels() const;

    QSize sizeHint() const override { return {900, 700}; }
    QSize minimumSizeHint() const override { return {200, 150}; }

  signals:
    /// A drag, a wheel or an arrow key. `moving`: the gesture goes on; the last edit of a gesture comes with false.
    void cameraEdited(const pdr::Camera& camera, bool moving);
    /// A drag with Ctrl: how far it has come, in fractions of the view's height. `moving` as above.
    void tissueDragged(QPointF drag, bool moving);
    /// A drag with Shift and the right button: how far it has come since the last, in fractions of the view's height.
    void lightDragged(QPointF drag, bool moving);
    /// A click with Ctrl, or the one that was asked for: at `place`, in fractions of the picture's width and height.
    void tissuePicked(QPointF place);
    /// The click that was asked for, likewise.
    void focusPicked(QPointF place);
    /// The mouse rests on the picture: at `place`, in fractions of its width and height.
    void rested(QPointF place);
    /// By Home, which is the strip's and the fields' own elsewhere.
    void resetRequested();
    /// A right click, or the menu's key: at `place` [px].
    void menuRequested(QPoint place);
    /// With a picture only when the size has settled: until then the picture is scaled. It may be the old one.
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
    void contextMenuEvent(QContextMenuEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    enum class Gesture { none, orbit, pan, zoom, tissue, light };
    static Gesture gestureOf(const QMouseEvent& event);

    void edit(const Camera& camera);
    void rest();
    void changeSize();
    void editInSteps(const Camera& camera);
    /// From widget coordinates to fractions of the view's height.
    dvec2 inHeights(QPointF distance) const;
    PictureView view() const;
    QPointF placeOf(QPointF point) const;
    void dragTissue(QPointF point);
    void endTissue(QPointF point);
    void tellPlace(const QHelpEvent& event);
    void paintMessage(QPainter& painter) const;
    void paintRing(QPainter& painter) const;

    std::optional<ShownPicture> picture_;
    QString message_;
    std::function<QStringList()> overlay_ = [] { return QStringList(); };
    bool reachedByKey_ = false;  ///< the keyboard came here by Tab
    bool captionShown_ = false;
    std::optional<Camera> camera_;
    Gesture gesture_ = Gesture::none;
    bool moved_ = false;  ///< the gesture has edited the camera
    QPointF last_;
    QPointF pressed_;
    bool tissueMoved_ = false;  ///< further than a hand that clicks trembles
    Picking picking_ = Picking::nothing;
    std::optional<QPointF> resting_;  ///< place that was told last; none: the mouse has moved on
    QPoint restingAt_;                ///< on the screen
    QTimer settleTimer_;              ///< the size has settled when this runs out
    QTimer restTimer_;                ///< wheels and keys have no release: they rest when this runs out
};

}  // namespace pdr::ui
