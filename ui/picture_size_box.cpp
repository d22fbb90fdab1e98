#include "ui/picture_size_box.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "render/base/image_size.h"

namespace pdr::ui {
namespace {

QString sizeText(QSize size) {
    return QString("%1 × %2").arg(size.width()).arg(size.height());
}

QSpinBox* sideField(const QString& name, int pixels) {
    auto* field = new QSpinBox;
    field->setRange(1, kLongestSide);
    field->setGroupSeparatorShown(false);
    field->setValue(pixels);
    field->setAccessibleName(name);
    field->setToolTip(name);
    return field;
}

}  // namespace

PictureSizeBox::PictureSizeBox(QSize view, const StopRule& stop, QWidget* parent)
    : QWidget(parent),
      sizes_(new QComboBox),
      width_(sideField(tr("Width of the picture [pixels]"), view.width())),
      height_(sideField(tr("Height of the picture [pixels]"), view.height())),
      stop_(new StopRow) {
    sizes_->setAccessibleName(tr("Size of the picture"));
    sizes_->addItem(tr("As it is on the screen, %1").arg(sizeText(view)), view);
    for (const QSize size : {view, QSize(2000, 2000), QSize(3840, 2160)})
        sizes_->addItem(tr("Made anew, %1").arg(sizeText(size)), size);
    sizes_->addItem(tr("Made anew, another size"));
    stop_->setRule(stop);

    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(new QLabel(tr("Size:")), 0, 0);
    grid->addWidget(sizes_, 0, 1);
    grid->addWidget(width_, 0, 2);
    grid->addWidget(new QLabel(QString(QChar(0x00D7))), 0, 3);
    grid->addWidget(height_, 0, 4);
    grid->addWidget(new QLabel(tr("Until:")), 1, 0);
    grid->addWidget(stop_, 1, 1, 1, 4);
    grid->setColumnStretch(1, 1);

    connect(sizes_, &QComboBox::currentIndexChanged, this, &PictureSizeBox::takeSize);
    connect(width_, &QSpinBox::valueChanged, this, &PictureSizeBox::takeNumbers);
    connect(height_, &QSpinBox::valueChanged, this, &PictureSizeBox::takeNumbers);
    takeSize();
}

std::optional<QSize> PictureSizeBox::chosenSize() const {
    return sizes_->currentIndex() == 0 ? std::nullopt : std::optional(QSize(width_->value(), height_->value()));
}

/// What is on the screen has its size, and is as good as it is.
void PictureSizeBox::takeSize() {
    const bool anew = sizes_->currentIndex() > 0;
    for (QWidget* field : std::initializer_list<QWidget*>{width_, height_, stop_})
        field->setEnabled(anew);
    const QSize size = sizes_->currentData().toSize();
    if (!size.isValid())
        return;
    const QSignalBlocker width(width_), height(height_);
    width_->setValue(size.width());
    height_->setValue(size.height());
}

void PictureSizeBox::takeNumbers() {
    const QSignalBlocker sizes(sizes_);
    sizes_->setCurrentIndex(sizes_->count() - 1);
}

}  // namespace pdr::ui
