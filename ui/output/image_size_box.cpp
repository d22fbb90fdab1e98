#include "ui/output/image_size_box.h"

#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>

#include "render/accuracy/quality.h"
#include "render/film/levels_text.h"
#include "ui/text/accuracy_text.h"
#include "ui/text/language.h"

namespace pdr::ui {
namespace {

constexpr int kLongestOffered = 8192;  ///< longest side offered [pixels]: enough for a poster, and fits in memory

QString sizeText(QSize size) {
    return QString("%1 × %2").arg(size.width()).arg(size.height());
}

QSpinBox* sideField(const QString& name, int pixels) {
    auto* field = new QSpinBox;
    field->setRange(1, kLongestOffered);
    field->setGroupSeparatorShown(false);
    field->setValue(pixels);
    field->setAccessibleName(name);
    field->setToolTip(name);
    return field;
}

/// Creates the choice of annotations. The patient's identity is written only if the user chooses it for this image.
QComboBox* annotateField(const ImageOffer& offer) {
    auto* field = new QComboBox;
    field->addItem(ImageSizeBox::tr("None"), int(Annotate::none));
    field->addItem(ImageSizeBox::tr("Sides"), int(Annotate::sides));
    if (offer.patientKnown)
        field->addItem(ImageSizeBox::tr("Sides and patient"), int(Annotate::patient));
    field->setCurrentIndex(field->findData(int(offer.annotate)));
    field->setAccessibleName(ImageSizeBox::tr("What is written over the image"));
    field->setToolTip(ImageSizeBox::tr(
        "Sides, look, body part, cut, scale and accuracy; or the patient as well. OpenEXR files carry none."));
    return field;
}

}  // namespace

ImageSizeBox::ImageSizeBox(const ImageOffer& offer, QWidget* parent)
    : QWidget(parent),
      cost_(offer.cost),
      sizes_(new QComboBox),
      width_(sideField(tr("Width of the image [pixels]"), offer.view.width())),
      height_(sideField(tr("Height of the image [pixels]"), offer.view.height())),
      stop_(new StopRow),
      takes_(new QLabel),
      annotate_(annotateField(offer)) {
    // Fill the fields
    sizes_->setAccessibleName(tr("Size of the image"));
    sizes_->addItem(tr("As on the screen, %1").arg(sizeText(offer.view)), offer.view);
    for (const QSize size : {offer.view, QSize(2000, 2000), QSize(3840, 2160)})
        sizes_->addItem(tr("Rendered at %1").arg(sizeText(size)), size);
    sizes_->addItem(tr("Rendered at another size"));
    stop_->setRule({.levels = kPlanningLevels});
    takes_->setAccessibleName(tr("How long it takes"));

    // Lay them out
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->addWidget(new QLabel(tr("Size:")), 0, 0);
    grid->addWidget(sizes_, 0, 1);
    grid->addWidget(width_, 0, 2);
    grid->addWidget(new QLabel(QString(QChar(0x00D7))), 0, 3);
    grid->addWidget(height_, 0, 4);
    grid->addWidget(new QLabel(tr("Until:")), 1, 0);
    grid->addWidget(stop_, 1, 1);
    grid->addWidget(takes_, 1, 2, 1, 3);
    grid->addWidget(new QLabel(tr("Annotations:")), 2, 0);
    grid->addWidget(annotate_, 2, 1);
    grid->setColumnStretch(1, 1);

    connect(sizes_, &QComboBox::currentIndexChanged, this, &ImageSizeBox::takeSize);
    connect(width_, &QSpinBox::valueChanged, this, &ImageSizeBox::takeNumbers);
    connect(height_, &QSpinBox::valueChanged, this, &ImageSizeBox::takeNumbers);
    connect(stop_, &StopRow::ruleChosen, this, &ImageSizeBox::showCost);
    takeSize();
}

Annotate ImageSizeBox::annotate() const {
    return Annotate(annotate_->currentData().toInt());
}

void ImageSizeBox::setAnnotatable(bool annotatable) {
    annotate_->setEnabled(annotatable);
}

/// Shows how long rendering takes, "about 40 min to ±4"; nothing if the image is saved as it is.
void ImageSizeBox::showCost() {
    const StopRule rule = stop_->rule();
    const QString target = localNumber(levelsText(rule.levels));
    if (sizes_->currentIndex() == 0)
        return takes_->clear();
    if (!cost_)
        return takes_->setText(tr("how long it takes is not known yet"));
    const double seconds = cost_->secondsUntil(rule.levels, {width_->value(), height_->value()});
    takes_->setText(tr("about %1 to ±%2").arg(durationText(seconds), target));
}

std::optional<QSize> ImageSizeBox::chosenSize() const {
    return sizes_->currentIndex() == 0 ? std::nullopt : std::optional(QSize(width_->value(), height_->value()));
}

/// Fills in the chosen size. The image on the screen has its own size and accuracy, which cannot be changed.
void ImageSizeBox::takeSize() {
    const bool anew = sizes_->currentIndex() > 0;
    for (QWidget* field : std::initializer_list<QWidget*>{width_, height_, stop_})
        field->setEnabled(anew);
    if (const QSize size = sizes_->currentData().toSize(); size.isValid()) {
        const QSignalBlocker width(width_), height(height_);
        width_->setValue(size.width());
        height_->setValue(size.height());
    }
    showCost();
}

void ImageSizeBox::takeNumbers() {
    const QSignalBlocker sizes(sizes_);
    sizes_->setCurrentIndex(sizes_->count() - 1);
    showCost();
}

}  // namespace pdr::ui
