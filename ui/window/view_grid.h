#pragma once
/// The views in the middle of the window: the image, and up to three slices beside it. A layout says which of them are
/// shown, and where.

#include <QGridLayout>
#include <QWidget>
#include <vector>

#include "render/slice/view_layout.h"

namespace pdr::ui {

class ViewGrid : public QWidget {
    Q_OBJECT

  public:
    /// Shows `image`, which it then owns.
    explicit ViewGrid(QWidget* image);

    /// Adds the view of a slice, which it then owns; there are at most three.
    void addSlice(QWidget* slice);
    ViewLayout layout() const { return layout_; }
    /// Returns whether slices are shown.
    bool showsSlices() const { return layout_ != ViewLayout::image && (!alone_ || alone_ != views_.front()); }
    /// The view that is shown alone; null: those of the layout are shown.
    QWidget* alone() const { return alone_; }
    /// Sets the layout. Ends showing one view alone.
    void setLayout(ViewLayout layout);
    /// Shows `view` alone, or all views of the layout again if it is shown alone.
    void toggleAlone(QWidget* view);

  signals:
    void layoutChanged(pdr::ViewLayout layout);

  private:
    void arrange();
    void place(std::size_t view, int row, int column, int rows = 1);

    QGridLayout grid_;
    std::vector<QWidget*> views_;  ///< the image first
    ViewLayout layout_ = ViewLayout::image;
    QWidget* alone_ = nullptr;  ///< the view that is shown alone; null: those of the layout
};

}  // namespace pdr::ui
