#pragma once
/// A bar over the picture that says what went wrong, where, and what to do next, or, in quieter colours, what is worth
/// knowing. It stays until it is closed. Long messages show two lines, and the rest when it is asked for.

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>

#include "render/base/result.h"
#include "ui/window/floating.h"

namespace pdr::ui {

class MessageBar : public Floating {
    Q_OBJECT

  public:
    /// Over `picture`; none: wherever it is put.
    explicit MessageBar(QWidget* picture = nullptr);

    void showError(const Error& error);
    /// Nothing went wrong.
    void showNotice(const QString& sentences);
    /// Below what is shown, if anything is.
    void add(const QString& sentence);
    /// Beside what is shown, a button with something that can be done about it; once.
    void offer(const QString& action);
    /// What was offered has been done elsewhere: clears the message that offers it, if there is one.
    void withdraw();
    void clear();
    QString text() const { return text_.text(); }

  signals:
    void offerTaken();

  protected:
    QRect placeIn(QSize view) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void showText(const QString& text, bool warning);
    void fit();

    QLabel symbol_;
    QScrollArea lines_;  ///< of the text, those that have room
    QLabel text_;        ///< after what holds it, and so destroyed before
    QToolButton details_;
    QPushButton offer_;
};

}  // namespace pdr::ui
