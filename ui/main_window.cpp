#include "ui/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QShortcut>
#include <QStatusBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <array>
#include <utility>

#include "render/base/version.h"
#include "ui/file_dialogs.h"
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
    fold->setAccessibleName(MainWindow::tr("Fold %1 away").arg(title));
    fold->setToolTip(MainWindow::tr("Fold away (%1)").arg(dock->toggleViewAction()->shortcut().toString()));
    QObject::connect(fold, &QToolButton::clicked, dock->toggleViewAction(), &QAction::trigger);

    auto* bar = new QWidget;
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(10, 4, 6, 2);
    row->addWidget(heading, 1);
    row->addWidget(fold);
    return bar;
}

}  // namespace

MainWindow::MainWindow()
    : viewport_(new Viewport),
      region_(new RegionBox(viewport_)),
      series_(new SeriesPanel),
      look_(new LookPanel),
      tissue_(new TissuePanel),
      rendering_(new RenderPanel),
      effects_(new EffectLedger),
      foot_(new Foot),
      accuracy_(new AccuracyPanel),
      message_(new MessageBar),
      keys_(new KeysOverlay(this)) {
    auto* middle = new QWidget;
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(message_);
    column->addWidget(viewport_, 1);
    setCentralWidget(middle);
    statusBar()->addWidget(foot_, 1);
    statusBar()->setSizeGripEnabled(false);

    seriesDock_ = addPanel(tr("Series"), series_, Qt::LeftDockWidgetArea, Qt::Key_F2);
    lookDock_ = addPanel(tr("Look"), look_, Qt::RightDockWidgetArea, Qt::Key_F3);
    tissueDock_ = addPanel(tr("Tissue"), scrolled(tissue_), Qt::RightDockWidgetArea, Qt::Key_F5);
    tissueDock_->hide();
    connect(tissueDock_->toggleViewAction(), &QAction::triggered, this, &MainWindow::giveTissueItsPart);
    connect(tissue_, &TissuePanel::pickingChosen, this, &MainWindow::setPicking);
    connect(viewport_, &Viewport::tissuePicked, this, [this] { setPicking(false); });
    renderDock_ = addPanel(tr("Rendering"), scrolled(rendering_), Qt::RightDockWidgetArea, Qt::Key_F4);
    accuracyDock_ = addPanel(tr("Accuracy"), accuracy_, Qt::BottomDockWidgetArea, Qt::SHIFT | Qt::Key_E);
    accuracyDock_->hide();
    effectsDock_ = addPanel(tr("What the seconds go to"), effects_, Qt::BottomDockWidgetArea, Qt::Key_F6);
    effectsDock_->hide();
    connect(effectsDock_, &QDockWidget::visibilityChanged, this, &MainWindow::effectsShown);
    makeRoomBeside(accuracyDock_, effectsDock_);
    makeRoomBeside(effectsDock_, accuracyDock_);
    fillFileMenu();
    fillEditMenu();
    fillViewMenu();
    fillHelpMenu();
    for (const QAction* menu : menuBar()->actions())
        addActions(menu->menu()->actions());  // so that keys work while the menu bar is hidden

    connect(viewport_, &Viewport::resetRequested, this, &MainWindow::resetRequested);
    connect(region_, &RegionBox::drawn, this, &MainWindow::chooseRegion);
    connect(region_, &RegionBox::notDrawn, this, [this] { regionFirst_->setChecked(false); });
    connect(look_, &LookPanel::pauseChosen, this, &MainWindow::pauseChosen);
    connect(look_, &LookPanel::tissueWanted, tissueDock_->toggleViewAction(), &QAction::trigger);
    connect(accuracyDock_->toggleViewAction(), &QAction::triggered, this, &MainWindow::giveAccuracyItsPart);
    connect(&foot_->status(), &StatusLine::textClicked, accuracyDock_->toggleViewAction(), &QAction::trigger);
    connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &MainWindow::escape);

    setAcceptDrops(true);
    setUndoAvailable(false, false);
    setPictureAvailable(false);
    setSubject({});
    viewport_->setFocus();
}

