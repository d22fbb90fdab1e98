#include "ui/window_docks.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <utility>

#include "ui/scrolled.h"

namespace pdr::ui {
namespace {

/// A quiet heading with a way to fold the panel.
QWidget* panelTitle(const QString& title, QDockWidget* dock) {
    auto* heading = new QLabel(title);
    heading->setForegroundRole(QPalette::PlaceholderText);
    auto* fold = new QToolButton;
    fold->setText(QChar(0x00D7));
    fold->setAutoRaise(true);
    fold->setFocusPolicy(Qt::TabFocus);
    fold->setAccessibleName(WindowDocks::tr("Fold %1 away").arg(title));
    fold->setToolTip(WindowDocks::tr("Fold away (%1)").arg(dock->toggleViewAction()->shortcut().toString()));
    QObject::connect(fold, &QToolButton::clicked, dock->toggleViewAction(), &QAction::trigger);

    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(10, 4, 6, 2);
    row->addWidget(heading, 1);
    row->addWidget(fold);
    return bar;
}

}  // namespace

WindowDocks::WindowDocks(QMainWindow& window, QWidget& picture, const Panels& panels)
    : QObject(&window),
      window_(window),
      picture_(picture),
      panels_(panels),
      series_(add(tr("Series"), panels.series, Qt::LeftDockWidgetArea, Qt::Key_F2)),
      look_(add(tr("Look"), panels.look, Qt::RightDockWidgetArea, Qt::Key_F3)),
      tissue_(add(tr("Tissue"), scrolled(panels.tissue), Qt::RightDockWidgetArea, Qt::Key_F5)),
      light_(add(tr("Light"), scrolled(panels.light), Qt::RightDockWidgetArea, Qt::Key_F8)),
      rendering_(add(tr("Rendering"), scrolled(panels.rendering), Qt::RightDockWidgetArea, Qt::Key_F4)),
      accuracy_(add(tr("Accuracy"), panels.accuracy, Qt::BottomDockWidgetArea, Qt::SHIFT | Qt::Key_E)),
      effects_(add(tr("What the seconds go to"), panels.effects, Qt::BottomDockWidgetArea, Qt::Key_F6)) {
    for (QDockWidget* folded : {tissue_, light_, accuracy_, effects_})
        folded->hide();
    makeRoomBeside(accuracy_, effects_);
    makeRoomBeside(effects_, accuracy_);
    editors_ = {{tissue_, panels.tissue}, {light_, panels.light}};
    for (const Editor& editor : std::as_const(editors_))
        connect(editor.dock->toggleViewAction(), &QAction::triggered, this,
                [this, editor](bool shown) { giveItsPart(editor, shown); });
    connect(toggleAccuracy(), &QAction::triggered, this, &WindowDocks::giveAccuracyItsPart);
    connect(effects_, &QDockWidget::visibilityChanged, this, &WindowDocks::effectsShown);
}

QList<QAction*> WindowDocks::toggles() const {
    QList<QAction*> actions;
    for (const QDockWidget* dock : {series_, look_, tissue_, light_, rendering_, accuracy_, effects_})
        actions << dock->toggleViewAction();
    return actions;
}

void WindowDocks::setAway(bool away) {
    if (!away) {
        window_.restoreState(stateBefore_);
        return;
    }
    stateBefore_ = window_.saveState();
    for (QDockWidget* dock : {series_, look_, tissue_, light_, rendering_, accuracy_, effects_})
        dock->hide();
}

QDockWidget* WindowDocks::add(const QString& title, QWidget* panel, Qt::DockWidgetArea area, const QKeySequence& key) {
    auto* dock = new QDockWidget(title, &window_);
    dock->setObjectName(title);  // by which the window's state is kept
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    dock->setWidget(panel);
    dock->toggleViewAction()->setShortcut(key);
    dock->setTitleBarWidget(panelTitle(title, dock));
    window_.addDockWidget(area, dock);
    return dock;
}

/// Side by side both are legible in wide windows only.
void WindowDocks::makeRoomBeside(QDockWidget* opened, QDockWidget* other) {
    constexpr int kWideEnough = 1700;
    connect(opened->toggleViewAction(), &QAction::triggered, this, [this, other](bool shown) {
        if (shown && window_.width() < kWideEnough)
            other->hide();
    });
}

/// The right-hand column; what is chosen once gives way where less than this fraction of the window is left for the
/// picture, and the other editors always do.
void WindowDocks::giveItsPart(const Editor& editor, bool shown) {
    constexpr int kColumn = 316;
    constexpr double kPicture = 0.6;
    if (!shown) {
        for (QDockWidget* dock : std::exchange(gaveWay_, {}))
            dock->show();
        return;
    }
    for (const Editor& other : std::as_const(editors_))
        if (other.dock != editor.dock)
            other.dock->hide();
    const int left = series_->isVisible() ? series_->width() : 0;
    QList<QDockWidget*> inTheWay{rendering_};
    if (double(window_.width() - left - kColumn) * picture_.height() < kPicture * window_.width() * window_.height())
        inTheWay << series_;
    if (picture_.height() < panels_.look->minimumSizeHint().height() + editor.panel->minimumSizeHint().height())
        inTheWay << look_;
    for (QDockWidget* dock : std::as_const(inTheWay))
        if (dock->isVisible()) {
            dock->hide();
            gaveWay_ << dock;
        }
    window_.resizeDocks({editor.dock}, {kColumn}, Qt::Horizontal);
    window_.resizeDocks({look_, editor.dock}, {1, window_.height()}, Qt::Vertical);
}

/// Of the window's height: the picture keeps most of it.
void WindowDocks::giveAccuracyItsPart(bool shown) {
    constexpr double kPart = 0.22;
    if (shown)
        window_.resizeDocks({accuracy_}, {int(kPart * window_.height())}, Qt::Vertical);
}

}  // namespace pdr::ui
