#pragma once
/// The mouse over a widget.

#include <QCoreApplication>
#include <QMouseEvent>
#include <QWidget>

namespace pdr::test {

/// Moves to a place of `widget` with a button pressed: unlike QTest::mouseMove(), at once.
inline void dragOn(QWidget& widget, QPoint to, Qt::MouseButton button = Qt::LeftButton,
                   Qt::KeyboardModifiers keys = {}) {
    QMouseEvent event(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, button, keys);
    QCoreApplication::sendEvent(&widget, &event);
}

}  // namespace pdr::test
