#pragma once
/// Panels that take less room than they would like to: what does not fit is reached by scrolling.

#include <QScrollArea>
#include <QScrollBar>

namespace pdr::ui {

/// `area` around `content`, which belongs to it, without a frame. It scrolls up and down, and sideways only where what
/// it shows has grown.
inline QScrollArea* scrolled(QWidget* content, QScrollArea* area = new QScrollArea) {
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setMinimumWidth(content->minimumSizeHint().width() + area->verticalScrollBar()->sizeHint().width());
    area->setFocusPolicy(Qt::NoFocus);
    area->setWidget(content);
    return area;
}

}  // namespace pdr::ui
