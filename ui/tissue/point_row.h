#pragma once
/// The exact place and value of a point, to read and to type. Setters are silent.

#include <QDoubleSpinBox>
#include <QToolButton>
#include <optional>

#include "render/scene/edit/curve.h"

namespace pdr::ui {

class PointRow : public QWidget {
    Q_OBJECT

  public:
    explicit PointRow(QWidget* parent = nullptr);

    /// The point, its value in the curve's own unit, which ends at `highest`; nothing: none is selected.
    void setPoint(const std::optional<CurvePoint>& point, double unit, double highest, const QString& unitText);
    /// A stop of a strip: it has a colour and no value.
    void setStop(float hu, const QColor& colour);

  signals:
    /// In the curve's unit, as setPoint() has it.
    void huTyped(double hu);
    void valueTyped(double value);
    void colourWanted();
    void removeWanted();

  private:
    void show(bool value, bool colour, bool any);

    QDoubleSpinBox hu_, value_;
    QToolButton colour_, remove_;
};

}  // namespace pdr::ui
