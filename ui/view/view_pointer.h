#pragma once
/// The pointer in a view, as tools get it from the view's mouse and wheel events.

#include <QMouseEvent>
#include <QWheelEvent>

#include "ui/view/image_place.h"

namespace pdr::ui {

/// Pointer movement that still counts as a click [px].
inline constexpr double kTremble = 3;

/// The pointer in a view, at a mouse or wheel event.
struct ViewPointer {
    QPointF at;                             ///< [px]
    Qt::MouseButton button = Qt::NoButton;  ///< the button pressed or released; for a move, none
    Qt::MouseButtons held;                  ///< buttons held after the event
    Qt::KeyboardModifiers modifiers;
    bool twice = false;  ///< the second press of a double click
    ImagePlace image;

    /// Returns the place in fractions of the image's width and height.
    QPointF fractions() const { return image.fractionsAt(at); }
};

/// Returns the pointer of an event in a view that shows `image`.
ViewPointer pointerOf(const QSinglePointEvent& event, const ImagePlace& image);
/// Returns by how many clicks the wheel was turned; > 0: away from the user.
double clicksOf(const QWheelEvent& event);

}  // namespace pdr::ui
