#include "ui/looks/visible_row.h"

#include <QFormLayout>
#include <QSignalBlocker>
#include <algorithm>

#include "ui/text/room_text.h"

namespace pdr::ui {
VisibleRow::VisibleRow(QWidget* parent) : QWidget(parent) {
    const std::string bones(segment::kBones), lungs(segment::kLungs);
    for (const Visible& parts : {Visible{}, Visible{{lungs}}, Visible{{bones}}, Visible{{bones, lungs}},
                                 Visible{{}, {bones}}, Visible{{}, {lungs}}})
        indexOf(parts);
    part_.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);  // long choices widen the list only
    part_.setMinimumContentsLength(8);
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
    part_.setCurrentIndex(indexOf({visible.shown, visible.hidden}));
    peel_.setValue(visible.peelMm);
}

void VisibleRow::setNotShown(const QString& sentences) {
    notShown_.setText(sentences);
}

void VisibleRow::choose() {
    Visible visible = choices_[std::size_t(part_.currentIndex())];
    visible.peelMm = peel_.value();
    emit chosen(visible);
}

QString VisibleRow::choiceText(const Visible& parts) {
    if (parts.all())
        return tr("Everything");
    if (parts.shown.empty())
        return tr("All but %1").arg(inWords(segment::partNames(parts.hidden)));
    if (parts.hidden.empty())
        return tr("Only %1").arg(inWords(segment::partNames(parts.shown)));
    return tr("Only %1 without %2")
        .arg(inWords(segment::partNames(parts.shown)), inWords(segment::partNames(parts.hidden)));
}

int VisibleRow::indexOf(const Visible& parts) {
    const auto known = std::ranges::find(choices_, parts);
    const int index = int(known - choices_.begin());
    if (known == choices_.end()) {
        choices_.push_back(parts);
        part_.addItem(choiceText(parts));
    }
    return index;
}

}  // namespace pdr::ui
