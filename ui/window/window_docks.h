#pragma once
/// The panels around the image: where they stand, and what gives way in a window that is too small for all, so that the
/// image keeps most of it.

#include <QDockWidget>
#include <QList>
#include <QMainWindow>
#include <QMap>

#include "ui/window/floating_panel.h"
#include "ui/window/panel_info.h"
#include "ui/window/side_bar.h"

namespace pdr::ui {

class WindowDocks : public QObject {
    Q_OBJECT

  public:
    /// `image`: the image's widget, which keeps most of `window`; floating panels lie over it.
    WindowDocks(QMainWindow& window, QWidget& image);

    /// Adds `panel` at its place, and returns the action that opens and closes it.
    QAction* add(QWidget* panel, const PanelInfo& info);
    /// Returns the action that opens and closes the panel `name`; null if there is none.
    QAction* toggle(const QString& name) const { return toggles_.value(name); }
    /// Returns the action that opens and closes the side bar.
    QAction* sideBarToggle() const { return sideBar_->toggleViewAction(); }
    /// Returns the window state to save for the next start. A browser that is hidden only for lack of room counts as
    /// shown.
    QByteArray wantedState();
    /// Restores what wantedState() returned. A state of another version of the program changes nothing.
    void restore(const QByteArray& state);
    /// Hides the browser where the window has become too small for it, and shows it again in a larger one.
    void makeRoom();
    /// Sets whether the user still has to choose what to open. While true, the browser is shown and does not give way;
    /// then it returns to its previous state.
    void setChoosing(bool choosing);
    /// Hides all panels, or restores those that were shown before.
    void setAway(bool away);

  private:
    QAction* addFloating(QWidget* panel, const PanelInfo& info);
    QAction* addDock(QWidget* panel, const PanelInfo& info);
    void openedBelow(QDockWidget* dock, const PanelInfo& info);
    bool isTooSmall() const;
    int middleWidth() const;

    QMainWindow& window_;
    QWidget& image_;
    SideBar* sideBar_;
    QDockWidget* browser_ = nullptr;  ///< null until it is added
    QList<QDockWidget*> below_;       ///< docks below the image, the one opened last first
    QList<FloatingPanel*> floating_;
    QMap<QString, QAction*> toggles_;  ///< by the panels' names
    bool gaveWay_ = false;             ///< the browser is hidden for lack of room, and comes back when there is room
    bool insisted_ = false;            ///< the user opened the browser where it would have given way
    bool choosing_ = false;            ///< the user still has to choose what to open
    bool browserWasAway_ = false;      ///< the user had hidden the browser before that
    QByteArray stateBefore_;           ///< window state before setAway(true); empty: not away
};

}  // namespace pdr::ui
