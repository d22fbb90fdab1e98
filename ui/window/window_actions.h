#pragma once
/// The actions of the window's menus, with texts, keys and tool tips. MainWindow connects them to what they do.

#include <QAction>
#include <QActionGroup>
#include <QMenuBar>
#include <array>

#include "ui/window/recent_menu.h"

namespace pdr::ui {

struct WindowActions {
    QMenu* view;           ///< the View menu
    QAction* endOfPanels;  ///< the separator in it below the panels' entries
    QAction *open, *openFile, *save, *quit, *openPlan, *savePlan, *exportMarks;
    RecentMenu* recent;
    QAction *undo, *redo, *copy;
    std::array<QAction*, 6> views;  ///< in the order of StandardView
    QAction *firstView, *fit;
    QAction *pause, *denoised, *table, *captioned, *errorMap, *boxFirst, *hideName, *alone;
    std::array<QAction*, 3> themes;  ///< in the order of ThemeChoice; one is checked
    QActionGroup* languages;         ///< language code as data, empty for the system's; one is checked
    QAction *manual, *keys, *editKeys, *about;
};

/// Fills the empty menu bar; Help is its last menu. Each action that may have a key has an object name, under which the
/// key is saved, and a tool tip.
WindowActions fillMenus(QMenuBar& bar);

}  // namespace pdr::ui
