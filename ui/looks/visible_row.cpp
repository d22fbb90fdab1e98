#include "ui/looks/visible_row.h"

#include <QFormLayout>
#include <QSignalBlocker>

namespace pdr::ui {

VisibleRow::VisibleRow(QWidget* parent) : QWidget(parent) {
    part_.addItem(tr("Everything"), int(BodyPart::everything));
    part_.addItem(tr("Lungs"), int(BodyPart::lungs));
    part_.addItem(tr("Bones"), int(BodyPart::bones));
    part_.addItem(tr("All but bones"), int(BodyPart::withoutBones));
    part_.setAccessibleName(tr("Part that is shown"));
    part_.setToolTip(tr("The part of the patient that is shown; the scan itself is not changed"));
    connect(&part_, &QComboBox::activated, this, &VisibleRow::choose);

    peel_.setAccessibleName(tr("Thickness removed"));
    peel_.setToolTip(tr("Thickness removed from the body surface, e.g. skin [mm]"));
    peel_.setRange(0, 50);
    peel_.setDecimals(1);
    peel_.setSingleStep(1);
    peel_.setSuffix(tr(" mm"));
    peel_.setKeyboardTracking(false);  // typing 12 must not set 1 first
    connect(&peel_, &QDoubleSpinBox::valueChanged, this, &VisibleRow::choose);

    notShown_.setWordWrap(true);
    notShown_.setForegroundRole(QPalette::PlaceholderText);
    notShown_.setAlignment(Qt::AlignLeft | Qt::AlignTop);
    notShown_.setMinimumHeight(2 * notShown_.fontMetrics().lineSpacing());  // keeps what is above in place

    part_.setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard focus with the image

    auto* form = new QFormLayout(this);
    form->setContentsMargins(10, 0, 10, 8);
    form->addRow(tr("Sho&w"), &part_);
    form->addRow(tr("&Remove surface"), &peel_);
    form->addRow(&notShown_);
}

void VisibleRow::setChoice(const Visible& visible) {
    const QSignalBlocker noPart(part_), noPeel(peel_);
    part_.setCurrentIndex(part_.findData(int(visible.part)));
    peel_.setValue(visible.peelMm);
}

void VisibleRow::setNotShown(const QString& sentences) {
    notShown_.setText(sentences);
}

void VisibleRow::choose() {
    emit chosen({BodyPart(part_.currentData().toInt()), peel_.value()});
}

}  // namespace pdr::ui
