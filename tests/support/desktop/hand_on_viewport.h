#pragma once
/// A viewport, a hand with a mouse on it, and what it emits.

#include <QTest>
#include <QWheelEvent>

#include "render/scene/orbit.h"
#include "ui/view/viewport.h"

namespace pdr::ui {

/// A viewport of 400 x 200 whose camera looks from the front, and what it emits.
struct Hand {
    Hand() {
        viewport.resize(400, 200);
        viewport.setCamera(camera);
        viewport.show();
        QObject::connect(&viewport, &Viewport::cameraEdited, [this](const Camera& edited, bool moving) {
            last = edited;
            edits += moving;
            rests += !moving;
        });
    }

    /// Presses at the middle and moves on to `end` in two steps; does not let go.
    void drag(Qt::MouseButton button, QPoint end, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint start(200, 100);
        QTest::mousePress(&viewport, button, modifiers, start);
        for (const QPoint place : {(start + end) / 2, end}) {
            QMouseEvent move(QEvent::MouseMove, place, viewport.mapToGlobal(place), Qt::NoButton, button, modifiers);
            QCoreApplication::sendEvent(&viewport, &move);
        }
    }

    void wheel(QPointF place, int angle) {
        QWheelEvent event(place, viewport.mapToGlobal(place), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&viewport, &event);
    }

    static bool same(const Camera& a, const Camera& b) {
        return glm::length(a.eyeMm - b.eyeMm) < 1e-9 && glm::length(a.targetMm - b.targetMm) < 1e-9 &&
               glm::length(a.imageUp() - b.imageUp()) < 1e-12;
    }

    const Camera camera = standardView(StandardView::anterior, {0, 0, 0}, 150, 2);
    Viewport viewport;
    Camera last;
    int edits = 0;
    int rests = 0;
};

/// Returns a black image of `size`, for a view of 400 x 200.
inline ShownImage shownOf(QSize size) {
    ShownImage shown;
    shown.image = QImage(size, QImage::Format_RGBX8888);
    shown.image.fill(Qt::black);
    return shown;
}

}  // namespace pdr::ui
