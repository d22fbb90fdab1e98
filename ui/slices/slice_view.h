#pragma once
/// The widget that shows one slice and the crosshair, and passes pointer, wheel and keys to its tools. Setters emit no
/// signals.

#include <QWidget>
#include <optional>

#include "ui/slices/point_tool.h"
#include "ui/slices/shown_slice.h"
#include "ui/slices/slice_keys.h"
#include "ui/view/drag_tool.h"
#include "ui/view/view_tools.h"

namespace pdr::ui {

class SliceView : public QWidget {
    Q_OBJECT

  public:
    explicit SliceView(AnatomicalPlane plane, QWidget* parent = nullptr);

    AnatomicalPlane plane() const { return plane_; }
    /// Returns the view's size in screen pixels.
    ivec2 sizeInPixels() const;
    /// Returns the view's tools, to which others can be added.
    ViewTools& tools() { return tools_; }
    void setSlice(const ShownSlice& slice);
    void clear();
    const std::optional<ShownSlice>& slice() const { return slice_; }
    /// Sets the place at which the other slices cross this one, in the patient (LPS) [mm].
    void setCrosshair(dvec3 placeMm);
    /// Sets the line above the others in the corner, which says what is under the pointer; empty: nothing.
    void setPointed(const QString& text);

    QSize sizeHint() const override { return {300, 300}; }
    QSize minimumSizeHint() const override { return {120, 100}; }

  signals:
    /// Reports another size in screen pixels.
    void resized();
    /// Requests the crosshair this many voxels further in the slice, to the right and down.
    void nudged(QPoint voxels);
    /// Requests the slice `count` further; positive: towards the head, the back or the patient's left.
    void stepped(int count);
    /// Reports a place of the slice that the user points at, in the patient (LPS) [mm].
    void pointed(pdr::dvec3 placeMm);
    /// Reports the place under the pointer, in the patient (LPS) [mm]; none: the pointer has left the view.
    void hovered(const std::optional<pdr::dvec3>& placeMm);
    /// Requests a shift of the slice in its view [mm], to the right and down.
    void panned(pdr::dvec2 mm);
    /// Requests a magnification `factor` times as large, with `placeMm` staying where it is in the view.
    void zoomed(double factor, pdr::dvec3 placeMm);
    /// Requests another window: wider and brighter by these parts of the view's height.
    void windowDragged(double wider, double brighter);
    /// Requests the window of the digit `key`.
    void windowChosen(char key);
    /// Requests to show this view alone, or all views again.
    void aloneRequested();
    /// Requests the context menu at `place` [px], on a right click or the menu key.
    void menuRequested(QPoint place);

  protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void bindTools();
    void followTools();
    ImagePlace place() const;
    dvec3 mmAt(QPointF fractions) const;
    void clickCrosshair(Qt::KeyboardModifiers modifiers);
    void changePlace();

    AnatomicalPlane plane_;
    std::optional<ShownSlice> slice_;
    dvec3 crosshairMm_{0};
    QString pointed_;
    SliceKeys keys_;
    PointTool point_;
    DragTool window_, pan_, zoom_;
    ViewTools tools_;
};

}  // namespace pdr::ui
