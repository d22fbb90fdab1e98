#pragma once
/// The panels around the picture: where they stand, and which of them gives way to which, so that most of the window
/// stays with the picture.

#include <QDockWidget>
#include <QList>
#include <QMainWindow>
#include <QMap>

#include "ui/window/floating_panel.h"

namespace pdr::ui {

class WindowDocks : public QObject {
    Q_OBJECT

  public:
    /// What stands in the docks.
    struct Panels {
        QWidget *series, *look, *tissue, *light, *camera, *cut, *rendering, *accuracy, *effects, *nodes;
    };

    /// Adds all docks to `window`; all but series and look are folded away. `picture`: what is to keep most of it; the
    /// accuracy floats over it.
    WindowDocks(QMainWindow& window, QWidget& picture, const Panels& panels);

    /// That show each and fold it away, in the menu's order.
    QList<QAction*> toggles() const;
    QAction* toggleTissue() const { return tissue_->toggleViewAction(); }
    QAction* toggleLight() const { return light_->toggleViewAction(); }
    QAction* toggleCamera() const { return camera_->toggleViewAction(); }
    QAction* toggleAccuracy() const { return accuracy_->toggleViewAction(); }
    /// The window's state with the panels that only gave way, to be kept for another time.
    QByteArray wantedState();
    /// Folds panels away where the window has become too small for them, and brings them back in a larger one.
    void makeRoom();
    /// A series is to be chosen: their list is there and does not give way until one is. Then it is as it was.
    void setChoosing(bool choosing);
    /// Folds all away, or brings back what was there before.
    void setAway(bool away);

  signals:
    /// What the effects cost is looked at, or not any more.
    void effectsShown(bool shown);
    /// The panel of cuts was opened.
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
    QList<QDockWidget*> below_;             ///< the picture, the one opened last first
    QList<QDockWidget*> sides_;             ///< left and right of the picture
    QMap<QDockWidget*, QWidget*> editors_;  ///< wide ones on the right, one at a time, with their panels
    QList<QDockWidget*> gaveWay_;           ///< that come back when there is room
    bool choosing_ = false;                 ///< a series
    bool seriesWereAway_ = false;           ///< before that
    QDockWidget* insisted_ = nullptr;       ///< opened last, which does not give way
    int column_ = 0;                        ///< width of the looks beside an open editor, without it; 0: as it is [px]
    QByteArray stateBefore_;                ///< of the window, as long as all are away
};

}  // namespace pdr::ui
