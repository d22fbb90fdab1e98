#pragma once
/// The tool bar at the left of the image: buttons of the ten actions that are used most. It stands upright, since width
/// is what a wide screen has to spare.

#include <QToolBar>

namespace pdr::ui {

class ToolBar : public QToolBar {
    Q_OBJECT

  public:
    explicit ToolBar(QWidget* window);

    /// Adds the buttons. `actions`: those of the menus, of which the ones that it shows are found by object name.
    void fill(const QList<QAction*>& actions);
};

}  // namespace pdr::ui
