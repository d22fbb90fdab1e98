#include "ui/floating_panel.h"

#include <QVBoxLayout>
#include <algorithm>

#include "ui/panel_title.h"

namespace pdr::ui {

FloatingPanel::FloatingPanel(QWidget* picture, const QString& title, QWidget* panel, const QKeySequence& key)
    : Floating(picture), toggle_(title, this) {
    setFrameShape(QFrame::StyledPanel);
    toggle_.setCheckable(true);
    toggle_.setShortcut(key);
    connect(&toggle_, &QAction::toggled, this, &QWidget::setVisible);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(panelTitle(title, toggle_));
    column->addWidget(panel, 1);
    hide();
}

/// Right of the texts in the lower left corner, left of the cube, above the letter.
QRect FloatingPanel::placeIn(QSize view) {
    constexpr int kTexts = 290, kCube = 88, kLetter = 40, kMargin = 12, kMost = 900;
    const QSize least = minimumSizeHint();
    const int height = std::min(std::max(least.height(), view.height() * 36 / 100), view.height() - 2 * kMargin);
    int width = view.width() - kTexts - kCube, left = kTexts;
    if (width < least.width()) {
        width = view.width() - 2 * kMargin;
        left = kMargin;
    }
    return {left, view.height() - height - kLetter, std::min(width, kMost), height};
}

}  // namespace pdr::ui
