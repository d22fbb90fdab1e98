#pragma once
/// Scroll areas for panels that get less room than they need.

#include <QScrollArea>
#include <QScrollBar>

namespace pdr::ui {

/// Returns `area`, without a frame, around `content`, which it then owns. It scrolls vertically, and horizontally only
/// if the content has grown.
inline QScrollArea* scrolled(QWidget* content, QScrollArea* area = new QScrollArea) {
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setMinimumWidth(content->minimumSizeHint().width() + area->verticalScrollBar()->sizeHint().width());
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(content);
    return area;
}

}  // namespace pdr::ui
