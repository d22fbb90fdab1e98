#include "ui/accuracy/status_line.h"

#include <QHBoxLayout>
#include <QMouseEvent>
#include <chrono>

namespace pdr::ui {

StatusLine::StatusLine(QWidget* parent) : QWidget(parent), cancel_(tr("Cancel")) {
    text_.setAccessibleName(tr("Accuracy of the image"));
    text_.setCursor(Qt::PointingHandCursor);
    setDetails({});
    // A long remark leaves the text some room.
    step_.setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
    step_.setMaximumWidth(420);
    bar_.setAccessibleName(tr("Progress"));
    bar_.setRange(0, 1000);
    bar_.setTextVisible(false);
    bar_.setFixedSize(180, 10);
    cancel_.setAccessibleName(tr("Cancel"));
    connect(&cancel_, &QPushButton::clicked, this, &StatusLine::cancelRequested);

    // Hide a remark after a while
    remarkTimer_.setSingleShot(true);
    remarkTimer_.setInterval(std::chrono::seconds(6));
    connect(&remarkTimer_, &QTimer::timeout, &step_, &QWidget::hide);

    // Lay out the line
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 2, 8, 2);
    row->setSpacing(10);
    row->addStrut(cancel_.sizeHint().height());  // keeps the image's size when the button comes and goes
    row->addWidget(&text_, 1);
    row->addWidget(&step_);
    row->addWidget(&bar_);
    row->addWidget(&cancel_);
    endProgress();
}

void StatusLine::setText(const QString& text) {
    text_.setLine(text);
    showTip();
}

void StatusLine::setDetails(const QString& details) {
    details_ = details;
    showTip();
}

/// Updates the tool tip. It repeats the text, which may be cut off with dots.
void StatusLine::showTip() {
    const QString meaning =
        tr("How far the grey levels on the screen are from those of the finished image, for 95 % of the pixels that "
           "show tissue. Four times the samples at least halve it. A denoised image has an error of its own and may "
           "lack fine detail: S shows the raw image. Click for details.");
    QString tip;
    for (const QString& part : {text_.text(), meaning, details_})
        if (!part.isEmpty())
            tip += "<p>" + part.toHtmlEscaped() + "</p>";
    text_.setToolTip(tip);
}

/// Handles clicks on the text here, since the label passes them on.
void StatusLine::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton && text_.geometry().contains(event->position().toPoint()))
        emit textClicked();
}

void StatusLine::showForAWhile(const QString& remark) {
    step_.setLine(remark);
    step_.show();
    remarkTimer_.start();
}

void StatusLine::setProgress(double fraction, const QString& step) {
    remarkTimer_.stop();
    step_.setLine(step);
    bar_.setValue(int(fraction * bar_.maximum()));
    for (QWidget* part : std::initializer_list<QWidget*>{&step_, &bar_, &cancel_})
        part->show();
}

void StatusLine::endProgress() {
    for (QWidget* part : std::initializer_list<QWidget*>{&step_, &bar_, &cancel_})
        part->hide();
}

}  // namespace pdr::ui
