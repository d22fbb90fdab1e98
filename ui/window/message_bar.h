#pragma once
/// A bar over the image that shows errors (what went wrong, where, and what to do next) or, in quieter colours,
/// notices. It stays until the user closes it. Long messages show two lines, and the rest on request.

#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <functional>

#include "render/base/result.h"
#include "ui/window/floating.h"

namespace pdr::ui {

class MessageBar : public Floating {
    Q_OBJECT

  public:
    /// Creates the bar over the widget `image`. Null: it stays where it is put.
    explicit MessageBar(QWidget* image = nullptr);

    void showError(const Error& error);
    /// Shows a notice, in quieter colours than an error.
    void showNotice(const QString& sentences);
    /// Appends a line to the message, or shows it as a notice if there is none.
    void add(const QString& sentence);
    /// Puts a line above the message, so that it is seen without a click, or shows it as a notice if there is none.
    void addAbove(const QString& sentence);
    /// Adds a button labelled `action` that offers a remedy. A click on it closes the message and calls `remedy`.
    void offer(const QString& action, std::function<void()> remedy);
    /// Clears the message if it offers `action`; call it when that has been done elsewhere.
    void withdraw(const QString& action);
    void clear();
    QString text() const { return text_.text(); }

  protected:
    QRect placeIn(QSize view) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void showText(const QString& text, bool warning);
    void fit();

    QLabel symbol_;
    QScrollArea lines_;  ///< shows as many lines of the text as have room
    QLabel text_;        ///< declared after lines_, which holds it, and so destroyed before
    QToolButton details_;
    QPushButton offer_;
    std::function<void()> remedy_;  ///< what offer_ does
};

}  // namespace pdr::ui
