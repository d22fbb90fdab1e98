#pragma once
/// Pointer interaction with the desktop's widgets, and a rendering of the resulting scene.

#include <QTest>

#include "app/document/document.h"
#include "tests/support/desktop/mouse.h"
#include "tests/support/scenes/images.h"

namespace pdr::app {

/// Presses a button at `from`, moves to `to` in two steps, and releases the button.
inline void drag(QWidget& widget, QPoint from, QPoint to, Qt::KeyboardModifiers keys = {},
                 Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&widget, button, keys, from);
    for (const QPoint place : {(from + to) / 2, to})
        test::dragOn(widget, place, button, keys);
    QTest::mouseRelease(&widget, button, keys, to);
}

/// Renders a small image of the document's scene.
inline Film rendered(const Document& document) {
    Scene scene = document.scene();
    scene.film = {48, 40};
    return test::sampled(Flattener().prepare(scene), 4);
}

}  // namespace pdr::app
