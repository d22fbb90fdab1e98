#pragma once
/// The side bar at the right of the image: one panel at a time, which its tabs choose. It has the same width whatever
/// it shows, so that no change of panels resizes the image.

#include <QAction>
#include <QButtonGroup>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QStackedWidget>
#include <QToolButton>

#include "ui/window/panel_info.h"

namespace pdr::ui {

class SideBar : public QDockWidget {
    Q_OBJECT

  public:
    /// Width of the side bar, unless a panel needs more [px].
    static constexpr int kWidth = 312;

    explicit SideBar(QWidget* window);

    /// Adds a panel behind the others, and returns the action that shows it, which is checked while the panel is seen.
    /// Unchecked, the action goes back to the first panel, or closes the side bar if the panel is the first.
    QAction* add(QWidget* panel, const PanelInfo& info);
    void setVisible(bool shown) override;

  signals:
    /// Reports that the side bar has been opened or closed; not that the window around it has.
    void opened(bool shown);

  private:
    QToolButton* tabOf(const PanelInfo& info, const QAction& toggle);
    void choose(int page, bool shown);
    void showState();

    QHBoxLayout* row_;  ///< the row of tabs
    QButtonGroup tabs_;
    QStackedWidget* pages_;
    QList<QAction*> toggles_;
};

}  // namespace pdr::ui
