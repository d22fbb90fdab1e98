#pragma once
/// A chart of the HU, or other values, along a distance, with its ends and the half levels on which they lie. Setters
/// emit no signals.

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "render/volume/value_unit.h"

namespace pdr::ui {

/// Values along the line of a distance, and some way beyond either end.
struct ShownProfile {
    struct Sample {
        double mm;                ///< from the first end towards the second; negative before it
        double hu;                ///< the value, in `unit`
        bool measured;            ///< false outside the scan, and where the scanner measured nothing
        bool acrossHole = false;  ///< interpolated between slices that lie far apart
        bool operator==(const Sample&) const = default;
    };
    std::vector<Sample> samples;                      ///< in the order of their mm; at least two
    double lengthMm = 0;                              ///< where the second end lies
    std::array<std::optional<double>, 2> halfLevels;  ///< values at the ends that lie at an edge
    ValueUnit unit{};
    bool operator==(const ShownProfile&) const = default;
};

class ProfileChart : public QWidget {
    Q_OBJECT

  public:
    explicit ProfileChart(QWidget* parent = nullptr);

    /// Shows a profile, or nothing: then the chart is hidden.
    void setProfile(const std::optional<ShownProfile>& profile);
    /// Returns the point at which a place of the chart is painted [px].
    QPointF pointOf(double mm, double hu) const;
    /// Returns what is read off the chart where the arrow keys have gone: "12.4 mm: 340 HU".
    QString reading() const;

    QSize sizeHint() const override { return {300, 130}; }
    QSize minimumSizeHint() const override { return {200, 110}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

  private:
    /// The least and greatest value of an axis.
    struct Range {
        double low = 0, high = 1;
    };

    void read(int index);
    void describe();
    QString value(double each) const;
    QString unit() const;
    QRectF ground() const;
    void paintAxes(QPainter& painter) const;
    void paintEnds(QPainter& painter) const;
    void paintCurve(QPainter& painter) const;
    void paintReading(QPainter& painter) const;

    ShownProfile profile_;
    Range mm_, hu_;
    int read_ = -1;  ///< the sample that is read off; -1: none
};

}  // namespace pdr::ui
