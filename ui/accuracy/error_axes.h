#pragma once
/// Where a moment and an error stand in a plot of one against the other, both logarithmic.

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <vector>

#include "render/accuracy/forecast.h"
#include "ui/accuracy/strip_axis.h"

namespace pdr::ui {

class ErrorAxes {
  public:
    /// In `area`, with room for all that was measured and for `last` seconds. Time as on the strip, from left to right;
    /// from 64 levels or more, at the top, to 1 or less: whole doublings.
    ErrorAxes(const QRectF& area, const std::vector<ErrorPoint>& points, double last);

    const QRectF& area() const { return area_; }
    /// What lies beyond an edge stands at it; levels > 0.
    QPointF at(double seconds, double levels) const { return {xOf(seconds), yOf(levels)}; }
    double xOf(double seconds) const { return area_.left() + time_.at(seconds) * area_.width(); }
    double yOf(double levels) const;

    /// The way of independent samples through `point`, 1 / sqrt(t), as far as there is room for it.
    QLineF rootLine(const ErrorPoint& point) const;

    /// Marks on the axes: 0.1 s to 100 h at most, and doublings of levels, which have their place.
    std::vector<double> moments() const;
    std::vector<double> levels() const;

  private:
    QRectF area_;
    StripAxis time_;
    double coarsest_, finest_;  ///< [levels], at the edges
};

}  // namespace pdr::ui
