#pragma once
/// What the window's menus offer, with its texts and keys. What each action does is connected by the window.

#include <QAction>
#include <QActionGroup>
#include <QMenuBar>
#include <array>

#include "ui/window/recent_menu.h"

namespace pdr::ui {

class CutTools;

struct WindowActions {
    QAction *open, *save, *quit;
    RecentMenu* recent;
    QAction *undo, *redo, *copy;
    std::array<QAction*, 6> views;  ///< in the order of StandardView
    QAction *firstView, *fit;
    QAction *pause, *smoothed, *table, *captioned, *errorMap, *boxFirst, *hideName, *alone;
    std::array<QAction*, 3> themes;  ///< in the order of ThemeChoice; one is checked
    QActionGroup* languages;         ///< each with its code as data, empty for the system's; one is checked
    QAction *keys, *editKeys, *about;
};

/// Fills the empty bar. Each action that may have a key has an object name, by which that is kept, and a sentence as
/// its tool tip. `panels`: the actions that show panels and fold them away.
WindowActions fillMenus(QMenuBar& bar, const QList<QAction*>& panels, CutTools& cut);

}  // namespace pdr::ui
