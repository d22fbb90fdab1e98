#pragma once
/// Which part of a plot over Hounsfield units is seen, and where its places lie on the screen. Values begin with 0 at
/// the lower edge.

#include <QPointF>
#include <QRectF>
#include <vector>

namespace pdr::ui {

class PlotView {
  public:
    /// The narrowest and the widest range that is shown [HU].
    static constexpr double kNarrowest = 20, kWidest = 70000;

    const QRectF& area() const { return area_; }
    double lowHu() const { return low_; }
    double highHu() const { return high_; }
    /// The value at the upper edge.
    double top() const { return top_; }
    double huPerPixel() const { return (high_ - low_) / area_.width(); }

    double x(double hu) const { return area_.left() + (hu - low_) / huPerPixel(); }
    double y(double value) const { return area_.bottom() - value / top_ * area_.height(); }
    QPointF at(double hu, double value) const { return {x(hu), y(value)}; }
    double hu(double x) const { return low_ + (x - area_.left()) * huPerPixel(); }
    double value(double y) const { return (area_.bottom() - y) / area_.height() * top_; }

    /// At least a pixel wide and high.
    void setArea(const QRectF& area);
    /// Kept within the narrowest and the widest, about its middle.
    void show(double lowHu, double highHu);
    /// > 0
    void setTop(double top) { top_ = top; }
    /// `factor` > 1: closer. What lies at `x` stays there.
    void zoom(double x, double factor);
    /// What is shown moves to the right by so many pixels.
    void pan(double pixels);

    bool operator==(const PlotView&) const = default;

  private:
    QRectF area_{0, 0, 1, 1};
    double low_ = -1024, high_ = 3071;
    double top_ = 1;
};

/// Round numbers in [low, high], `most` at most: multiples of 1, 2 or 5 times a power of ten.
std::vector<double> roundMarks(double low, double high, int most);

}  // namespace pdr::ui
