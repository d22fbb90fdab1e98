#pragma once
/// The numbers of a curve that a few of them say, and the box that chooses between such curves and free points. Setters
/// are silent.

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

    /// The box, which stands where the panel has room for it.
    QComboBox& kinds() { return kind_; }
    /// What is chosen; nothing: free points.
    std::optional<CurveShape> shape() const;
    void setFree();
    /// What a shape begins with when it is chosen; and whether percentiles can be.
    void setBasis(const Curve& curve, std::shared_ptr<const Histogram> histogram);

  signals:
    /// A kind was chosen, or one of its numbers. One step of the hand.
    void shapeChosen(const pdr::ui::CurveShape& shape);

  private:
    void choose(int index);
    void showNumbers(const std::optional<CurveShape>& shape);

    QComboBox kind_;
    std::array<QLabel, 2> names_;
    std::array<QDoubleSpinBox, 2> numbers_;
    Curve curve_{{0, 0}};
    std::shared_ptr<const Histogram> histogram_;
};

}  // namespace pdr::ui
