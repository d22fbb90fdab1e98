#include "ui/cut/cut_tools.h"

namespace pdr::ui {

CutTools::CutTools(Viewport* view)
    : QObject(view),
      layer_(new CutLayer(this)),
      pen_(new FreehandPen(view, this)),
      panel_(new CutPanel),
      handles_(new QAction(tr("Cut with &handles"), this)),
      plane_(new QAction(tr("Add a &plane that faces you"), this)),
      freehand_(new QAction(tr("Freehan&d cut"), this)),
      uncut_(new QAction(tr("Remove all c&uts"), this)) {
    view->tools().add(*layer_);
    view->tools().add(*pen_);
    nameActions();
    for (QAction* action : {handles_, freehand_})
        action->setCheckable(true);

    connect(handles_, &QAction::toggled, layer_, &CutLayer::setHandlesShown);
    connect(plane_, &QAction::triggered, this, [this] { addPlane(-1); });
    connect(panel_, &CutPanel::planeWanted, this, &CutTools::addPlane);
    connect(freehand_, &QAction::toggled, this, &CutTools::draw);
    connect(panel_, &CutPanel::freehandWanted, freehand_, &QAction::toggle);
    connect(pen_, &FreehandPen::ended, freehand_, [this] { freehand_->setChecked(false); });
    connect(uncut_, &QAction::triggered, this, &CutTools::uncutWanted);
    setCuts({}, std::nullopt);
}

/// Sets the actions' object names, under which their keys are saved, their keys and tool tips.
void CutTools::nameActions() {
    const auto name = [](QAction* action, const char* name, const QKeySequence& key, const QString& toolTip) {
        action->setObjectName(name);
        action->setShortcut(key);
        action->setToolTip(toolTip);
    };
    name(handles_, "cutHandles", Qt::Key_C, tr("Drag a side of the box to cut off what lies outside, in millimetres."));
    name(plane_, "cutPlane", Qt::Key_P, tr("Cuts away what lies in front of a plane through the middle of the image."));
    name(freehand_, "cutFreehand", Qt::Key_X,
         tr("Draw a closed outline on the image, then remove the tissue inside it, or everything else."));
    name(uncut_, "uncut", {}, tr("Removes all cuts; this can be undone."));
}

void CutTools::fillMenu(QMenu& menu) {
    menu.addActions({handles_, plane_, freehand_});
    menu.addSeparator();
    menu.addAction(uncut_);
}

void CutTools::setCuts(const Clip& clip, const std::optional<Uncut>& uncut) {
    layer_->setCuts(clip, uncut);
    panel_->setCuts(clip, uncut);
    for (QAction* action : {handles_, plane_, freehand_})
        action->setEnabled(uncut.has_value());
    uncut_->setEnabled(!clip.empty());
}

void CutTools::showHandles() {
    handles_->setChecked(true);
}

void CutTools::hideHandles() {
    handles_->setChecked(false);
}

/// Requests a plane and shows the handles.
void CutTools::addPlane(int axis) {
    showHandles();
    emit planeWanted(axis);
}

void CutTools::draw(bool drawing) {
    if (drawing)
        pen_->startDrawing();
    else
        pen_->stopDrawing();
}

}  // namespace pdr::ui
