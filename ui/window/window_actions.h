#pragma once
/// The actions of the window's menus, with texts, keys and tool tips. MainWindow connects them to what they do.

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
    QActionGroup* languages;         ///< language code as data, empty for the system's; one is checked
    QAction *keys, *editKeys, *about;
};

/// Fills the empty menu bar. Each action that may have a key has an object name, under which the key is saved, and a
/// tool tip. `panels`: the actions that show and hide panels.
WindowActions fillMenus(QMenuBar& bar, const QList<QAction*>& panels, CutTools& cut);

}  // namespace pdr::ui
