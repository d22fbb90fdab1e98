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

}  // namespace

WindowDocks::WindowDocks(QMainWindow& window, QWidget& picture, const Panels& panels)
    : QObject(&window),
      window_(window),
      picture_(picture),
      panels_(panels),
      series_(add("Series", tr("Series"), panels.series, Qt::LeftDockWidgetArea, Qt::Key_F2)),
      look_(
          add("Look", tr("Appearance"), scrolled(panels.look, new ScrolledLooks), Qt::RightDockWidgetArea, Qt::Key_F3)),
      tissue_(add("Tissue", tr("Tissue"), scrolled(panels.tissue), Qt::RightDockWidgetArea, Qt::Key_F5)),
      light_(add("Light", tr("Light"), scrolled(panels.light), Qt::RightDockWidgetArea, Qt::Key_F8)),
      camera_(add("Camera", tr("Camera"), scrolled(panels.camera), Qt::RightDockWidgetArea, Qt::Key_F7)),
      cut_(add("Cut", tr("Cut"), scrolled(panels.cut), Qt::RightDockWidgetArea, Qt::Key_F9)),
      rendering_(add("Rendering", tr("Rendering"), scrolled(panels.rendering), Qt::RightDockWidgetArea, Qt::Key_F4)),
      accuracy_(new FloatingPanel(&picture, tr("Accuracy"), panels.accuracy, Qt::SHIFT | Qt::Key_E)),
      effects_(add("Effects", tr("Render cost by effect"), panels.effects, Qt::BottomDockWidgetArea, Qt::Key_F6)),
      nodes_(add("Nodes", tr("Render nodes"), panels.nodes, Qt::BottomDockWidgetArea, Qt::Key_F12)) {
    look_->widget()->setMinimumHeight(kLookHeight);
    for (QDockWidget* folded : {tissue_, light_, camera_, cut_, rendering_, effects_, nodes_})
        folded->hide();
    nameToggle(*accuracy_->toggleViewAction(), "Accuracy");
    sides_ = {series_, look_, rendering_, tissue_, light_, camera_, cut_};
    editors_ = {{tissue_, panels.tissue}, {light_, panels.light}, {camera_, panels.camera}, {cut_, panels.cut}};
    for (QDockWidget* dock : std::as_const(sides_))
        connect(dock->toggleViewAction(), &QAction::triggered, this, [this, dock](bool shown) { opened(dock, shown); });
    below_ = {effects_, nodes_};
    for (QDockWidget* dock : std::as_const(below_))
        connect(dock->toggleViewAction(), &QAction::triggered, this,
                [this, dock](bool shown) { openedBelow(dock, shown); });
    connect(cut_->toggleViewAction(), &QAction::triggered, this, [this](bool shown) {
        if (shown)
            emit cutShown();
    });
    connect(effects_, &QDockWidget::visibilityChanged, this, &WindowDocks::effectsShown);
}

QList<QAction*> WindowDocks::toggles() const {
    QList<QAction*> actions;
    for (const QDockWidget* dock : all_)
        actions << dock->toggleViewAction();
    actions.insert(actions.indexOf(effects_->toggleViewAction()), accuracy_->toggleViewAction());
    return actions;
}

void WindowDocks::setChoosing(bool choosing) {
    if (choosing == choosing_)
        return;
    choosing_ = choosing;
    if (choosing)
        seriesWereAway_ = series_->isHidden() && !gaveWay_.contains(series_);
    series_->setVisible(choosing || !seriesWereAway_);
    makeRoom();
    window_.resizeDocks({series_}, {choosing ? kChoosing : series_->widget()->sizeHint().width()}, Qt::Horizontal);
}

void WindowDocks::setAway(bool away) {
    accuracy_->setVisible(!away && accuracy_->toggleViewAction()->isChecked());
    if (!away) {
        window_.restoreState(std::exchange(stateBefore_, {}));
        return makeRoom();
    }
    stateBefore_ = window_.saveState();
    for (QDockWidget* dock : std::as_const(all_))
        dock->hide();
}

