#include "ui/window/view_grid.h"

namespace pdr::ui {

ViewGrid::ViewGrid(QWidget* image) : grid_(this), views_{image} {
    grid_.setContentsMargins(0, 0, 0, 0);
    grid_.setSpacing(2);
    grid_.addWidget(image, 0, 0);
}

void ViewGrid::addSlice(QWidget* slice) {
    views_.push_back(slice);
    slice->setParent(this);
    slice->hide();
    arrange();
}

void ViewGrid::setLayout(ViewLayout layout) {
    const bool changes = layout != layout_;
    layout_ = layout;
    alone_ = nullptr;
    arrange();
    if (changes)
        emit layoutChanged(layout);
}

void ViewGrid::toggleAlone(QWidget* view) {
    alone_ = alone_ == view ? nullptr : view;
    arrange();
}

void ViewGrid::place(std::size_t view, int row, int column, int rows) {
    if (view < views_.size()) {
        grid_.addWidget(views_[view], row, column, rows, 1);
        views_[view]->show();
    }
}

/// Moves the views of the layout to their places and hides the others. The image is never taken out of the window, so
/// that it keeps its size in pixels if its place does not change.
void ViewGrid::arrange() {
    for (QWidget* view : views_)
        grid_.removeWidget(view);
    for (int i = 0; i < 3; ++i) {
        grid_.setRowStretch(i, 0);
        grid_.setColumnStretch(i, 0);
    }
    const auto stretch = [this](int rows, int firstColumn, int columns) {
        for (int row = 0; row < rows; ++row)
            grid_.setRowStretch(row, 1);
        grid_.setColumnStretch(0, firstColumn);
        for (int column = 1; column < columns; ++column)
            grid_.setColumnStretch(column, 1);
    };
    if (alone_ || layout_ == ViewLayout::image) {
        QWidget* only = alone_ ? alone_ : views_.front();
        for (QWidget* view : views_)
            view->setVisible(view == only);
        grid_.addWidget(only, 0, 0);
        return stretch(1, 1, 1);
    }
    if (layout_ == ViewLayout::beside) {
        place(0, 0, 0, 3);
        for (std::size_t i = 1; i < views_.size(); ++i)
            place(i, int(i) - 1, 1);
        return stretch(3, 2, 2);
    }
    place(1, 0, 0);
    place(0, 0, 1);
    place(2, 1, 0);
    place(3, 1, 1);
    stretch(2, 1, 2);
}

}  // namespace pdr::ui
