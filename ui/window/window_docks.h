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
#include "ui/window/tool_bar.h"

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
    ToolBar& toolBar() { return *toolBar_; }
    /// Returns the window state to save for the next start. What is hidden only for lack of room counts as shown.
    QByteArray wantedState();
    /// Restores what wantedState() returned. A state of another version of the program changes nothing.
    void restore(const QByteArray& state);
    /// Hides browser and tool bar where the window has become too small for them, and shows them again in a larger one.
    void makeRoom();
    /// Sets whether the user still has to choose what to open. While true, the browser is shown and does not give way;
    /// then it returns to its previous state.
    void setChoosing(bool choosing);
    /// Hides all panels and the tool bar, or restores those that were shown before.
    void setAway(bool away);

  private:
    /// What is hidden where room is short.
    struct Yielding {
        QWidget* widget = nullptr;  ///< null until it is added
        bool gaveWay = false;       ///< hidden for lack of room; it comes back when there is room
        bool insisted = false;      ///< opened by the user: it stays, whatever room it takes

        bool wanted() const { return gaveWay || !widget->isHidden(); }
    };

    void follow(Yielding& yielding, const QAction& toggle);
    void fit(Yielding& yielding, int& room);
    int roomAtTheSides() const;
    QAction* addFloating(QWidget* panel, const PanelInfo& info);
    QAction* addDock(QWidget* panel, const PanelInfo& info);
    void openedBelow(QDockWidget* dock, const PanelInfo& info);
    int middleWidth() const;

    QMainWindow& window_;
    QWidget& image_;
    SideBar* sideBar_;
    ToolBar* toolBar_;
    QDockWidget* browser_ = nullptr;  ///< null until it is added
    Yielding yieldingBar_, yieldingBrowser_;
    QList<QDockWidget*> below_;  ///< docks below the image, the one opened last first
    QList<FloatingPanel*> floating_;
    QMap<QString, QAction*> toggles_;  ///< by the panels' names
    bool choosing_ = false;            ///< the user still has to choose what to open
    bool browserWasAway_ = false;      ///< the user had hidden the browser before that
    QByteArray stateBefore_;           ///< window state before setAway(true); empty: not away
};

}  // namespace pdr::ui
