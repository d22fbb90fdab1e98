#include "ui/window/message_bar.h"

#include <QHBoxLayout>
#include <QStyle>
#include <algorithm>
#include <utility>

#include "ui/text/room_text.h"

namespace pdr::ui {

MessageBar::MessageBar(QWidget* image) : Floating(image) {
    setObjectName("message");  // by which the style sheet colours it
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.6);
    symbol_.setFont(large);
    text_.setAccessibleName(tr("Message"));
    text_.setWordWrap(true);
    text_.setTextFormat(Qt::PlainText);
    text_.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    text_.setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    lines_.setWidget(&text_);
    lines_.setWidgetResizable(true);
    lines_.setFrameShape(QFrame::NoFrame);
    lines_.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    lines_.setFocusPolicy(Qt::NoFocus);
    // Add the buttons
    details_.setText(tr("Details"));
    details_.setAccessibleName(tr("All of the message"));
    details_.setCheckable(true);
    details_.setToolTip(tr("Shows all of the message"));
    connect(&details_, &QToolButton::toggled, this, &MessageBar::fit);
    offer_.setAccessibleName(tr("What can be done"));
    offer_.hide();
    connect(&offer_, &QPushButton::clicked, this, [this] {
        clear();
        remedy_();
    });
    auto* close = new QToolButton;
    close->setAccessibleName(tr("Close the message"));
    close->setText(QChar(0x00D7));
    close->setAutoRaise(true);
    connect(close, &QToolButton::clicked, this, &MessageBar::clear);

    // Lay them out in a row
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 6, 6);
    row->setSpacing(12);
    row->addWidget(&symbol_);
    row->addWidget(&lines_, 1);
    row->addWidget(&details_);
    row->addWidget(&offer_);
    row->addWidget(close, 0, Qt::AlignTop);
    hide();
}

void MessageBar::showError(const Error& error) {
    QString lines = sentence(error.what);
    if (!error.hint.empty())
        lines += ' ' + sentence(error.hint);
    if (!error.where.empty())
        lines += '\n' + QString::fromStdString(error.where);
    showText(lines, true);
}

void MessageBar::showNotice(const QString& sentences) {
    showText(sentences, false);
}

void MessageBar::add(const QString& sentence) {
    if (isHidden())
        return showNotice(sentence);
    text_.setText(text_.text() + '\n' + sentence);
    fit();
}

void MessageBar::addAbove(const QString& sentence) {
    if (isHidden())
        return showNotice(sentence);
    text_.setText(sentence + '\n' + text_.text());
    fit();
}

void MessageBar::showText(const QString& text, bool warning) {
    text_.setText(text);
    symbol_.setText(QString::fromUtf8(warning ? "\u26A0" : "\u2139"));
    setProperty("warning", warning);
    const QList<QWidget*> parts = findChildren<QWidget*>() + QList<QWidget*>{this};
    for (QWidget* part : parts)
        part->style()->polish(part);  // coloured by what the property says now
    offer_.hide();
    details_.setChecked(false);
    show();
    fit();
}

/// Places the bar on the right, below the orientation letter at the upper edge, so that the patient's lines on the left
/// stay legible.
QRect MessageBar::placeIn(QSize view) {
    constexpr int kMost = 640, kMargin = 12, kLetter = 40;
    const int width = std::min(view.width() - 2 * kMargin, kMost);
    resize(width, height());
    fit();
    return {view.width() - kMargin - width, kLetter, width, sizeHint().height()};
}

void MessageBar::resizeEvent(QResizeEvent* event) {
    Floating::resizeEvent(event);
    fit();
}

void MessageBar::fit() {
    constexpr int kShort = 2, kLong = 12;
    layout()->activate();
    // Show the details button only if the text needs more than kShort lines beside it.
    const int line = text_.fontMetrics().lineSpacing(), beside = details_.sizeHint().width() + layout()->spacing();
    const auto heightIn = [&](int width) { return text_.heightForWidth(std::max(width, line)); };
    const int wide = lines_.width() + (details_.isHidden() ? 0 : beside);
    const bool isLong = heightIn(wide) > kShort * line + line / 2;
    details_.setVisible(isLong);
    // Show all lines, up to kLong, or the first kShort ones.
    const int whole = heightIn(isLong ? wide - beside : wide);
    const bool all = !isLong || details_.isChecked();
    lines_.setFixedHeight(all ? std::min(whole, kLong * line) : kShort * line);
    lines_.setVerticalScrollBarPolicy(all && whole > kLong * line ? Qt::ScrollBarAsNeeded : Qt::ScrollBarAlwaysOff);
}

void MessageBar::offer(const QString& action, std::function<void()> remedy) {
    remedy_ = std::move(remedy);
    offer_.setText(action);
    offer_.setAccessibleName(action);
    offer_.show();
}

void MessageBar::withdraw(const QString& action) {
    if (!offer_.isHidden() && offer_.text() == action)
        clear();
}

void MessageBar::clear() {
    text_.clear();
    offer_.hide();
    hide();
}

}  // namespace pdr::ui
