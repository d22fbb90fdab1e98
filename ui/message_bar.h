#pragma once
/// A bar above the picture that says what went wrong, where, and what to do next. It stays until it is closed.

#include <QFrame>
#include <QLabel>

#include "render/base/result.h"

namespace pdr::ui {

class MessageBar : public QFrame {
    Q_OBJECT

  public:
    explicit MessageBar(QWidget* parent = nullptr);

    void showError(const Error& error);
    void clear();
    QString text() const { return text_.text(); }

  private:
    QLabel text_;
};

}  // namespace pdr::ui
