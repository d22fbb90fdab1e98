#pragma once
/// The dock panels around the image: where they stand, and which of them give way to others when room is short, so that
/// the image keeps most of the window.

#include <QDockWidget>
#include <QList>
#include <QMainWindow>
#include <QMap>

#include "ui/window/floating_panel.h"

namespace pdr::ui {

class WindowDocks : public QObject {
    Q_OBJECT

  public:
    /// The panels that the docks hold.
    struct Panels {
        QWidget *series, *look, *tissue, *light, *camera, *cut, *rendering, *accuracy, *effects, *nodes;
    };

    /// Adds all docks to `window`; all but series and look are hidden at first. `picture`: the image's widget, which
    /// keeps most of the window; the accuracy panel floats over it.
    WindowDocks(QMainWindow& window, QWidget& picture, const Panels& panels);

    /// Returns the actions that show and hide each panel, in the menu's order.
    QList<QAction*> toggles() const;
    QAction* toggleTissue() const { return tissue_->toggleViewAction(); }
    QAction* toggleLight() const { return light_->toggleViewAction(); }
    QAction* toggleCamera() const { return camera_->toggleViewAction(); }
    QAction* toggleAccuracy() const { return accuracy_->toggleViewAction(); }
    /// Returns the window state to save for the next start. Panels that are hidden only for lack of room count as
    /// shown.
    QByteArray wantedState();
    /// Hides panels where the window has become too small for them, and shows them again in a larger one.
    void makeRoom();
    /// Sets whether the user still has to choose a series. While true, the series list is shown and does not give way;
    /// then it returns to its previous state.
    void setChoosing(bool choosing);
    /// Hides all panels, or restores those that were shown before.
    void setAway(bool away);

  signals:
    /// Reports whether the cost table of the effects is visible.
    void effectsShown(bool shown);
    /// Emitted when the user opens the cut panel.
    void cutShown();

  private:
    QDockWidget* add(const QString& name, const QString& title, QWidget* panel, Qt::DockWidgetArea area,
                     const QKeySequence& key);
    static void nameToggle(QAction& toggle, const QString& panel);
    void opened(QDockWidget* dock, bool shown);
    void openedEditor(QDockWidget* dock, bool shown);
    QList<QDockWidget*> inTheWayOf(QList<QDockWidget*> wanted) const;
    int middleHeight() const;
    int widthOf(const QDockWidget& dock) const;
    double pictureShare(const QList<QDockWidget*>& panels) const;
    void openedBelow(QDockWidget* dock, bool shown);

    QMainWindow& window_;
    QWidget& picture_;
    Panels panels_;
    QList<QDockWidget*> all_;
    QDockWidget* series_;
    QDockWidget* look_;
    QDockWidget* tissue_;
    QDockWidget* light_;
    QDockWidget* camera_;
    QDockWidget* cut_;
    QDockWidget* rendering_;
    FloatingPanel* accuracy_;
    QDockWidget* effects_;
    QDockWidget* nodes_;
    QList<QDockWidget*> below_;             ///< docks below the image, the one opened last first
    QList<QDockWidget*> sides_;             ///< docks left and right of the image
    QMap<QDockWidget*, QWidget*> editors_;  ///< wide docks on the right, one shown at a time, with their panels
    QList<QDockWidget*> gaveWay_;           ///< docks hidden for lack of room; shown again when there is room
    bool choosing_ = false;                 ///< the user still has to choose a series
    bool seriesWereAway_ = false;           ///< the user had hidden the series list before that
    QDockWidget* insisted_ = nullptr;       ///< dock opened last, which does not give way; null: none
    int column_ = 0;                        ///< width of the looks before an editor opened [px]; 0: the current one
    QByteArray stateBefore_;                ///< window state before setAway(true); empty: not away
};

}  // namespace pdr::ui
