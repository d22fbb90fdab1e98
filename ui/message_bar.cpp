#include "ui/message_bar.h"

#include <QHBoxLayout>
#include <QStyle>
#include <QToolButton>

#include "ui/to_qt.h"

namespace pdr::ui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
    setObjectName("message");  // by which the style sheet colours it
    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.6);
    symbol_.setFont(large);
    text_.setAccessibleName(tr("Message"));
    text_.setWordWrap(true);
    text_.setTextFormat(Qt::PlainText);
    text_.setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    offer_.setAccessibleName(tr("What can be done"));
    offer_.hide();
    connect(&offer_, &QPushButton::clicked, this, [this] {
        clear();
        emit offerTaken();
    });
    auto* close = new QToolButton;
    close->setAccessibleName(tr("Close the message"));
    close->setText(QChar(0x00D7));
    close->setAutoRaise(true);
    connect(close, &QToolButton::clicked, this, &MessageBar::clear);

    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 6, 6, 6);
    row->setSpacing(12);
    row->addWidget(&symbol_);
    row->addWidget(&text_, 1);
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

void MessageBar::showText(const QString& text, bool warning) {
    text_.setText(text);
    symbol_.setText(QString::fromUtf8(warning ? "\u26A0" : "\u2139"));
    setProperty("warning", warning);
    const QList<QWidget*> parts = findChildren<QWidget*>() + QList<QWidget*>{this};
    for (QWidget* part : parts)
        part->style()->polish(part);  // coloured by what the property says now
    offer_.hide();
    show();
}

void MessageBar::offer(const QString& action) {
    offer_.setText(action);
    offer_.setAccessibleName(action);
    offer_.show();
}

void MessageBar::withdraw() {
    if (!offer_.isHidden())
        clear();
}

void MessageBar::clear() {
    text_.clear();
    offer_.hide();
    hide();
}

}  // namespace pdr::ui
