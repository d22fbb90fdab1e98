#pragma once
/// A hand on the desktop's widgets, and what the renderer makes of what it did.

#include <QTest>

#include "app/document/document.h"
#include "tests/support/mouse.h"
#include "tests/support/pictures.h"

namespace pdr::app {

/// Presses there, moves on in two steps, and lets go.
inline void drag(QWidget& widget, QPoint from, QPoint to, Qt::KeyboardModifiers keys = {},
                 Qt::MouseButton button = Qt::LeftButton) {
    QTest::mousePress(&widget, button, keys, from);
    for (const QPoint place : {(from + to) / 2, to})
        test::dragOn(widget, place, button, keys);
    QTest::mouseRelease(&widget, button, keys, to);
}

/// A small picture of the document's scene.
inline Film rendered(const Document& document) {
    Scene scene = document.scene();
    scene.film = {48, 40};
    return test::sampled(Flattener().prepare(scene), 4);
}

}  // namespace pdr::app