void MainWindow::setSubject(const QString& subject) {
    const QString program = tr("PD-Render - Not for diagnostic use");
    setWindowTitle(subject.isEmpty() ? program : subject + " - " + program);
}

void MainWindow::setLastFolder(const QString& folder) {
    lastFolder_ = folder;
}

void MainWindow::setUndoAvailable(bool undo, bool redo) {
    undo_->setEnabled(undo);
    redo_->setEnabled(redo);
}

void MainWindow::setPaused(bool paused) {
    pause_->setChecked(paused);
    look_->setPaused(paused);
}

void MainWindow::setSmoothed(bool smoothed) {
    smoothed_->setChecked(smoothed);
}

void MainWindow::setRegion(const std::optional<QRectF>& box) {
    regionFirst_->setChecked(box.has_value());
    region_->setBox(box);
}

void MainWindow::setTable(bool shown, bool there) {
    table_->setChecked(shown);
    table_->setEnabled(there);
}

void MainWindow::setCaptioned(bool captioned) {
    captioned_->setChecked(captioned);
}

void MainWindow::setQuestionOnClosing(const QString& question) {
    questionOnClosing_ = question;
}

void MainWindow::setPictureAvailable(bool available) {
    save_->setEnabled(available);
    copy_->setEnabled(available);
}

QDockWidget* MainWindow::addPanel(const QString& title, QWidget* panel, Qt::DockWidgetArea area,
                                  const QKeySequence& key) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(title);  // by which the window's state is kept
    dock->setFeatures(QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable);
    dock->setWidget(panel);
    dock->toggleViewAction()->setShortcut(key);
    dock->setTitleBarWidget(panelTitle(title, dock));
    addDockWidget(area, dock);
    return dock;
}

/// Side by side both are legible in wide windows only.
void MainWindow::makeRoomBeside(QDockWidget* opened, QDockWidget* other) {
    constexpr int kWideEnough = 1700;
    connect(opened->toggleViewAction(), &QAction::triggered, this, [this, other](bool shown) {
        if (shown && width() < kWideEnough)
            other->hide();
    });
}

/// The right-hand column; what is chosen once gives way where less than this fraction of the window is left for the
/// picture.
void MainWindow::giveTissueItsPart(bool shown) {
    constexpr int kColumn = 316;
    constexpr double kPicture = 0.6;
    if (!shown) {
        for (QDockWidget* dock : std::exchange(gaveWay_, {}))
            dock->show();
        return;
    }
    const int left = seriesDock_->isVisible() ? seriesDock_->width() : 0;
    QList<QDockWidget*> inTheWay{renderDock_};
    if (double(width() - left - kColumn) * viewport_->height() < kPicture * width() * height())
        inTheWay << seriesDock_;
    if (viewport_->height() < look_->minimumSizeHint().height() + tissue_->minimumSizeHint().height())
        inTheWay << lookDock_;
    for (QDockWidget* dock : std::as_const(inTheWay))
        if (dock->isVisible()) {
            dock->hide();
            gaveWay_ << dock;
        }
    resizeDocks({tissueDock_}, {kColumn}, Qt::Horizontal);
    resizeDocks({lookDock_, tissueDock_}, {1, height()}, Qt::Vertical);
}

/// Whether the next click on the picture picks a tissue.
void MainWindow::setPicking(bool picking) {
    viewport_->setPicking(picking);
    tissue_->setPicking(picking);
}

void MainWindow::fillFileMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&File"));
    connect(menu->addAction(tr("&Open folder..."), QKeySequence::Open), &QAction::triggered, this,
            &MainWindow::chooseFolder);
    save_ = menu->addAction(tr("&Save picture..."), QKeySequence::Save);
    connect(save_, &QAction::triggered, this, &MainWindow::chooseFile);
    menu->addSeparator();
    connect(menu->addAction(tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q)), &QAction::triggered, this,
            &QWidget::close);
}

