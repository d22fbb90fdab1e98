#pragma once
/// The tools for cutting: handles and a pen on the image, numbers on a panel, and the menu for them.

#include <QMenu>

#include "ui/cut/cut_layer.h"
#include "ui/cut/cut_panel.h"
#include "ui/cut/freehand_pen.h"
#include "ui/view/viewport.h"

namespace pdr::ui {

class CutTools : public QObject {
    Q_OBJECT

  public:
    /// Adds handles and pen to the view's tools. The caller places the panel.
    explicit CutTools(Viewport* view);

    CutLayer& layer() { return *layer_; }
    FreehandPen& pen() { return *pen_; }
    CutPanel& panel() { return *panel_; }
    /// Fills the empty menu.
    void fillMenu(QMenu& menu);

    void setCuts(const Clip& clip, const std::optional<Uncut>& uncut);
    void showHandles();
    void hideHandles();

  signals:
    /// Requests a plane; see CutPanel::planeWanted.
    void planeWanted(int axis);
    /// Requests to undo all cuts.
    void uncutWanted();

  private:
    void nameActions();
    void addPlane(int axis);
    void draw(bool drawing);

    CutLayer* layer_;
    FreehandPen* pen_;
    CutPanel* panel_;
    QAction *handles_, *plane_, *freehand_, *uncut_;
};

}  // namespace pdr::ui
