#pragma once
/// The axes of a plot of error against time, both logarithmic.

#include <QLineF>
#include <QPointF>
#include <QRectF>
#include <vector>

#include "render/accuracy/forecast.h"
#include "ui/accuracy/strip_axis.h"

namespace pdr::ui {

class ErrorAxes {
  public:
    /// Creates axes in `area` [px] that include all `points` and `last` seconds. Time runs from left to right as on the
    /// accuracy strip. The error runs from 64 levels or more at the top to 1 or less at the bottom, in whole doublings.
    ErrorAxes(const QRectF& area, const std::vector<ErrorPoint>& points, double last);

    const QRectF& area() const { return area_; }
    /// Returns the place of an error, levels > 0, after `seconds` of rendering. Values beyond an edge lie on it.
    QPointF at(double seconds, double levels) const { return {xOf(seconds), yOf(levels)}; }
    double xOf(double seconds) const { return area_.left() + time_.at(seconds) * area_.width(); }
    double yOf(double levels) const;

    /// Returns the course of the error of independent samples through `point`, 1 / sqrt(t), as far as it fits.
    QLineF rootLine(const ErrorPoint& point) const;

    /// Marks on the axes: 0.1 s to 100 h at most, and the doublings of levels in range.
    std::vector<double> moments() const;
    std::vector<double> levels() const;

  private:
    QRectF area_;
    StripAxis time_;
    double coarsest_, finest_;  ///< [levels], at the upper and the lower edge
};

}  // namespace pdr::ui