void MainWindow::fillEditMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Edit"));
    undo_ = menu->addAction(tr("&Undo"), QKeySequence::Undo);
    redo_ = menu->addAction(tr("&Redo"), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
    connect(undo_, &QAction::triggered, this, &MainWindow::undoRequested);
    connect(redo_, &QAction::triggered, this, &MainWindow::redoRequested);
    menu->addSeparator();
    copy_ = menu->addAction(tr("&Copy picture"), QKeySequence::Copy);
    connect(copy_, &QAction::triggered, this, &MainWindow::copyRequested);
}

void MainWindow::fillViewMenu() {
    const std::array<std::pair<QString, StandardView>, 6> views{{{tr("From the &front (A)"), StandardView::anterior},
                                                                 {tr("From the &back (P)"), StandardView::posterior},
                                                                 {tr("From the &left (L)"), StandardView::left},
                                                                 {tr("From the &right (R)"), StandardView::right},
                                                                 {tr("From the &head (H)"), StandardView::superior},
                                                                 {tr("From the f&eet (F)"), StandardView::inferior}}};
    QMenu* menu = menuBar()->addMenu(tr("&View"));
    int key = Qt::Key_1;
    for (const auto& [name, view] : views) {
        QAction* action = menu->addAction(name, QKeySequence(Qt::Key(key++)));
        connect(action, &QAction::triggered, this, [this, view = view] { emit viewChosen(view); });
    }
    connect(menu->addAction(tr("F&irst view"), QKeySequence(Qt::Key_R)), &QAction::triggered, this,
            &MainWindow::resetRequested);
    menu->addSeparator();
    pause_ = menu->addAction(tr("&Pause"));
    pause_->setCheckable(true);
    pause_->setShortcut(Qt::Key_Space);
    pause_->setShortcutContext(Qt::WidgetShortcut);  // elsewhere Space presses the button that has the focus
    viewport_->addAction(pause_);
    connect(pause_, &QAction::triggered, this, &MainWindow::pauseChosen);
    smoothed_ = menu->addAction(tr("&Smoothed"), QKeySequence(Qt::Key_S));
    smoothed_->setCheckable(true);
    connect(smoothed_, &QAction::triggered, this, &MainWindow::smoothingChosen);
    table_ = menu->addAction(tr("&Table and holder"), QKeySequence(Qt::Key_T));
    table_->setCheckable(true);
    connect(table_, &QAction::triggered, this, &MainWindow::tableChosen);
    captioned_ = menu->addAction(tr("&Caption on previews"));
    captioned_->setCheckable(true);
    captioned_->setToolTip(
        tr("Saved, copied and full-screen pictures say where they are not yet as good as was wanted"));
    connect(captioned_, &QAction::triggered, this, &MainWindow::captionChosen);
    QAction* errorMap = menu->addAction(tr("Where it is still r&ough"), QKeySequence(Qt::Key_E));
    errorMap->setCheckable(true);
    connect(errorMap, &QAction::triggered, this, &MainWindow::errorMapChosen);
    regionFirst_ = menu->addAction(tr("&Box first"), QKeySequence(Qt::Key_B));
    regionFirst_->setCheckable(true);
    regionFirst_->setToolTip(tr("Draw a box on the picture: it gets all samples until it is as good as wanted"));
    connect(regionFirst_, &QAction::triggered, this, &MainWindow::drawOrForgetRegion);
    menu->addSeparator();
    menu->addAction(seriesDock_->toggleViewAction());
    menu->addAction(lookDock_->toggleViewAction());
    menu->addAction(tissueDock_->toggleViewAction());
    menu->addAction(renderDock_->toggleViewAction());
    menu->addAction(accuracyDock_->toggleViewAction());
    menu->addAction(effectsDock_->toggleViewAction());
    alone_ = menu->addAction(tr("Picture &alone"), QKeySequence(Qt::Key_F11));
    alone_->setCheckable(true);
    connect(alone_, &QAction::toggled, this, &MainWindow::showPictureAlone);
}