QDockWidget* WindowDocks::add(const QString& name, const QString& title, QWidget* panel, Qt::DockWidgetArea area,
                              const QKeySequence& key) {
    auto* dock = new QDockWidget(title, &window_);
    dock->setObjectName(name);  // the name under which the window state saves it
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    dock->setWidget(panel);
    dock->toggleViewAction()->setShortcut(key);
    nameToggle(*dock->toggleViewAction(), name);
    dock->setTitleBarWidget(panelTitle(title, *dock->toggleViewAction()));
    window_.addDockWidget(area, dock);
    all_ << dock;
    return dock;
}

/// Names the action; the name is that under which its key is saved.
void WindowDocks::nameToggle(QAction& toggle, const QString& panel) {
    toggle.setObjectName(panel + "Panel");
    toggle.setToolTip(tr("Shows or closes this panel."));
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
    if (dock != effects_)
        window_.resizeDocks({dock}, {int(kPart * window_.height())}, Qt::Vertical);
}

/// Lets the dock that the user opened stay, whatever room it takes. The right-hand column is wider while an editor is
/// open in it.
void WindowDocks::opened(QDockWidget* dock, bool shown) {
    gaveWay_.removeAll(dock);
    insisted_ = shown ? dock : nullptr;
    if (editors_.contains(dock))
        return openedEditor(dock, shown);
    makeRoom();
}

/// Shows one editor at a time and divides the right-hand column between it and the looks.
void WindowDocks::openedEditor(QDockWidget* dock, bool shown) {
    for (QDockWidget* other : editors_.keys())
        if (other != dock)
            other->hide();
    if (shown)
        column_ = look_->isVisible() ? look_->width() : 0;
    makeRoom();
    if (shown) {
        window_.resizeDocks({dock}, {kEditorColumn}, Qt::Horizontal);
        const int room = middleHeight(), look = std::max(room - editors_[dock]->sizeHint().height(), kLookHeight);
        window_.resizeDocks({look_, dock}, {look, std::max(room - look, kEditorHeight)}, Qt::Vertical);
    } else if (column_ > 0) {
        window_.resizeDocks({look_}, {std::exchange(column_, 0)}, Qt::Horizontal);
    }
}

void WindowDocks::makeRoom() {
    if (!stateBefore_.isEmpty())
        return;
    QList<QDockWidget*> wanted = gaveWay_;
    for (QDockWidget* dock : std::as_const(sides_))
        if (!dock->isHidden() && !wanted.contains(dock))
            wanted << dock;
    gaveWay_ = inTheWayOf(wanted);
    for (QDockWidget* dock : std::as_const(wanted))
        dock->setVisible(!gaveWay_.contains(dock));
}

/// Returns which of the `wanted` docks must give way: the rendering settings first, then the series, since one has been
/// chosen; beside an editor the looks, where the two do not fit above each other.
QList<QDockWidget*> WindowDocks::inTheWayOf(QList<QDockWidget*> wanted) const {
    constexpr int kNarrow = 1100;
    constexpr double kPicture = 0.61;  // least share of the window, of which frames take some
    QList<QDockWidget*> away;
    const auto give = [&](QDockWidget* dock) {
        if (dock != insisted_ && !(choosing_ && dock == series_) && wanted.removeOne(dock))
            away << dock;
    };
    const auto editor = std::ranges::find_if(wanted, [&](QDockWidget* dock) { return editors_.contains(dock); });
    QWidget* panel = editor == wanted.end() ? nullptr : editors_[*editor];
    const bool narrow = window_.width() < kNarrow;
    if (narrow || panel)
        give(rendering_);
    if (narrow || pictureShare(wanted) < kPicture)
        give(series_);
    if (panel && middleHeight() < kLookHeight + kEditorHeight)
        give(look_);
    return away;
}

/// Returns the height between menu bar and status bar [px].
int WindowDocks::middleHeight() const {
    return window_.height() - window_.menuBar()->sizeHint().height() - window_.statusBar()->sizeHint().height();
}

int WindowDocks::widthOf(const QDockWidget& dock) const {
    if (editors_.contains(const_cast<QDockWidget*>(&dock)))
        return std::max(kEditorColumn, dock.minimumSizeHint().width());
    if (&dock == look_ && column_ > 0)
        return column_;
    return dock.isVisible() ? dock.width() : dock.sizeHint().width();
}

/// Returns the image's share of the window's area with these panels on its sides, as a fraction.
double WindowDocks::pictureShare(const QList<QDockWidget*>& panels) const {
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
