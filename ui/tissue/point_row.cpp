#include "ui/tissue/point_row.h"

#include <QHBoxLayout>
#include <QPixmap>
#include <QSignalBlocker>
#include <cmath>

#include "ui/text/value_text.h"
#include "ui/tissue/place_step.h"

namespace pdr::ui {

PointRow::PointRow(QWidget* parent) : QWidget(parent) {
    setValues({});
    hu_.setAccessibleName(tr("Place of the selected point"));
    hu_.setToolTip(tr("Where the first selected point lies; the others move with it"));
    value_.setDecimals(4);
    value_.setAccessibleName(tr("Value of the selected point"));
    value_.setToolTip(tr("How high the first selected point is; the others move with it"));
    colour_.setAccessibleName(tr("Colour of the selected stop"));
    colour_.setToolTip(tr("Choose the colour of the selected stop"));
    remove_.setText(QChar(0x2212));
    remove_.setAccessibleName(tr("Remove the selected points"));
    remove_.setToolTip(tr("Remove the selected points (Del)"));
    for (QDoubleSpinBox* number : {&hu_, &value_}) {
        number->setKeyboardTracking(false);
        number->setMinimumWidth(60);
    }
    for (QToolButton* button : {&colour_, &remove_})
        button->setFocusPolicy(Qt::TabFocus);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(&hu_, 1);
    row->addWidget(&value_, 1);
    row->addWidget(&colour_);
    row->addWidget(&remove_);
    connect(&hu_, &QDoubleSpinBox::valueChanged, this, [this](double value) { emit huTyped(values_.voxelOf(value)); });
    connect(&value_, &QDoubleSpinBox::valueChanged, this, &PointRow::valueTyped);
    connect(&colour_, &QToolButton::clicked, this, &PointRow::colourWanted);
    connect(&remove_, &QToolButton::clicked, this, &PointRow::removeWanted);
    setPoint(std::nullopt, 1, 1, {});
}

void PointRow::setValues(const ValueUnit& values) {
    const QSignalBlocker silent(&hu_);
    values_ = values;
    setSpan(span_);
    hu_.setRange(values.valueOf(double(kLowestHu)), values.valueOf(double(kHighestHu)));
    hu_.setSuffix(' ' + unitName(values));
}

void PointRow::setSpan(double voxels) {
    const QSignalBlocker silent(&hu_);
    span_ = voxels;
    const double step = placeStep(values_, voxels);
    hu_.setDecimals(placeDecimals(values_, step));
    hu_.setSingleStep(step);
}

void PointRow::setPoint(const std::optional<CurvePoint>& point, double unit, double highest, const QString& unitText) {
    const QSignalBlocker silentHu(&hu_), silentValue(&value_);
    hu_.setValue(values_.valueOf(point ? double(point->hu) : 0));
    value_.setRange(0, highest);
    value_.setSingleStep(unit / 100);
    value_.setSuffix(unitText.isEmpty() ? QString() : " " + unitText);
    value_.setValue(point ? double(point->value) * unit : 0);
    if (!point) {
        hu_.clear();
        value_.clear();
    }
    show(true, false, point.has_value());
}

void PointRow::setStop(float hu, const QColor& colour) {
    const QSignalBlocker silent(&hu_);
    hu_.setValue(values_.valueOf(double(hu)));
    QPixmap patch(16, 16);
    patch.fill(colour);
    colour_.setIcon(patch);
    show(false, true, true);
}

void PointRow::show(bool value, bool colour, bool any) {
    value_.setVisible(value);
    colour_.setVisible(colour);
    for (QWidget* control : std::initializer_list<QWidget*>{&hu_, &value_, &colour_, &remove_})
        control->setEnabled(any);
}

}  // namespace pdr::ui
