#include "ui/window/floating_panel.h"

#include <QVBoxLayout>
#include <algorithm>

#include "ui/window/panel_title.h"

namespace pdr::ui {

FloatingPanel::FloatingPanel(QWidget* image, const QString& title, QWidget* panel, const QKeySequence& key)
    : Floating(image), toggle_(title, this) {
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

/// Places the panel above the texts and marks in the lower corners, between the letters at the left and right edges.
QRect FloatingPanel::placeIn(QSize view) {
    constexpr int kCorners = 104, kLetters = 40, kMost = 800;
    const int height = std::min(std::max(minimumSizeHint().height(), view.height() * 36 / 100), view.height());
    const int width = std::min(view.width() - 2 * kLetters, kMost);
    const int bottom = std::max(view.height() - kCorners, height);
    return {view.width() - kLetters - width, bottom - height, width, height};
}

}  // namespace pdr::ui
