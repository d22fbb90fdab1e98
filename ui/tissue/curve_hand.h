#pragma once
/// What a hand does to a curve: pressing, dragging and keys, on the places of a PlotView. It knows no window.

#include <QPointF>
#include <Qt>
#include <optional>

#include "render/scene/edit/curve.h"
#include "ui/tissue/plot_view.h"

namespace pdr::ui {

class CurveHand {
  public:
    /// What is edited. `top`: the largest value. `level`: only places count, a strip without values.
    enum class Kind { values, level };
    explicit CurveHand(Kind kind = Kind::values) : kind_(kind) {}

    const Curve& curve() const { return curve_; }
    const CurveSelection& selection() const { return selection_; }
    float top() const { return top_; }
    /// Another curve; ends a drag of the one before. Points stay selected where there are as many.
    void setCurve(const Curve& curve, float top);

    /// The point at that place, the nearest of several; nothing beside all of them.
    std::optional<std::size_t> pointAt(const PlotView& view, QPointF place) const;
    /// Whether the place is on the line between points.
    bool isOnLine(const PlotView& view, QPointF place) const;

    /// On a point it is chosen, with Shift beside others; on the line, and with Ctrl anywhere, a new one is added;
    /// elsewhere a rubber band begins. True: the curve has changed.
    bool press(const PlotView& view, QPointF place, Qt::KeyboardModifiers keys);
    /// The selected points, or the band, follow. True: the curve has changed.
    bool drag(const PlotView& view, QPointF place);
    /// True: the press and the drag have changed the curve.
    bool release();
    bool isHolding() const { return holding_ != Holding::nothing; }
    /// The rubber band; none where none is drawn.
    std::optional<QRectF> band() const;

    /// True: the curve has changed.
    bool nudge(CurvePoint by);
    bool removeSelected();
    /// A point more, which is then selected; as near as its value may be.
    void add(const CurvePoint& point);
    /// The same on the line, half-way to the next point.
    void addAfterSelected();

    void select(const CurveSelection& selection) { selection_ = selection; }
    void selectAll();
    /// The point `step` further on than the selected one; the first or last where none is.
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
    CurveSelection keeping_;  ///< points that were selected when the band began
    std::size_t held_ = 0;    ///< point under the mouse
    QPointF from_, to_;       ///< of the drag
    bool dragged_ = false;    ///< further than a hand trembles
    bool changed_ = false;
};

}  // namespace pdr::ui
