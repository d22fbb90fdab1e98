#include "ui/cut/plane_row.h"

#include <QHBoxLayout>
#include <QSignalBlocker>

#include "ui/text/cut_text.h"

namespace pdr::ui {

PlaneRow::PlaneRow(QWidget* parent) : QWidget(parent) {
    constexpr double kFarthestMm = 1e4;
    name_.setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);  // long names must not widen the panel
    offset_.setRange(-kFarthestMm, kFarthestMm);
    offset_.setDecimals(1);
    offset_.setSuffix(tr(" mm"));
    offset_.setKeyboardTracking(false);
    offset_.setAccessibleName(tr("Distance of the plane from the middle"));
    offset_.setToolTip(tr("How far the plane is from the middle of the body, towards the side that it cuts away"));
    flip_.setText(QChar(0x21C4));
    flip_.setAccessibleName(tr("Cut the other side"));
    flip_.setToolTip(tr("Cut away the other side"));
    remove_.setText(QChar(0x2212));
    remove_.setAccessibleName(tr("Remove the plane"));
    remove_.setToolTip(tr("Remove the plane (double click on its handle)"));
    for (QToolButton* button : {&flip_, &remove_})
        button->setFocusPolicy(Qt::TabFocus);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(&name_, 1);
    row->addWidget(&offset_);
    row->addWidget(&flip_);
    row->addWidget(&remove_);
    connect(&offset_, &QDoubleSpinBox::valueChanged, this, &PlaneRow::offsetTyped);
    connect(&flip_, &QToolButton::clicked, this, &PlaneRow::flipWanted);
    connect(&remove_, &QToolButton::clicked, this, &PlaneRow::removeWanted);
}

void PlaneRow::setPlane(const ClipPlane& plane, const Uncut& uncut) {
    const QSignalBlocker silent(&offset_);
    name_.setText(planeName(plane));
    name_.setToolTip(name_.text());
    offset_.setValue(planeOffsetMm(plane, uncut));
}

}  // namespace pdr::ui
