#pragma once
/// The panels around the image: where they stand, and which of them give way to others when room is short, so that the
/// image keeps most of the window.

#include <QDockWidget>
#include <QList>
#include <QMainWindow>
#include <QMap>

#include "ui/window/floating_panel.h"
#include "ui/window/panel_info.h"

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
    /// Returns the window state to save for the next start. Panels that are hidden only for lack of room count as
    /// shown.
    QByteArray wantedState();
    /// Hides panels where the window has become too small for them, and shows them again in a larger one.
    void makeRoom();
    /// Sets whether the user still has to choose what to open. While true, the browser is shown and does not give way;
    /// then it returns to its previous state.
    void setChoosing(bool choosing);
    /// Hides all panels, or restores those that were shown before.
    void setAway(bool away);

  private:
    /// What a dock holds, and where it stands.
    struct Content {
        QWidget* panel = nullptr;
        PanelPlace place = PanelPlace::editor;
        bool fixedHeight = false;
    };

    QAction* addDock(QWidget* panel, const PanelInfo& info);
    QAction* addFloating(QWidget* panel, const PanelInfo& info);
    void keep(QDockWidget* dock, PanelPlace place);
    QList<QDockWidget*> docksAt(std::initializer_list<PanelPlace> places) const;
    bool isEditor(QDockWidget* dock) const { return contents_[dock].place == PanelPlace::editor; }
    void opened(QDockWidget* dock, bool shown);
    void openedEditor(QDockWidget* dock, bool shown);
    QList<QDockWidget*> inTheWayOf(QList<QDockWidget*> wanted) const;
    int middleHeight() const;
    int widthOf(const QDockWidget& dock) const;
    double imageShare(const QList<QDockWidget*>& panels) const;
    void openedBelow(QDockWidget* dock, bool shown);

    QMainWindow& window_;
    QWidget& image_;
    QList<QDockWidget*> docks_;  ///< in the order in which they were added
    QMap<QDockWidget*, Content> contents_;
    QList<FloatingPanel*> floating_;
    QMap<QString, QAction*> toggles_;  ///< by the panels' names
    QDockWidget* browser_ = nullptr;   ///< null until it is added
    QDockWidget* looks_ = nullptr;     ///< null until it is added
    QList<QDockWidget*> below_;        ///< docks below the image, the one opened last first
    QList<QDockWidget*> gaveWay_;      ///< docks hidden for lack of room; shown again when there is room
    bool choosing_ = false;            ///< the user still has to choose what to open
    bool browserWasAway_ = false;      ///< the user had hidden the browser before that
    QDockWidget* insisted_ = nullptr;  ///< dock opened last, which does not give way; null: none
    int column_ = 0;                   ///< width of the looks before an editor opened [px]; 0: the current one
    QByteArray stateBefore_;           ///< window state before setAway(true); empty: not away
};

}  // namespace pdr::ui
