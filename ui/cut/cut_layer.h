#pragma once
/// A layer over the image that shows the box and planes of the cut with handles for the mouse. Presses beside a handle
/// reach the image. Setters emit no signals.

#include <optional>

#include "ui/cut/cut_marks.h"
#include "ui/view/picture_layer.h"

class QMouseEvent;

namespace pdr::ui {

class CutLayer : public PictureLayer {
    Q_OBJECT

  public:
    explicit CutLayer(QWidget* picture) : PictureLayer(picture) {}

    /// Sets the cuts. `uncut`: the box that can be cut; none: nothing is shown. Cuts that differ from the user's last
    /// edit end the gesture.
    void setCuts(const Clip& clip, const std::optional<Uncut>& uncut);
    /// Sets the camera and the size [pixels] of the image on the screen.
    void setPicture(const Camera& camera, QSize size);
    void setHandlesShown(bool shown);
    bool handlesShown() const { return shown_; }
    /// Cancels the gesture in progress; returns false if there is none.
    bool giveUp();
    const CutMarks& marks() const { return marks_; }

  signals:
    /// Reports edited cuts. `moving`: the gesture goes on; the last edit of a gesture comes with false.
    void clipEdited(const pdr::Clip& clip, bool moving);
    /// Requests to restore the cut from before the gesture.
    void gestureGivenUp();

  protected:
    bool eventFilter(QObject* picture, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

  private:
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    bool bringBack(const QMouseEvent& event);
    void edit(const Clip& clip, bool moving);
    void light(const std::optional<CutHandle>& handle);
    void mark();
    QRectF area() const;
    dvec2 placeOf(QPointF point) const;
    void paintText(QPainter& painter, QPointF place, const QString& text) const;

    Clip clip_;
    std::optional<Uncut> uncut_;
    std::optional<Camera> camera_;
    QSize size_;
    CutMarks marks_;
    bool shown_ = false;
    std::optional<CutHandle> lit_;  ///< handle under the pointer
    std::optional<CutGrip> grip_;   ///< grip on the handle being dragged
    bool moved_ = false;            ///< the gesture has edited the cut
};

}  // namespace pdr::ui
