#include "ui/keys_overlay.h"

#include <QPainter>
#include <algorithm>
#include <array>
#include <utility>

namespace pdr::ui {
namespace {

struct KeyHelp {
    const char* keys;
    const char* effect;
};

const auto kKeys = std::to_array<KeyHelp>({{"Left drag, arrow keys", "turn"},
                                           {"Middle or Shift+left drag", "move"},
                                           {"Wheel, right drag, + and -", "zoom"},
                                           {"1  2  3  4  5  6", "view from the front, back, left, right, head, feet"},
                                           {"R, double click", "first view"},
                                           {"Ctrl+drag on the picture", "shift the tissue's curve, widen it"},
                                           {"Ctrl+click on the picture", "show the tissue that is there"},
                                           {"Shift+right drag on the picture", "turn the lights"},
                                           {"Ctrl+Z, Ctrl+Shift+Z", "undo, redo"},
                                           {"Space", "pause, go on (also beyond what was reached)"},
                                           {"Left, Right on the strip (Tab)", "hold sooner, more accurate"},
                                           {"S", "smoothed, or raw with its noise"},
                                           {"T", "the scanner's table and head holder on and off"},
                                           {"Mouse at rest", "how good the picture is there"},
                                           {"E", "where the picture is still rough"},
                                           {"B, drag; B again", "a box that comes first; no box"},
                                           {"Shift+E, click on the sentence", "accuracy on and off"},
                                           {"Ctrl+O, drop a folder", "open a folder"},
                                           {"Ctrl+S", "save the picture (PNG or EXR), at any size"},
                                           {"Ctrl+C", "copy the picture"},
                                           {"F2", "series on and off"},
                                           {"F3", "look on and off"},
                                           {"F4", "rendering on and off"},
                                           {"F5", "tissue: curves and colours, on and off"},
                                           {"F6", "what the seconds go to, on and off"},
                                           {"F8", "light, on and off"},
                                           {"F11", "the picture alone"},
                                           {"Tab", "next control"},
                                           {"Esc", "cancel reading or a box, close a message"},
                                           {"H, ?", "this help"},
                                           {"Ctrl+Q", "quit"}});

}  // namespace

KeysOverlay::KeysOverlay(QWidget* window) : QWidget(window) {
    QString all = tr("Keys");
    for (const KeyHelp& line : kKeys)
        all += QString("; %1: %2").arg(tr(line.keys), tr(line.effect));
    setAccessibleName(all);
    setFocusPolicy(Qt::StrongFocus);
    hide();
}

void KeysOverlay::toggle() {
    setVisible(!isVisible());
    if (!isVisible())
        return;
    setGeometry(parentWidget()->rect());
    raise();
    setFocus();
}

void KeysOverlay::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), QColor(12, 13, 15, 225));
    const int room = height() / int(kKeys.size());
    const int lineHeight = std::min(int(painter.fontMetrics().height() * 1.8), room);
    const int top = (height() - lineHeight * int(kKeys.size())) / 2;
    const int middle = width() / 2;
    for (int i = 0; i < int(kKeys.size()); ++i) {
        const KeyHelp& line = kKeys[std::size_t(i)];
        const int y = top + i * lineHeight;
        painter.setPen(Qt::white);
        painter.drawText(QRect(0, y, middle - 20, lineHeight), Qt::AlignRight | Qt::AlignVCenter, tr(line.keys));
        painter.setPen(QColor(190, 192, 196));
        painter.drawText(QRect(middle + 20, y, middle - 20, lineHeight), Qt::AlignLeft | Qt::AlignVCenter,
                         tr(line.effect));
    }
}

void KeysOverlay::keyPressEvent(QKeyEvent*) {
    hide();
}

void KeysOverlay::mousePressEvent(QMouseEvent*) {
    hide();
}

}  // namespace pdr::ui
