#include "ui/accuracy/accuracy_status.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

namespace pdr::ui {
namespace {

constexpr double kSmall = 0.9;  ///< font size relative to the usual one

ElidedLabel* smallLabel(const QString& accessibleName) {
    auto* label = new ElidedLabel;
    QFont font = label->font();
    font.setPointSizeF(kSmall * font.pointSizeF());
    label->setFont(font);
    label->setAccessibleName(accessibleName);
    return label;
}

}  // namespace

AccuracyStatus::AccuracyStatus(QWidget* parent)
    : QWidget(parent),
      status_(new StatusLine),
      strip_(new AccuracyStrip),
      remarks_(smallLabel(tr("More about the image"))),
      limit_(smallLabel(tr("Voxel size of the scan"))) {
    // Long remarks must not widen the window; the limit is short, and gets its room first.
    limit_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    auto* last = new QHBoxLayout;
    last->setContentsMargins(8, 0, 8, 2);
    last->setSpacing(16);
    last->addWidget(remarks_, 1);
    last->addWidget(limit_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(status_);
    column->addWidget(strip_);
    column->addLayout(last);
}

void AccuracyStatus::setAccuracy(const Accuracy& accuracy) {
    status_->setText(accuracyText(accuracy));
    strip_->setAccuracy(accuracy);
}

void AccuracyStatus::clear() {
    setAccuracy({});
    setMaking({});
    setRemarks({});
    setLimit({});
}

void AccuracyStatus::setMaking(const QString& making) {
    status_->setDetails(making);
}

void AccuracyStatus::setRemarks(const QStringList& remarks) {
    remarks_->setLine(remarks.join(QString::fromUtf8(" · ")));
    remarks_->setToolTip(remarks.join('\n'));
}

void AccuracyStatus::setLimit(const QString& limit) {
    limit_->setLine(limit);
}

}  // namespace pdr::ui
