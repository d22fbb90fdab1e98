#include "ui/slices/slice_keys.h"

#include <cmath>

namespace pdr::ui {
namespace {

constexpr double kZoomPerClick = 1.2;
constexpr int kFarSteps = 5, kPageSteps = 10;

/// Returns the direction of an arrow key, to the right and down; (0, 0): it is none.
QPoint directionOf(int key) {
    return key == Qt::Key_Left    ? QPoint(-1, 0)
           : key == Qt::Key_Right ? QPoint(1, 0)
           : key == Qt::Key_Up    ? QPoint(0, -1)
           : key == Qt::Key_Down  ? QPoint(0, 1)
                                  : QPoint();
}

}  // namespace

bool SliceKeys::wheel(const ViewPointer& pointer, double clicks) {
    if (pointer.modifiers.testFlag(Qt::ControlModifier)) {
        emit zoomed(std::pow(kZoomPerClick, clicks), pointer.fractions());
        return true;
    }
    unused_ += clicks;
    const int whole = int(std::trunc(unused_));
    unused_ -= whole;
    if (whole != 0)
        emit stepped(pointer.modifiers.testFlag(Qt::ShiftModifier) ? kFarSteps * whole : whole);
    return true;
}

bool SliceKeys::key(const QKeyEvent& event) {
    const int key = event.key();
    const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
    if (event.modifiers() & (Qt::ControlModifier | (enter ? Qt::NoModifier : Qt::AltModifier)))
        return false;
    const QPoint direction = directionOf(key);
    if (enter)
        emit clicked(event.modifiers() & Qt::AltModifier);
    else if (!direction.isNull() && (event.modifiers() & Qt::ShiftModifier))
        emit nudged(direction);
    else if (key == Qt::Key_Up || key == Qt::Key_Down)
        emit stepped(key == Qt::Key_Up ? 1 : -1);
    else if (key == Qt::Key_PageUp || key == Qt::Key_PageDown)
        emit stepped(key == Qt::Key_PageUp ? kPageSteps : -kPageSteps);
    else if (key == Qt::Key_Plus || key == Qt::Key_Minus)
        emit zoomed(key == Qt::Key_Plus ? kZoomPerClick : 1 / kZoomPerClick, {0.5, 0.5});
    else if (key >= Qt::Key_0 && key <= Qt::Key_9)
        emit windowChosen(char('0' + (key - Qt::Key_0)));
    else
        return false;
    return true;
}

}  // namespace pdr::ui
