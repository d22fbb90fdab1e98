#include "ui/widgets/wheel_guard.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QEvent>
#include <QSlider>

namespace pdr::ui {
namespace {

class WheelGuard : public QObject {
  public:
    using QObject::QObject;

  protected:
    bool eventFilter(QObject* control, QEvent* event) override {
        if (event->type() != QEvent::Wheel || static_cast<QWidget*>(control)->hasFocus())
            return false;
        event->ignore();  // so that the parent gets it
        return true;
    }
};

}  // namespace

void guardWheels(QWidget& window) {
    auto* guard = new WheelGuard(&window);
    for (QWidget* control : window.findChildren<QWidget*>()) {
        if (!qobject_cast<QSlider*>(control) && !qobject_cast<QAbstractSpinBox*>(control) &&
            !qobject_cast<QComboBox*>(control))
            continue;
        if (control->focusPolicy() == Qt::WheelFocus)
            control->setFocusPolicy(Qt::StrongFocus);
        control->installEventFilter(guard);
    }
}

}  // namespace pdr::ui
