#pragma once
/// A plot over Hounsfield units whose points are edited with mouse and keys. It shows values and emits edits. Setters
/// emit no signals.
///   press a point, drag  selects and moves it; Shift adds to the selection, also with a rubber band on empty ground
///   press the line       adds a point; with Ctrl anywhere
///   wheel, middle drag   zooms at the pointer; moves the visible range; a double click on empty ground fits
///   arrow keys           nudge the selected points, ten times as far with Shift
///   PgUp, PgDown         select the point before or after; Ctrl+A all
///   Ins, Del             adds, removes; +, - and Home zoom and fit

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
    /// Sets the visible range [HU].
    void setRange(double lowHu, double highHu);

    void clearSelection();

  public slots:
    void removeSelected();
    /// Moves the selected points as the arrow keys do.
    void nudge(const pdr::CurvePoint& by);

  signals:
    /// Reports that points() have changed. `moving`: the gesture goes on; the last edit of a gesture comes with false.
    void edited(bool moving);
    void selectionChanged();
    /// Reports that the user has zoomed or moved the visible range.
    void rangeChanged(double lowHu, double highHu);
    /// Requests to make everything relevant visible.
    void fitRequested();

  protected:
    PointsPlot(CurveHand::Kind kind, QWidget* parent);

    void setPoints(const Curve& points, float top);
    void setArea(const QRectF& area);
    void setShownTop(double top);
    CurveHand& hand() { return hand_; }

    /// Returns the step of the arrow keys.
    virtual CurvePoint step() const = 0;
    /// Returns the text of the tool tip at `place`.
    virtual QString tipAt(QPointF place) const = 0;
    /// Called when a point has been added, when points have been removed, and when points have moved.
    virtual void pointAdded(std::size_t) {}
    virtual void pointsRemoved(const CurveSelection&) {}
    virtual void pointsMoved() {}
    /// Handles Shift and wheel, by that many clicks.
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
    std::optional<QPointF> panning_;  ///< last place of a drag that moves the visible range
    QTimer restTimer_;                ///< ends gestures of keys, which have no release
};

}  // namespace pdr::ui
