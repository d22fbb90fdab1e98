#include "ui/message_bar.h"

#include <QHBoxLayout>
#include <QToolButton>

#include "ui/to_qt.h"

namespace pdr::ui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
    setAutoFillBackground(true);
    QPalette colours = palette();
    colours.setColor(QPalette::Window, QColor(92, 52, 40));
    colours.setColor(QPalette::WindowText, QColor(250, 238, 230));
    setPalette(colours);

    auto* symbol = new QLabel(QString::fromUtf8("\u26A0"));
    QFont large = symbol->font();
    large.setPointSizeF(large.pointSizeF() * 1.6);
    symbol->setFont(large);
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
    row->addWidget(symbol);
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
    text_.setText(lines);
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
