#pragma once
/// Mouse events for a widget.

#include <QCoreApplication>
#include <QMouseEvent>
#include <QWidget>

namespace pdr::test {

/// Moves the mouse to a place of `widget` with a button pressed; immediately, unlike QTest::mouseMove().
inline void dragOn(QWidget& widget, QPoint to, Qt::MouseButton button = Qt::LeftButton,
                   Qt::KeyboardModifiers keys = {}) {
    QMouseEvent event(QEvent::MouseMove, to, widget.mapToGlobal(to), Qt::NoButton, button, keys);
    QCoreApplication::sendEvent(&widget, &event);
}

}  // namespace pdr::test
