#pragma once
/// A bar above the picture that says what went wrong, where, and what to do next, or, in quieter colours, what is worth
/// knowing. It stays until it is closed.

#include <QFrame>
#include <QLabel>
#include <QPushButton>

#include "render/base/result.h"

namespace pdr::ui {

class MessageBar : public QFrame {
    Q_OBJECT

  public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showError(const Error& error);
    /// Nothing went wrong.
    void showNotice(const QString& sentences);
    /// Beside what is shown, a button with something that can be done about it; once.
    void offer(const QString& action);
    /// What was offered has been done elsewhere: clears the message that offers it, if there is one.
    void withdraw();
    void clear();
    QString text() const { return text_.text(); }

  signals:
    void offerTaken();

  private:
    void showText(const QString& text, bool warning);

    QLabel symbol_;
    QLabel text_;
    QPushButton offer_;
};

}  // namespace pdr::ui
