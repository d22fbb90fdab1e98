#pragma once
/// The row of number fields for curves defined by a few numbers, and the box that chooses between such curves and free
/// points. Setters emit no signals.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <array>
#include <memory>
#include <optional>

#include "ui/tissue/curve_shape.h"

namespace pdr::ui {

class ShapeRow : public QWidget {
    Q_OBJECT

  public:
    explicit ShapeRow(QWidget* parent = nullptr);

    /// Returns the box, which the panel places where it has room.
    QComboBox& kinds() { return kind_; }
    /// Returns the chosen shape; none: free points.
    std::optional<CurveShape> shape() const;
    void setFree();
    /// Sets the unit in which numbers are shown; HU at first.
    void setValues(const ValueUnit& values);
    /// Sets the range that the plot shows [voxels], to which the steps of the numbers are sized.
    void setSpan(double voxels) { span_ = voxels; }
    /// Sets the curve from which a chosen shape derives its first numbers, and the histogram. Null: percentiles cannot
    /// be chosen.
    void setBasis(const Curve& curve, std::shared_ptr<const Histogram> histogram);

  signals:
    /// Reports that the user chose a kind or changed one of its numbers. Each report is a complete edit.
    void shapeChosen(const pdr::ui::CurveShape& shape);

  private:
    void choose(int index);
    double number(qsizetype index) const;
    void showNumbers(const std::optional<CurveShape>& shape);

    QComboBox kind_;
    std::array<QLabel, 2> names_;
    std::array<QDoubleSpinBox, 2> numbers_;
    QList<ShapeNumber> shown_;  ///< what the numbers are
    ValueUnit values_;
    double span_ = 4096;  ///< [voxels]
    Curve curve_{{0, 0}};
    std::shared_ptr<const Histogram> histogram_;
};

}  // namespace pdr::ui
