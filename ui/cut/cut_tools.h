#pragma once
/// The tools that cut: handles and a pen on the picture, numbers on a panel, and the menu that calls them.

#include <QMenu>

#include "ui/cut/cut_layer.h"
#include "ui/cut/cut_panel.h"
#include "ui/cut/freehand_pen.h"

namespace pdr::ui {

class CutTools : public QObject {
    Q_OBJECT

  public:
    /// Layers over `picture`. The panel is to be put somewhere.
    explicit CutTools(QWidget* picture);

    CutLayer& layer() { return *layer_; }
    FreehandPen& pen() { return *pen_; }
    CutPanel& panel() { return *panel_; }
    /// Fills the empty menu.
    void fillMenu(QMenu& menu);

    void setCuts(const Clip& clip, const std::optional<Uncut>& uncut);
    void setPicture(const Camera& camera, QSize size);
    void showHandles();
    /// Esc: ends a gesture or a line; false: there is none.
    bool giveUp();
    void hideHandles();

  signals:
    /// See CutPanel::planeWanted.
    void planeWanted(int axis);
    /// All cuts are to be undone.
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
