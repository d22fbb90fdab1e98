#include "ui/tissue/shape_row.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include "ui/tissue/place_step.h"

namespace pdr::ui {
namespace {

constexpr int kPercentiles = 1 + int(CurveShape::Kind::percentiles);  ///< index in the list, after the free points

}  // namespace

ShapeRow::ShapeRow(QWidget* parent) : QWidget(parent) {
    kind_.addItems({tr("Free points"), tr("Window"), tr("Threshold"), tr("Bell"), tr("Percentiles")});
    kind_.setAccessibleName(tr("Shape of the curve"));
    kind_.setToolTip(tr("Free points, or a curve that a few numbers say. It becomes free points when one is moved."));
    connect(&kind_, &QComboBox::activated, this, &ShapeRow::choose);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        numbers_[i].setKeyboardTracking(false);
        numbers_[i].setMinimumWidth(60);
        names_[i].setBuddy(&numbers_[i]);
        row->addWidget(&names_[i]);
        row->addWidget(&numbers_[i], 1);
        connect(&numbers_[i], &QDoubleSpinBox::valueChanged, this, [this] { emit shapeChosen(*shape()); });
    }
    // A click leaves the keyboard focus with the image; Tab still reaches it.
    kind_.setFocusPolicy(Qt::TabFocus);
    setBasis(curve_, nullptr);
    showNumbers(std::nullopt);
}

std::optional<CurveShape> ShapeRow::shape() const {
    if (kind_.currentIndex() == 0)
        return std::nullopt;
    return CurveShape{CurveShape::Kind(kind_.currentIndex() - 1), number(0), number(1)};
}

/// Returns a number of the shape, which may be shown in another unit; 0 where it has none.
double ShapeRow::number(qsizetype index) const {
    if (index >= shown_.size())
        return 0;
    return (numbers_[std::size_t(index)].value() - shown_[index].zero) / shown_[index].step;
}

void ShapeRow::setValues(const ValueUnit& values) {
    values_ = values;
    setFree();
}

void ShapeRow::setFree() {
    kind_.setCurrentIndex(0);
    showNumbers(std::nullopt);
}

void ShapeRow::setBasis(const Curve& curve, std::shared_ptr<const Histogram> histogram) {
    curve_ = curve;
    histogram_ = std::move(histogram);
    static_cast<QStandardItemModel*>(kind_.model())->item(kPercentiles)->setEnabled(histogram_ != nullptr);
}

void ShapeRow::choose(int index) {
    if (index == 0)
        return setFree();
    const Histogram none;
    showNumbers(shapeLike(curve_, CurveShape::Kind(index - 1), histogram_ ? *histogram_ : none));
    emit shapeChosen(*shape());
}

void ShapeRow::showNumbers(const std::optional<CurveShape>& shape) {
    shown_ = shape ? numbersOf(shape->kind, values_) : QList<ShapeNumber>();
    setVisible(!shown_.isEmpty());
    const std::array values{shape ? shape->first : 0, shape ? shape->second : 0};
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const bool visible = qsizetype(i) < shown_.size();
        names_[i].setVisible(visible);
        numbers_[i].setVisible(visible);
        if (!visible)
            continue;
        const ShapeNumber& number = shown_[qsizetype(i)];
        const QSignalBlocker silent(&numbers_[i]);
        const bool ofHundred = number.decimals == 1 && number.highest == 100;
        names_[i].setText(number.name);
        numbers_[i].setAccessibleName(tr("%1 of the curve").arg(number.name));
        numbers_[i].setSuffix(number.unit);
        const double step = placeStep(values_, span_);
        numbers_[i].setDecimals(ofHundred ? number.decimals : placeDecimals(values_, step));
        numbers_[i].setSingleStep(ofHundred ? 0.5 : 10 * step);
        numbers_[i].setRange(number.lowest, number.highest);
        numbers_[i].setValue(values[i] * number.step + number.zero);
    }
}

}  // namespace pdr::ui
