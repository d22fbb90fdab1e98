#pragma once
/// An editor for a curve over this patient's histogram, with faint tissue bands behind it and axes in Hounsfield units
/// and in the curve's own unit. Setters emit no signals.

#include <memory>

#include "ui/tissue/curve_painter.h"
#include "ui/tissue/histogram_bars.h"
#include "ui/tissue/points_plot.h"

namespace pdr::ui {

class CurveEditor : public PointsPlot {
    Q_OBJECT

  public:
    explicit CurveEditor(QWidget* parent = nullptr);

    /// Sets the curve. `top`: the largest value; `unit`: what the axis shows for a value of 1; `unitText`: its name,
    /// "/mm" or empty.
    void setCurve(const Curve& curve, float top, double unit, const QString& unitText);
    /// Sets the colours of the area below the curve.
    void setColours(const std::vector<ColourStop>& stops);
    /// Sets the histogram. Null: not known.
    void setHistogram(std::shared_ptr<const Histogram> histogram);
    void setBarScale(BarScale scale);
    /// Sets the unit of the values along the axis; HU at first.
    void setValues(const ValueUnit& values);

    double unit() const { return unit_; }
    /// Returns the plot's distances from the widget's edges, which align what stands below it.
    QMargins plotMargins() const;

    QSize sizeHint() const override { return {300, 190}; }
    QSize minimumSizeHint() const override { return {200, 80}; }

  protected:
    CurvePoint step() const override;
    QString tipAt(QPointF place) const override;
    void zoomValues(double clicks) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    QString pointText(const CurvePoint& point) const;
    void describe();
    void layOut();

    std::vector<ColourStop> colours_{ColourStop{}};
    std::shared_ptr<const Histogram> histogram_;
    BarScale barScale_ = BarScale::logarithmic;
    double unit_ = 1;
    QString unitText_;
    ValueUnit values_;
};

}  // namespace pdr::ui
