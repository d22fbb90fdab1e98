#pragma once
/// The editing of a curve by presses, drags and keys, in the coordinates of a PlotView. It does not depend on any
/// widget.

#include <QPointF>
#include <Qt>
#include <optional>

#include "render/scene/edit/curve.h"
#include "ui/tissue/plot_view.h"

namespace pdr::ui {

class CurveHand {
  public:
    /// What is edited. `values`: points with values in [0, top()]; `level`: a strip whose points have places but no
    /// values.
    enum class Kind { values, level };
    explicit CurveHand(Kind kind = Kind::values) : kind_(kind) {}

    const Curve& curve() const { return curve_; }
    const CurveSelection& selection() const { return selection_; }
    float top() const { return top_; }
    /// Sets the curve; another one ends a drag. The selection stays if the number of points is the same.
    void setCurve(const Curve& curve, float top);

    /// Returns the point at `place`, the nearest of several; none if no point is within reach.
    std::optional<std::size_t> pointAt(const PlotView& view, QPointF place) const;
    /// Returns whether `place` is on the line between points.
    bool isOnLine(const PlotView& view, QPointF place) const;

    /// Presses at `place`. On a point: selects it, with Shift in addition to others. On the line, and with Ctrl
    /// anywhere: adds a point. Elsewhere: begins a rubber band. Returns true if the curve has changed.
    bool press(const PlotView& view, QPointF place, Qt::KeyboardModifiers keys);
    /// Moves the selected points, or the rubber band. Returns true if the curve has changed.
    bool drag(const PlotView& view, QPointF place);
    /// Ends the drag. Returns true if the press or the drag has changed the curve.
    bool release();
    bool isHolding() const { return holding_ != Holding::nothing; }
    /// Returns the rubber band; none if none is drawn.
    std::optional<QRectF> band() const;

    /// Moves the selected points. Returns true if the curve has changed.
    bool nudge(CurvePoint by);
    bool removeSelected();
    /// Adds a point, clamped to the permitted range, and selects it.
    void add(const CurvePoint& point);
    /// Adds a point on the line half-way between the selected point and the next, and selects it.
    void addAfterSelected();

    void select(const CurveSelection& selection) { selection_ = selection; }
    void selectAll();
    /// Selects the point `step` places after the selected one; the first or last if none is selected.
    void selectNext(int step);

  private:
    enum class Holding { nothing, points, band };

    void hold(std::size_t point, QPointF place);
    CurveSelection inside(const PlotView& view, const QRectF& band) const;
    bool become(Curve curve);

    Kind kind_;
    Curve curve_{{0, 0}};
    float top_ = 1;
    CurveSelection selection_;
    Holding holding_ = Holding::nothing;
    Curve before_;            ///< curve when the drag began
    CurveSelection keeping_;  ///< points that were selected when the rubber band began
    std::size_t held_ = 0;    ///< point under the pointer
    QPointF from_, to_;       ///< begin and end of the drag [px]
    bool dragged_ = false;    ///< the drag is longer than the tremble of a click
    bool changed_ = false;
};

}  // namespace pdr::ui
