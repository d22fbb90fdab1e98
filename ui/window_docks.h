#pragma once
/// The panels around the picture: where they stand, and which of them gives way to which, so that most of the window
/// stays with the picture.

#include <QDockWidget>
#include <QList>
#include <QMainWindow>

namespace pdr::ui {

class WindowDocks : public QObject {
    Q_OBJECT

  public:
    /// What stands in the docks.
    struct Panels {
        QWidget *series, *look, *tissue, *light, *rendering, *accuracy, *effects;
    };

    /// Adds all docks to `window`; tissue, light, accuracy and effects are folded away. `picture`: what is to keep most
    /// of it.
    WindowDocks(QMainWindow& window, QWidget& picture, const Panels& panels);

    /// That show each and fold it away, in the menu's order.
    QList<QAction*> toggles() const;
    QAction* toggleTissue() const { return tissue_->toggleViewAction(); }
    QAction* toggleLight() const { return light_->toggleViewAction(); }
    QAction* toggleAccuracy() const { return accuracy_->toggleViewAction(); }
    /// Folds all away, or brings back what was there before.
    void setAway(bool away);

  signals:
    /// What the effects cost is looked at, or not any more.
    void effectsShown(bool shown);

  private:
    struct Editor {
        QDockWidget* dock;
        QWidget* panel;
    };

    QDockWidget* add(const QString& title, QWidget* panel, Qt::DockWidgetArea area, const QKeySequence& key);
    void makeRoomBeside(QDockWidget* opened, QDockWidget* other);
    void giveItsPart(const Editor& editor, bool shown);
    void giveAccuracyItsPart(bool shown);

    QMainWindow& window_;
    QWidget& picture_;
    Panels panels_;
    QDockWidget* series_;
    QDockWidget* look_;
    QDockWidget* tissue_;
    QDockWidget* light_;
    QDockWidget* rendering_;
    QDockWidget* accuracy_;
    QDockWidget* effects_;
    QList<Editor> editors_;        ///< that take the right-hand column, one at a time
    QList<QDockWidget*> gaveWay_;  ///< that come back when the editor goes
    QByteArray stateBefore_;       ///< of the window, as long as all are away
};

}  // namespace pdr::ui
