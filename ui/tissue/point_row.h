#pragma once
/// Fields that show and edit the exact place and value of a point. Setters emit no signals.

#include <QDoubleSpinBox>
#include <QToolButton>
#include <optional>

#include "render/scene/edit/curve.h"
#include "render/volume/value_unit.h"

namespace pdr::ui {

class PointRow : public QWidget {
    Q_OBJECT

  public:
    explicit PointRow(QWidget* parent = nullptr);

    /// Sets the unit in which the place of a point is shown; HU at first.
    void setValues(const ValueUnit& values);
    /// Sets the range that the plot shows [voxels], to which the steps of the place are sized.
    void setSpan(double voxels);
    /// Shows a point, with its value times `unit`, up to `highest`. None: no point is selected.
    void setPoint(const std::optional<CurvePoint>& point, double unit, double highest, const QString& unitText);
    /// Shows a stop of a colour strip, which has a colour and no value.
    void setStop(float hu, const QColor& colour);

  signals:
    /// Reports a typed place [voxels: HU, unless the values are none], and a typed value in the unit given to
    /// setPoint().
    void huTyped(double hu);
    void valueTyped(double value);
    void colourWanted();
    void removeWanted();

  private:
    void show(bool value, bool colour, bool any);

    ValueUnit values_;
    double span_ = 4096;  ///< [voxels]
    QDoubleSpinBox hu_, value_;
    QToolButton colour_, remove_;
};

}  // namespace pdr::ui