void MainWindow::fillHelpMenu() {
    QMenu* menu = menuBar()->addMenu(tr("&Help"));
    QAction* keys = menu->addAction(tr("&Keys"));
    keys->setShortcuts({QKeySequence(Qt::Key_H), QKeySequence(Qt::Key_Question)});
    connect(keys, &QAction::triggered, keys_, &KeysOverlay::toggle);
    connect(menu->addAction(tr("&About PD-Render")), &QAction::triggered, this, &MainWindow::about);
}

void MainWindow::chooseFolder() {
    const QString folder = askForFolder(this, lastFolder_);
    if (!folder.isEmpty())
        emit folderChosen(folder);
}

void MainWindow::chooseFile() {
    const auto order = askForPicture(this, *save_, viewport_->sizeInPixels(), accuracy_->stop().rule());
    if (!order)
        return;
    if (order->size)
        emit pictureOrdered(*order);
    else
        emit saveRequested(order->file);
}

void MainWindow::showPictureAlone(bool alone) {
    if (alone)
        stateBeforeAlone_ = saveState();
    menuBar()->setVisible(!alone);
    statusBar()->setVisible(!alone);
    seriesDock_->setVisible(!alone);
    lookDock_->setVisible(!alone);
    renderDock_->setVisible(!alone);
    viewport_->setCaptionShown(alone);
    accuracyDock_->setVisible(!alone);
    if (alone) {
        effectsDock_->hide();
        tissueDock_->hide();
    }
    setWindowState(alone ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
    if (!alone)
        restoreState(stateBeforeAlone_);
}

/// Of the window's height: the picture keeps most of it.
void MainWindow::giveAccuracyItsPart(bool shown) {
    constexpr double kPart = 0.22;
    if (shown)
        resizeDocks({accuracyDock_}, {int(kPart * height())}, Qt::Vertical);
}

void MainWindow::chooseRegion(const std::optional<QRectF>& box) {
    setRegion(box);
    emit regionChosen(box);
}

/// A box that is there is forgotten; else the next drag draws one.
void MainWindow::drawOrForgetRegion(bool draw) {
    region_->stopDrawing();
    if (draw)
        region_->startDrawing();
    else
        chooseRegion(std::nullopt);
}

void MainWindow::escape() {
    if (region_->isDrawing()) {
        region_->stopDrawing();
        return regionFirst_->setChecked(false);
    }
    setPicking(false);
    alone_->setChecked(false);
    message_->clear();
    emit cancelRequested();
}

void MainWindow::about() {
    QMessageBox::about(this, tr("About PD-Render"),
                       tr("<h3>PD-Render %1</h3><p>Photorealistic pictures of CT volumes, with a measure of how right "
                          "they are.</p><p><b>Not for diagnostic use.</b> PD-Render is not a certified medical "
                          "device.</p><p>Apache License 2.0. Made with Qt, DCMTK, OpenEXR and oneTBB.</p>")
                           .arg(PDR_VERSION));
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::WindowStateChange)
        emit unseenChanged(isMinimized());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const bool closes = questionOnClosing_.isEmpty() ||
                        QMessageBox::question(this, tr("PD-Render"), questionOnClosing_) == QMessageBox::Yes;
    event->setAccepted(closes);
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    emit unseenChanged(isMinimized());
}

void MainWindow::hideEvent(QHideEvent* event) {
    QMainWindow::hideEvent(event);
    emit unseenChanged(true);
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (!urls.isEmpty() && urls.first().isLocalFile())
        event->acceptProposedAction();
}

/// A file stands for the folder that it lies in.
void MainWindow::dropEvent(QDropEvent* event) {
    const QFileInfo dropped(event->mimeData()->urls().value(0).toLocalFile());
    event->acceptProposedAction();
    emit folderChosen(dropped.isFile() ? dropped.absolutePath() : dropped.absoluteFilePath());
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    keys_->setGeometry(rect());
}

}  // namespace pdr::ui
