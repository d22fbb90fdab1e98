#include "ui/keys/keys_overlay.h"

#include <QApplication>
#include <QPainter>
#include <algorithm>
#include <array>

#include "ui/keys/key_bindings.h"

namespace pdr::ui {
namespace {

struct Gesture {
    const char* hand;
    const char* effect;
};

/// The gestures that are no actions of a menu.
const auto kGestures = std::to_array<Gesture>({
    {QT_TRANSLATE_NOOP("KeysOverlay", "Left drag, arrow keys"), QT_TRANSLATE_NOOP("KeysOverlay", "Turn the view")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Middle or Shift+left drag"), QT_TRANSLATE_NOOP("KeysOverlay", "Move the view")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Wheel, right drag, + and -"), QT_TRANSLATE_NOOP("KeysOverlay", "Zoom")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Home"), QT_TRANSLATE_NOOP("KeysOverlay", "Reset the view")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Right click"), QT_TRANSLATE_NOOP("KeysOverlay", "Most used")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Ctrl+drag on the image"),
     QT_TRANSLATE_NOOP("KeysOverlay", "Shift the tissue's curve, widen it")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Ctrl+click on the image"),
     QT_TRANSLATE_NOOP("KeysOverlay", "Show the tissue that is there")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Shift+right drag on the image"),
     QT_TRANSLATE_NOOP("KeysOverlay", "Turn the lights")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Double click on a handle"),
     QT_TRANSLATE_NOOP("KeysOverlay", "Undo that side or plane of the cut")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Left, Right on the strip"),
     QT_TRANSLATE_NOOP("KeysOverlay", "Stop sooner, or more accurate")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Mouse at rest"), QT_TRANSLATE_NOOP("KeysOverlay", "Error at that point")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Tab"), QT_TRANSLATE_NOOP("KeysOverlay", "Next control")},
    {QT_TRANSLATE_NOOP("KeysOverlay", "Esc"),
     QT_TRANSLATE_NOOP("KeysOverlay", "Cancel a gesture, reading or a box, close a message")},
});

}  // namespace

KeysOverlay::KeysOverlay(QWidget* window) : QWidget(window) {
    setFocusPolicy(Qt::StrongFocus);
    hide();
}

void KeysOverlay::toggle(const QList<QAction*>& actions) {
    if (isVisible())
        return hide();
    before_ = QApplication::focusWidget();
    show();
    lines_.clear();
    for (const Gesture& gesture : kGestures)
        lines_ << Line{tr(gesture.hand), tr(gesture.effect)};
    for (const QAction* action : actions)
        if (!action->shortcuts().isEmpty())
            lines_ << Line{
                QKeySequence::listToString(action->shortcuts(), QKeySequence::NativeText).replace("; ", ", "),
                plainText(*action)};
    QStringList all{tr("Keys")};
    for (const Line& line : lines_)
        all << line.keys + ": " + line.effect;
    setAccessibleName(all.join("; "));
    setGeometry(parentWidget()->rect());
    raise();
    setFocus();
}

/// Paints the lines in two columns.
void KeysOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(12, 13, 15, 235));
    const int rows = int(lines_.size() + 1) / 2;
    if (rows == 0)
        return;
    const int lineHeight = std::min(int(painter.fontMetrics().height() * 1.8), height() / rows);
    const int top = (height() - lineHeight * rows) / 2, column = width() / 2;
    for (int i = 0; i < int(lines_.size()); ++i) {
        const int y = top + i % rows * lineHeight, left = i / rows * column, middle = left + column * 2 / 5;
        painter.setPen(Qt::white);
        painter.drawText(QRect(left, y, middle - left - 10, lineHeight), Qt::AlignRight | Qt::AlignVCenter,
                         lines_[i].keys);
        painter.setPen(QColor(190, 192, 196));
        painter.drawText(QRect(middle + 10, y, left + column - middle - 10, lineHeight),
                         Qt::AlignLeft | Qt::AlignVCenter, lines_[i].effect);
    }
}

void KeysOverlay::keyPressEvent(QKeyEvent*) {
    hide();
}

void KeysOverlay::mousePressEvent(QMouseEvent*) {
    hide();
}

void KeysOverlay::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    if (before_)
        before_->setFocus();
    before_ = nullptr;
}

}  // namespace pdr::ui
