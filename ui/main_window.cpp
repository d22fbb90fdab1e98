#include "ui/main_window.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QMimeData>
#include <QShortcut>
#include <QStatusBar>
#include <QVBoxLayout>

#include "render/base/version.h"
#include "ui/file_dialogs.h"

namespace pdr::ui {
namespace {

/// One panel above another.
QWidget* stacked(QWidget* above, QWidget* below) {
    auto* both = new QWidget;
    auto* column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(above, 1);
    column->addWidget(below);
    return both;
}

}  // namespace

MainWindow::MainWindow()
    : viewport_(new Viewport),
      region_(new RegionBox(viewport_)),
      series_(new SeriesPanel),
      look_(new LookPanel),
      visible_(new VisibleRow),
      tissue_(new TissuePanel),
      light_(new LightPanel),
      rendering_(new RenderPanel),
      effects_(new EffectLedger),
      foot_(new Foot),
      accuracy_(new AccuracyPanel),
      message_(new MessageBar),
      keys_(new KeysOverlay(this)),
      docks_(new WindowDocks(*this, *viewport_,
                             {series_, stacked(look_, visible_), tissue_, light_, rendering_, accuracy_, effects_})),
      actions_(fillMenus(*menuBar(), docks_->toggles())) {
    auto* middle = new QWidget;
    auto* column = new QVBoxLayout(middle);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(message_);
    column->addWidget(viewport_, 1);
    setCentralWidget(middle);
    statusBar()->addWidget(foot_, 1);
    statusBar()->setSizeGripEnabled(false);

    for (const QAction* menu : menuBar()->actions())
        addActions(menu->menu()->actions());  // so that keys work while the menu bar is hidden
    connectFileActions();
    connectEditActions();
    connectViewActions();
    connect(actions_.keys, &QAction::triggered, keys_, &KeysOverlay::toggle);
    connect(actions_.about, &QAction::triggered, this, &MainWindow::about);
    connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &MainWindow::escape);

    connect(docks_, &WindowDocks::effectsShown, this, &MainWindow::effectsShown);
    connect(viewport_, &Viewport::resetRequested, this, &MainWindow::resetRequested);
    connect(viewport_, &Viewport::tissuePicked, this, [this] { setPicking(false); });
    connect(tissue_, &TissuePanel::pickingChosen, this, &MainWindow::setPicking);
    connect(region_, &RegionBox::drawn, this, &MainWindow::chooseRegion);
    connect(region_, &RegionBox::notDrawn, actions_.boxFirst, [this] { actions_.boxFirst->setChecked(false); });
    connect(look_, &LookPanel::pauseChosen, this, &MainWindow::pauseChosen);
    connect(look_, &LookPanel::tissueWanted, docks_->toggleTissue(), &QAction::trigger);
    connect(look_, &LookPanel::lightWanted, docks_->toggleLight(), &QAction::trigger);
    connect(&foot_->status(), &StatusLine::textClicked, docks_->toggleAccuracy(), &QAction::trigger);

    setAcceptDrops(true);
    setUndoAvailable(false, false);
    setPictureAvailable(false);
    setSubject({});
    viewport_->setFocus();
}

void MainWindow::connectFileActions() {
    connect(actions_.open, &QAction::triggered, this, &MainWindow::chooseFolder);
    connect(actions_.save, &QAction::triggered, this, &MainWindow::chooseFile);
    connect(actions_.quit, &QAction::triggered, this, &QWidget::close);
}

void MainWindow::connectEditActions() {
    connect(actions_.undo, &QAction::triggered, this, &MainWindow::undoRequested);
    connect(actions_.redo, &QAction::triggered, this, &MainWindow::redoRequested);
    connect(actions_.copy, &QAction::triggered, this, &MainWindow::copyRequested);
}

void MainWindow::connectViewActions() {
    for (std::size_t i = 0; i < actions_.views.size(); ++i)
        connect(actions_.views[i], &QAction::triggered, this, [this, i] { emit viewChosen(StandardView(i)); });
    viewport_->addAction(actions_.pause);  // its key counts there only
    connect(actions_.firstView, &QAction::triggered, this, &MainWindow::resetRequested);
    connect(actions_.pause, &QAction::triggered, this, &MainWindow::pauseChosen);
    connect(actions_.smoothed, &QAction::triggered, this, &MainWindow::smoothingChosen);
    connect(actions_.table, &QAction::triggered, this, &MainWindow::tableChosen);
    connect(actions_.captioned, &QAction::triggered, this, &MainWindow::captionChosen);
    connect(actions_.errorMap, &QAction::triggered, this, &MainWindow::errorMapChosen);
    connect(actions_.boxFirst, &QAction::triggered, this, &MainWindow::drawOrForgetRegion);
    connect(actions_.alone, &QAction::toggled, this, &MainWindow::showPictureAlone);
}

void MainWindow::setSubject(const QString& subject) {
    const QString program = tr("PD-Render - Not for diagnostic use");
    setWindowTitle(subject.isEmpty() ? program : subject + " - " + program);
}

void MainWindow::setLastFolder(const QString& folder) {
    lastFolder_ = folder;
}

void MainWindow::setUndoAvailable(bool undo, bool redo) {
    actions_.undo->setEnabled(undo);
    actions_.redo->setEnabled(redo);
}

void MainWindow::setPaused(bool paused) {
    actions_.pause->setChecked(paused);
    look_->setPaused(paused);
}

void MainWindow::setSmoothed(bool smoothed) {
    actions_.smoothed->setChecked(smoothed);
}

void MainWindow::setRegion(const std::optional<QRectF>& box) {
    actions_.boxFirst->setChecked(box.has_value());
    region_->setBox(box);
}

void MainWindow::setTable(bool shown, bool there) {
    actions_.table->setChecked(shown);
    actions_.table->setEnabled(there);
}

void MainWindow::setCaptioned(bool captioned) {
    actions_.captioned->setChecked(captioned);
}

void MainWindow::setQuestionOnClosing(const QString& question) {
    questionOnClosing_ = question;
}

void MainWindow::setPictureAvailable(bool available) {
    actions_.save->setEnabled(available);
    actions_.copy->setEnabled(available);
}

/// Whether the next click on the picture picks a tissue.
void MainWindow::setPicking(bool picking) {
    viewport_->setPicking(picking);
    tissue_->setPicking(picking);
}

void MainWindow::chooseFolder() {
    const QString folder = askForFolder(this, lastFolder_);
    if (!folder.isEmpty())
        emit folderChosen(folder);
}

void MainWindow::chooseFile() {
    const auto order = askForPicture(this, *actions_.save, viewport_->sizeInPixels(), accuracy_->stop().rule());
    if (!order)
        return;
    if (order->size)
        emit pictureOrdered(*order);
    else
        emit saveRequested(order->file);
}

void MainWindow::showPictureAlone(bool alone) {
    if (alone)
        docks_->setAway(true);
    menuBar()->setVisible(!alone);
    statusBar()->setVisible(!alone);
    viewport_->setCaptionShown(alone);
    setWindowState(alone ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
    if (!alone)
        docks_->setAway(false);
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
        return actions_.boxFirst->setChecked(false);
    }
    setPicking(false);
    actions_.alone->setChecked(false);
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
