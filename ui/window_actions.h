#pragma once
/// What the window's menus offer, with its texts and keys. What each action does is connected by the window.

#include <QAction>
#include <QMenuBar>
#include <array>

namespace pdr::ui {

struct WindowActions {
    QAction *open, *save, *quit;
    QAction *undo, *redo, *copy;
    std::array<QAction*, 6> views;  ///< in the order of StandardView
    QAction* firstView;
    QAction *pause, *smoothed, *table, *captioned, *errorMap, *boxFirst, *alone;
    QAction *keys, *about;
};

/// Fills the empty bar. `panels`: the actions that show panels and fold them away.
WindowActions fillMenus(QMenuBar& bar, const QList<QAction*>& panels);

}  // namespace pdr::ui
