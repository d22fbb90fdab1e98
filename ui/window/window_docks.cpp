#include "ui/window/window_docks.h"

#include <QMenuBar>
#include <QStatusBar>
#include <algorithm>
#include <utility>

#include "ui/window/panel_title.h"

namespace pdr::ui {
namespace {

constexpr int kChoosing = 380;  ///< width of the series list while the user chooses: names and IDs fit [px]
constexpr int kVersion = 1;     ///< version of the window state; earlier ones hold other panels

}  // namespace

WindowDocks::WindowDocks(QMainWindow& window, QWidget& image)
    : QObject(&window), window_(window), image_(image), sideBar_(new SideBar(&window)), toolBar_(new ToolBar(&window)) {
    window.addDockWidget(Qt::RightDockWidgetArea, sideBar_);
    window.setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);  // the side bar keeps its height
    window.addToolBar(Qt::LeftToolBarArea, toolBar_);
    toolBar_->show();
    yieldingBar_.widget = toolBar_;
    follow(yieldingBar_, *toolBar_->toggleViewAction());
    connect(sideBar_, &SideBar::opened, this, &WindowDocks::makeRoom);
}

QAction* WindowDocks::add(QWidget* panel, const PanelInfo& info) {
    QAction* toggle = info.place == PanelPlace::sideBar    ? sideBar_->add(panel, info)
                      : info.place == PanelPlace::floating ? addFloating(panel, info)
                                                           : addDock(panel, info);
    toggle->setObjectName(info.name + "Panel");  // the name under which its key is saved
    toggle->setToolTip(tr("Shows or closes this panel."));
    return toggles_[info.name] = toggle;
}

QAction* WindowDocks::addFloating(QWidget* panel, const PanelInfo& info) {
    floating_ << new FloatingPanel(&image_, info.title, panel, info.key);
    return floating_.last()->toggleViewAction();
}

/// Adds the browser, or a dock below the image.
QAction* WindowDocks::addDock(QWidget* panel, const PanelInfo& info) {
    auto* dock = new QDockWidget(info.title, &window_);
    QAction* toggle = dock->toggleViewAction();
    dock->setObjectName(info.name);  // the name under which the window state saves it
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    dock->setWidget(panel);
    toggle->setShortcut(info.key);
    dock->setTitleBarWidget(panelTitle(info.title, *toggle));
    if (info.place == PanelPlace::browser) {
        window_.addDockWidget(Qt::LeftDockWidgetArea, browser_ = dock);
        yieldingBrowser_.widget = dock;
        follow(yieldingBrowser_, *toggle);
        return toggle;
    }
    window_.addDockWidget(Qt::BottomDockWidgetArea, dock);
    below_ << dock;
    dock->hide();
    connect(toggle, &QAction::triggered, this, [this, dock, info](bool shown) {
        if (shown)
            openedBelow(dock, info);
    });
    return toggle;
}

/// Hides docks below the image that have no room: side by side they are legible in wide windows only, and the one
/// opened last stays. Docks that could take any height get a fixed part of the window's, so that most of it stays with
/// the image.
void WindowDocks::openedBelow(QDockWidget* dock, const PanelInfo& info) {
    constexpr int kLegible = 700;  // [px], across
    constexpr double kPart = 0.25;
    below_.removeAll(dock);
    below_.prepend(dock);
    int room = std::max(middleWidth() / kLegible, 1);
    for (QDockWidget* one : std::as_const(below_))
        if (!one->isHidden() && --room < 0)
            one->hide();
    if (!info.fixedHeight)
        window_.resizeDocks({dock}, {int(kPart * window_.height())}, Qt::Vertical);
}

void WindowDocks::setChoosing(bool choosing) {
    if (choosing == choosing_)
        return;
    choosing_ = choosing;
    if (!browser_)
        return;
    if (choosing)
        browserWasAway_ = !yieldingBrowser_.wanted();
    browser_->setVisible(choosing || !browserWasAway_);
    makeRoom();
    window_.resizeDocks({browser_}, {choosing ? kChoosing : browser_->widget()->sizeHint().width()}, Qt::Horizontal);
}

void WindowDocks::setAway(bool away) {
    for (FloatingPanel* panel : std::as_const(floating_))
        panel->setVisible(!away && panel->toggleViewAction()->isChecked());
    if (!away) {
        restore(std::exchange(stateBefore_, {}));
        return makeRoom();
    }
    stateBefore_ = window_.saveState(kVersion);
    for (QDockWidget* dock : window_.findChildren<QDockWidget*>())
        dock->hide();
    toolBar_->hide();
}

/// Lets the user have the last word on whether something is shown.
void WindowDocks::follow(Yielding& yielding, const QAction& toggle) {
    connect(&toggle, &QAction::triggered, this, [&yielding](bool shown) {
        yielding.gaveWay = false;
        yielding.insisted = shown;
    });
}

void WindowDocks::makeRoom() {
    constexpr int kNarrow = 1100;  // [px]; there the browser is always in the way
    if (!browser_ || !stateBefore_.isEmpty())
        return;
    int room = roomAtTheSides();
    fit(yieldingBar_, room);
    if (window_.width() < kNarrow)
        room = 0;
    if (choosing_)
        room = window_.width();
    fit(yieldingBrowser_, room);
}

/// Shows what is wanted if it fits into `room` [px], from which it takes its width.
void WindowDocks::fit(Yielding& yielding, int& room) {
    QWidget& widget = *yielding.widget;
    const bool wanted = yielding.wanted();
    const int width = widget.isHidden() ? widget.sizeHint().width() : widget.width();
    yielding.gaveWay = wanted && !yielding.insisted && width > room;
    widget.setVisible(wanted && !yielding.gaveWay);
    if (!widget.isHidden())
        room -= width;
}

/// Returns the width that browser and tool bar may take, so that the image keeps most of the window [px].
int WindowDocks::roomAtTheSides() const {
    constexpr double kImage = 0.61;  // least share of the window's area, of which frames take some
    const QSize window = window_.size();
    const int height =
        window.height() - window_.menuBar()->sizeHint().height() - window_.statusBar()->sizeHint().height();
    return middleWidth() - int(kImage * window.width() * window.height() / std::max(height, 1));
}

/// Returns the width that the side bar leaves to image and browser [px].
int WindowDocks::middleWidth() const {
    return window_.width() - (sideBar_->isHidden() ? 0 : sideBar_->sizeHint().width());
}

QByteArray WindowDocks::wantedState() {
    for (const Yielding* yielding : {&yieldingBar_, &yieldingBrowser_})
        if (yielding->gaveWay)
            yielding->widget->show();
    QByteArray state = window_.saveState(kVersion);
    for (const Yielding* yielding : {&yieldingBar_, &yieldingBrowser_})
        if (yielding->gaveWay)
            yielding->widget->hide();
    return state;
}

void WindowDocks::restore(const QByteArray& state) {
    window_.restoreState(state, kVersion);
}

}  // namespace pdr::ui
