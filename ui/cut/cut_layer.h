#pragma once
/// Box and planes of the cut over the picture, with handles for the mouse. What lies beside a handle reaches the
/// picture below. Setters are silent.

#include <optional>

#include "ui/cut/cut_marks.h"
#include "ui/view/picture_layer.h"

class QMouseEvent;

namespace pdr::ui {

class CutLayer : public PictureLayer {
    Q_OBJECT

  public:
    explicit CutLayer(QWidget* picture) : PictureLayer(picture) {}

    /// `uncut`: what there is to cut; none: nothing is shown. Another than the hand makes ends what it does.
    void setCuts(const Clip& clip, const std::optional<Uncut>& uncut);
    /// The camera of the picture on the screen, and the picture's size [pixels].
    void setPicture(const Camera& camera, QSize size);
    void setHandlesShown(bool shown);
    bool handlesShown() const { return shown_; }
    /// Ends the gesture as if it had not been; false: there is none.
    bool giveUp();
    const CutMarks& marks() const { return marks_; }

  signals:
    /// `moving`: the gesture goes on; the last edit of a gesture comes with false.
    void clipEdited(const pdr::Clip& clip, bool moving);
    /// The cut is wanted as it was before the gesture.
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
    std::optional<CutHandle> lit_;  ///< under the mouse
    std::optional<CutGrip> grip_;   ///< in the hand
    bool moved_ = false;            ///< the gesture has edited the cut
};

}  // namespace pdr::ui
