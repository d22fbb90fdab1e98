#include "ui/widgets/stop_row.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <algorithm>
#include <cmath>
#include <limits>

namespace pdr::ui {
namespace {

constexpr double kMostSeconds = 24 * 3600;
constexpr int kMostSamples = 10'000'000;

/// Sets up a narrow field that reports a number only when it has been typed in full.
void prepare(QAbstractSpinBox& field, const QString& name) {
    field.setAccessibleName(name);
    field.setToolTip(name);
    field.setKeyboardTracking(false);
    field.setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    field.setButtonSymbols(QAbstractSpinBox::NoButtons);  // arrow keys and the wheel change the value as well
    constexpr int kFrame = 18, kNumber = 56;              // [px]
    field.setMinimumWidth(std::max(kNumber, field.fontMetrics().horizontalAdvance(field.specialValueText()) + kFrame));
}

}  // namespace

StopRow::StopRow(QWidget* parent)
    : QWidget(parent), levels_(new QDoubleSpinBox), seconds_(new QDoubleSpinBox), samples_(new QSpinBox) {
    // Set up the three fields
    levels_->setRange(kFinestTarget, kCoarsestTarget);
    levels_->setDecimals(1);
    levels_->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    levels_->setPrefix(tr("±"));
    prepare(*levels_, tr("Stop when 95 % of the tissue is within this many grey levels"));
    seconds_->setRange(0, kMostSeconds);
    seconds_->setDecimals(0);
    seconds_->setSuffix(tr(" s"));
    seconds_->setSpecialValueText(tr("no limit"));
    prepare(*seconds_, tr("Stop after this many seconds of rendering"));
    samples_->setRange(0, kMostSamples);
    samples_->setSuffix(tr(" samples"));
    samples_->setSpecialValueText(tr("no limit"));
    prepare(*samples_, tr("Stop when each pixel has this many samples"));

    // Lay them out in a row
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    for (QAbstractSpinBox* field : {static_cast<QAbstractSpinBox*>(levels_), static_cast<QAbstractSpinBox*>(seconds_),
                                    static_cast<QAbstractSpinBox*>(samples_)})
        row->addWidget(field, 1);
    setFocusProxy(levels_);

    // Report each completed rule
    const auto choose = [this] {
        const StopRule chosen = rule();
        setRule(chosen);
        emit ruleChosen(chosen);
    };
    connect(levels_, &QDoubleSpinBox::valueChanged, this, choose);
    connect(seconds_, &QDoubleSpinBox::valueChanged, this, choose);
    connect(samples_, &QSpinBox::valueChanged, this, choose);
}

void StopRow::setRule(const StopRule& rule) {
    const QSignalBlocker levels(levels_), seconds(seconds_), samples(samples_);
    levels_->setValue(rule.levels);
    seconds_->setValue(std::isfinite(rule.seconds) ? rule.seconds : 0);
    samples_->setValue(int(std::min<std::uint64_t>(rule.samples, kMostSamples)));
}

StopRule StopRow::rule() const {
    const double seconds = seconds_->value();
    return {nearestTarget(levels_->value()), seconds > 0 ? seconds : std::numeric_limits<double>::infinity(),
            std::uint64_t(samples_->value())};
}

}  // namespace pdr::ui
