#include "ui/window/window_docks.h"

#include <QAction>
#include <QMenuBar>
#include <QStatusBar>
#include <algorithm>
#include <utility>

#include "ui/widgets/scrolled.h"
#include "ui/window/panel_title.h"

namespace pdr::ui {
namespace {

constexpr int kEditorColumn = 316;  ///< [px]
constexpr int kChoosing = 380;      ///< width of the series list while the user chooses: names and IDs fit [px]
constexpr int kLookHeight = 200;    ///< least height of the looks above an editor [px]; the rest is scrolled to
constexpr int kEditorHeight = 320;  ///< least height of an editor below the looks [px]

/// A scroll area whose preferred width is that of its content plus the scroll bar.
class ScrolledLooks : public QScrollArea {
  public:
    QSize sizeHint() const override { return widget()->sizeHint() + QSize(verticalScrollBar()->sizeHint().width(), 0); }
};

/// Returns the widget for the dock: the panel, in a scroll area where the window's height might not suffice.
QWidget* contentOf(QWidget* panel, PanelPlace place) {
    if (place == PanelPlace::browser || place == PanelPlace::below)
        return panel;
    return place == PanelPlace::looks ? scrolled(panel, new ScrolledLooks) : scrolled(panel);
}

Qt::DockWidgetArea areaOf(PanelPlace place) {
    if (place == PanelPlace::browser)
        return Qt::LeftDockWidgetArea;
    return place == PanelPlace::below ? Qt::BottomDockWidgetArea : Qt::RightDockWidgetArea;
}

}  // namespace

WindowDocks::WindowDocks(QMainWindow& window, QWidget& image) : QObject(&window), window_(window), image_(image) {}

QAction* WindowDocks::add(QWidget* panel, const PanelInfo& info) {
    QAction* toggle = info.place == PanelPlace::floating ? addFloating(panel, info) : addDock(panel, info);
    toggle->setObjectName(info.name + "Panel");  // the name under which its key is saved
    toggle->setToolTip(tr("Shows or closes this panel."));
    return toggles_[info.name] = toggle;
}

QAction* WindowDocks::addFloating(QWidget* panel, const PanelInfo& info) {
    floating_ << new FloatingPanel(&image_, info.title, panel, info.key);
    return floating_.last()->toggleViewAction();
}

QAction* WindowDocks::addDock(QWidget* panel, const PanelInfo& info) {
    auto* dock = new QDockWidget(info.title, &window_);
    QAction* toggle = dock->toggleViewAction();
    dock->setObjectName(info.name);  // the name under which the window state saves it
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    dock->setWidget(contentOf(panel, info.place));
    toggle->setShortcut(info.key);
    dock->setTitleBarWidget(panelTitle(info.title, *toggle));
    window_.addDockWidget(areaOf(info.place), dock);
    docks_ << dock;
    contents_[dock] = {panel, info.place, info.fixedHeight};
    keep(dock, info.place);
    return toggle;
}

/// Shows or hides a new dock, and lets the toggle make room for it.
void WindowDocks::keep(QDockWidget* dock, PanelPlace place) {
    const QAction* toggle = dock->toggleViewAction();
    if (place == PanelPlace::below) {
        below_ << dock;
        connect(toggle, &QAction::triggered, this, [this, dock](bool shown) { openedBelow(dock, shown); });
    } else {
        connect(toggle, &QAction::triggered, this, [this, dock](bool shown) { opened(dock, shown); });
    }
    if (place == PanelPlace::browser)
        browser_ = dock;
    else if (place == PanelPlace::looks)
        (looks_ = dock)->widget()->setMinimumHeight(kLookHeight);
    else
        dock->hide();
}

QList<QDockWidget*> WindowDocks::docksAt(std::initializer_list<PanelPlace> places) const {
    QList<QDockWidget*> docks;
    for (QDockWidget* dock : docks_)
        if (std::ranges::find(places, contents_[dock].place) != places.end())
            docks << dock;
    return docks;
}

void WindowDocks::setChoosing(bool choosing) {
    if (choosing == choosing_)
        return;
    choosing_ = choosing;
    if (!browser_)
        return;
    if (choosing)
        browserWasAway_ = browser_->isHidden() && !gaveWay_.contains(browser_);
    browser_->setVisible(choosing || !browserWasAway_);
    makeRoom();
    window_.resizeDocks({browser_}, {choosing ? kChoosing : browser_->widget()->sizeHint().width()}, Qt::Horizontal);
}

void WindowDocks::setAway(bool away) {
    for (FloatingPanel* panel : std::as_const(floating_))
        panel->setVisible(!away && panel->toggleViewAction()->isChecked());
    if (!away) {
        window_.restoreState(std::exchange(stateBefore_, {}));
        return makeRoom();
    }
    stateBefore_ = window_.saveState();
    for (QDockWidget* dock : std::as_const(docks_))
        dock->hide();
}

/// Hides docks below the image that have no room: side by side they are legible in wide windows only, and the one
/// opened last stays. Docks that could take any height get a fixed part of the window's, so that most of it stays with
/// the image.
void WindowDocks::openedBelow(QDockWidget* dock, bool shown) {
    constexpr int kLegible = 850;  // [px], across
    constexpr double kPart = 0.22;
    if (!shown)
        return;
    below_.removeAll(dock);
    below_.prepend(dock);
    qsizetype room = std::max(window_.width() / kLegible, 1);
    for (QDockWidget* one : std::as_const(below_))
        if (!one->isHidden() && --room < 0)
            one->hide();
    if (!contents_[dock].fixedHeight)
        window_.resizeDocks({dock}, {int(kPart * window_.height())}, Qt::Vertical);
}

/// Lets the dock that the user opened stay, whatever room it takes. The right-hand column is wider while an editor is
/// open in it.
void WindowDocks::opened(QDockWidget* dock, bool shown) {
    gaveWay_.removeAll(dock);
    insisted_ = shown ? dock : nullptr;
    if (isEditor(dock))
        return openedEditor(dock, shown);
    makeRoom();
}

/// Shows one editor at a time and divides the right-hand column between it and the looks.
void WindowDocks::openedEditor(QDockWidget* dock, bool shown) {
    for (QDockWidget* other : docksAt({PanelPlace::editor}))
        if (other != dock)
            other->hide();
    if (shown)
        column_ = looks_->isVisible() ? looks_->width() : 0;
    makeRoom();
    if (shown) {
        window_.resizeDocks({dock}, {kEditorColumn}, Qt::Horizontal);
        const int room = middleHeight(),
                  looks = std::max(room - contents_[dock].panel->sizeHint().height(), kLookHeight);
        window_.resizeDocks({looks_, dock}, {looks, std::max(room - looks, kEditorHeight)}, Qt::Vertical);
    } else if (column_ > 0) {
        window_.resizeDocks({looks_}, {std::exchange(column_, 0)}, Qt::Horizontal);
    }
}

void WindowDocks::makeRoom() {
    if (!stateBefore_.isEmpty())
        return;
    QList<QDockWidget*> wanted = gaveWay_;
    for (QDockWidget* dock :
         docksAt({PanelPlace::browser, PanelPlace::looks, PanelPlace::editor, PanelPlace::settings}))
        if (!dock->isHidden() && !wanted.contains(dock))
            wanted << dock;
    gaveWay_ = inTheWayOf(wanted);
    for (QDockWidget* dock : std::as_const(wanted))
        dock->setVisible(!gaveWay_.contains(dock));
}

/// Returns which of the `wanted` docks must give way: the settings first, then the browser, since something has been
/// chosen in it; beside an editor the looks, where the two do not fit above each other.
QList<QDockWidget*> WindowDocks::inTheWayOf(QList<QDockWidget*> wanted) const {
    constexpr int kNarrow = 1100;
    constexpr double kImage = 0.61;  // least share of the window, of which frames take some
    QList<QDockWidget*> away;
    const auto give = [&](QDockWidget* dock) {
        if (dock != insisted_ && !(choosing_ && dock == browser_) && wanted.removeOne(dock))
            away << dock;
    };
    const bool editing = std::ranges::any_of(wanted, [&](QDockWidget* dock) { return isEditor(dock); });
    const bool narrow = window_.width() < kNarrow;
    if (narrow || editing)
        for (QDockWidget* settings : docksAt({PanelPlace::settings}))
            give(settings);
    if (narrow || imageShare(wanted) < kImage)
        give(browser_);
    if (editing && middleHeight() < kLookHeight + kEditorHeight)
        give(looks_);
    return away;
}

/// Returns the height between menu bar and status bar [px].
int WindowDocks::middleHeight() const {
    return window_.height() - window_.menuBar()->sizeHint().height() - window_.statusBar()->sizeHint().height();
}

int WindowDocks::widthOf(const QDockWidget& dock) const {
    if (isEditor(const_cast<QDockWidget*>(&dock)))
        return std::max(kEditorColumn, dock.minimumSizeHint().width());
    if (&dock == looks_ && column_ > 0)
        return column_;
    return dock.isVisible() ? dock.width() : dock.sizeHint().width();
}

/// Returns the image's share of the window's area with these panels on its sides, as a fraction.
double WindowDocks::imageShare(const QList<QDockWidget*>& panels) const {
    int left = 0, right = 0;
    for (const QDockWidget* dock : panels) {
        const int width = widthOf(*dock);
        int& side = window_.dockWidgetArea(const_cast<QDockWidget*>(dock)) == Qt::LeftDockWidgetArea ? left : right;
        side = std::max(side, width);
    }
    return double(window_.width() - left - right) * middleHeight() / (double(window_.width()) * window_.height());
}

QByteArray WindowDocks::wantedState() {
    for (QDockWidget* dock : std::as_const(gaveWay_))
        dock->show();
    QByteArray state = window_.saveState();
    for (QDockWidget* dock : std::as_const(gaveWay_))
        dock->hide();
    return state;
}

}  // namespace pdr::ui
