#include "ui/slices/slice_keys.h"

#include <cmath>

namespace pdr::ui {
namespace {

constexpr double kZoomPerClick = 1.2;
constexpr int kFarSteps = 5, kPageSteps = 10;

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
    if (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier))
        return false;
    const int key = event.key();
    if (key == Qt::Key_Up || key == Qt::Key_Down)
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
