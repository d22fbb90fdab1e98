#include "ui/window/tool_bar.h"

#include "ui/window/action_button.h"

namespace pdr::ui {
namespace {

/// The object names of the actions from top to bottom; an empty one is a gap.
constexpr const char* kTools[] = {"firstView", "greyWindow", "crosshair", "",      "distance", "angle", "cutHandles",
                                  "",          "LookPanel",  "",          "pause", "save",     "alone"};

}  // namespace

ToolBar::ToolBar(QWidget* window) : QToolBar(tr("Tool bar"), window) {
    setObjectName("toolBar");  // the name under which the window state saves it
    setMovable(false);
    toggleViewAction()->setObjectName("toolBarShown");  // the name under which its key is saved
    toggleViewAction()->setToolTip(tr("Shows or hides the buttons at the left of the image."));
}

void ToolBar::fill(const QList<QAction*>& actions) {
    for (const QString name : kTools) {
        if (name.isEmpty())
            addSeparator();
        for (QAction* action : actions)
            if (!name.isEmpty() && action->objectName() == name)
                addWidget(new ActionButton(*action));
    }
}

}  // namespace pdr::ui
