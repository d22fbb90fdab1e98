#pragma once
/// A plot over Hounsfield units whose points are edited by mouse and keys. It shows values and emits edits; setters are
/// silent.
///   press a point, drag      selects and moves it; with Shift several, as with a rubber band on empty ground
///   press the line           adds a point; with Ctrl anywhere
///   wheel, middle drag       zooms at the mouse; moves what is seen; double click on empty ground fits
///   arrow keys               nudge what is selected, ten times as far with Shift
///   PgUp, PgDown             select the point before or after; Ctrl+A all; Ins adds, Del removes; +, -, Home zoom and
///   fit

#include <QTimer>
#include <QWidget>

#include "ui/tissue/curve_hand.h"

class QHelpEvent;

namespace pdr::ui {

class PointsPlot : public QWidget {
    Q_OBJECT

  public:
    const Curve& points() const { return hand_.curve(); }
    const CurveSelection& selection() const { return hand_.selection(); }
    const PlotView& view() const { return view_; }
    /// The part of the scale that is seen.
    void setRange(double lowHu, double highHu);

    void clearSelection();

  public slots:
    void removeSelected();
    /// As the arrow keys do it.
    void nudge(const pdr::CurvePoint& by);

  signals:
    /// points() are others. `moving`: the gesture goes on; the last edit of a gesture comes with false.
    void edited(bool moving);
    void selectionChanged();
    /// The hand has zoomed or moved what is seen.
    void rangeChanged(double lowHu, double highHu);
    /// All that counts is to be seen.
    void fitRequested();

  protected:
    PointsPlot(CurveHand::Kind kind, QWidget* parent);

    void setPoints(const Curve& points, float top);
    void setArea(const QRectF& area);
    void setShownTop(double top);
    CurveHand& hand() { return hand_; }

    /// A step of the arrow keys.
    virtual CurvePoint step() const = 0;
    /// What the mouse rests on, in words.
    virtual QString tipAt(QPointF place) const = 0;
    /// The points are others now: there is one more, there are fewer, or they have moved.
    virtual void pointAdded(std::size_t) {}
    virtual void pointsRemoved(const CurveSelection&) {}
    virtual void pointsMoved() {}
    /// Shift and wheel, by as many clicks.
    virtual void zoomValues(double) {}

    bool event(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintFocus(QPainter& painter) const;

  private:
    void edit(bool moving);
    void rest();
    void add();
    void zoom(double x, double factor);
    void showCursorFor(QPointF place);
    bool moveOrChoose(const QKeyEvent& event);
    bool changeOrZoom(const QKeyEvent& event);

    CurveHand hand_;
    PlotView view_;
    std::optional<QPointF> panning_;  ///< last place of a drag that moves what is seen
    QTimer restTimer_;                ///< keys have no release: they rest when this runs out
};

}  // namespace pdr::ui
