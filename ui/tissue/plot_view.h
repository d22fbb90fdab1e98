#pragma once
/// The visible part of a plot over Hounsfield units, and the mapping between its values and pixels. Values begin with 0
/// at the lower edge.

#include <QPointF>
#include <QRectF>
#include <cmath>
#include <vector>

namespace pdr::ui {

class PlotView {
  public:
    /// The narrowest and the widest visible range [HU].
    static constexpr double kNarrowest = 20, kWidest = 70000;

    const QRectF& area() const { return area_; }
    double lowHu() const { return low_; }
    double highHu() const { return high_; }
    /// Returns the value at the upper edge.
    double top() const { return top_; }
    double huPerPixel() const { return (high_ - low_) / area_.width(); }

    double x(double hu) const { return area_.left() + (hu - low_) / huPerPixel(); }
    double y(double value) const { return area_.bottom() - value / top_ * area_.height(); }
    QPointF at(double hu, double value) const { return {x(hu), y(value)}; }
    /// Returns the distance of places that can be pointed at [voxels]: 1, or where five pixels do not span a voxel, the
    /// power of ten below a pixel.
    double placeStep() const;
    /// Returns a place rounded to that distance.
    double rounded(double hu) const { return std::round(hu / placeStep()) * placeStep(); }
    double hu(double x) const { return low_ + (x - area_.left()) * huPerPixel(); }
    double value(double y) const { return (area_.bottom() - y) / area_.height() * top_; }

    /// Sets the area [px]; it is made at least one pixel wide and high.
    void setArea(const QRectF& area);
    /// Sets the visible range. Its width is limited to kNarrowest and kWidest about its middle.
    void show(double lowHu, double highHu);
    /// Sets the value at the upper edge, > 0.
    void setTop(double top) { top_ = top; }
    /// Zooms; `factor` > 1 magnifies. The value at `x` stays there.
    void zoom(double x, double factor);
    /// Moves the visible content to the right by `pixels`.
    void pan(double pixels);

    bool operator==(const PlotView&) const = default;

  private:
    QRectF area_{0, 0, 1, 1};
    double low_ = -1024, high_ = 3071;
    double top_ = 1;
};

/// Returns at most `most` round numbers in [low, high]: multiples of 1, 2 or 5 times a power of ten.
std::vector<double> roundMarks(double low, double high, int most);

}  // namespace pdr::ui
