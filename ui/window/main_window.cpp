#include "ui/window/main_window.h"

#include <QApplication>
#include <QFileInfo>
#include <QGridLayout>
#include <QMenuBar>
#include <QMessageBox>
#include <QShortcut>
#include <QStatusBar>
#include <QVBoxLayout>

#include "render/base/version.h"
#include "ui/keys/keys_dialog.h"
#include "ui/output/save_dialog.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/wheel_guard.h"
#include "ui/window/program_icon.h"

namespace pdr::ui {
namespace {

/// Returns a widget with one panel above another; the upper one takes the extra height.
QWidget* stacked(QWidget* above, QWidget* below) {
    auto* both = new QWidget;
    auto* column = new QVBoxLayout(both);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(above, 1);
    column->addWidget(below);
    return both;
}

QList<QAction*> namedActions(const QMenuBar& bar) {
    QList<QAction*> named;
    for (const QAction* menu : bar.actions())
        for (QAction* action : menu->menu()->actions())
            if (!action->objectName().isEmpty())
                named << action;
    return named;
}

}  // namespace

MainWindow::MainWindow()
    : viewport_(new Viewport),
      region_(new RegionBox(viewport_)),
      cut_(new CutTools(viewport_)),
      series_(new SeriesPanel),
      look_(new LookPanel),
      visible_(new VisibleRow),
      tissue_(new TissuePanel),
      light_(new LightPanel),
      camera_(new CameraPanel),
      rendering_(new RenderPanel),
      effects_(new EffectLedger),
      nodes_(new NodesPanel),
      foot_(new Foot),
      accuracy_(new AccuracyPanel),
      message_(new MessageBar(viewport_)),
      start_(new StartPanel),
      keys_(new KeysOverlay(this)),
      docks_(new WindowDocks(*this, *viewport_,
                             {series_, stacked(look_, visible_), tissue_, light_, camera_, &cut_->panel(), rendering_,
                              accuracy_, effects_, nodes_})),
      actions_(fillMenus(*menuBar(), docks_->toggles(), *cut_)),
      bindings_(namedActions(*menuBar())) {
    // Lay out the view and the status bar
    auto* inPlaceOfThePicture = new QGridLayout(viewport_);
    inPlaceOfThePicture->addWidget(start_, 0, 0, Qt::AlignCenter);
    start_->hide();
    viewport_->setOverlay([this] { return whatIsSeen(); });
    setCentralWidget(viewport_);
    statusBar()->addWidget(foot_, 1);
    statusBar()->setSizeGripEnabled(false);

    // Connect menus and keys
    for (const QAction* menu : menuBar()->actions())
        addActions(menu->menu()->actions());  // so that keys work while the menu bar is hidden
    connectFileActions();
    connectEditActions();
    connectViewActions();
    connect(actions_.keys, &QAction::triggered, keys_, [this] { keys_->toggle(bindings_.actions()); });
    connect(actions_.editKeys, &QAction::triggered, this, &MainWindow::editKeys);
    connect(actions_.about, &QAction::triggered, this, &MainWindow::about);
    connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &MainWindow::escape);

    // Connect the panels and the view
    connect(docks_, &WindowDocks::cutShown, cut_, &CutTools::showHandles);
    connect(docks_, &WindowDocks::effectsShown, this, &MainWindow::effectsShown);
    connect(viewport_, &Viewport::resetRequested, this, &MainWindow::resetRequested);
    connect(viewport_, &Viewport::menuRequested, this, &MainWindow::showMenu);
    connect(viewport_, &Viewport::tissuePicked, this, [this] { setPicking(Viewport::Picking::nothing); });
    connect(viewport_, &Viewport::focusPicked, this, [this] { setPicking(Viewport::Picking::nothing); });
    connect(tissue_, &TissuePanel::pickingChosen, this,
            [this](bool picking) { setPicking(picking ? Viewport::Picking::tissue : Viewport::Picking::nothing); });
    connect(camera_, &CameraPanel::pickingChosen, this,
            [this](bool picking) { setPicking(picking ? Viewport::Picking::focus : Viewport::Picking::nothing); });
    connect(camera_, &CameraPanel::viewChosen, this, &MainWindow::viewChosen);
    connect(region_, &RegionBox::drawn, this, &MainWindow::chooseRegion);
    connect(region_, &RegionBox::notDrawn, actions_.boxFirst, [this] { actions_.boxFirst->setChecked(false); });
    connect(look_, &LookPanel::pauseChosen, this, &MainWindow::pauseChosen);
    connect(look_, &LookPanel::tissueWanted, docks_->toggleTissue(), &QAction::trigger);
    connect(look_, &LookPanel::lightWanted, docks_->toggleLight(), &QAction::trigger);
    connect(look_, &LookPanel::cameraWanted, docks_->toggleCamera(), &QAction::trigger);
    connect(&foot_->status(), &StatusLine::textClicked, docks_->toggleAccuracy(), &QAction::trigger);

    // Set the state of a window in which nothing is open
    guardWheels(*this);
    setWindowIcon(programIcon());
    setAcceptDrops(true);
    setUndoAvailable(false, false);
    setPictureAvailable(false);
    setSubject({});
    viewport_->setFocus();
}

void MainWindow::connectFileActions() {
    connect(actions_.open, &QAction::triggered, this, &MainWindow::chooseFolder);
    connect(start_, &StartPanel::openRequested, actions_.open, &QAction::trigger);
    connect(start_, &StartPanel::folderChosen, this, &MainWindow::folderChosen);
    connect(actions_.recent, &RecentMenu::folderChosen, this, &MainWindow::folderChosen);
    connect(actions_.recent, &RecentMenu::rememberChosen, this, &MainWindow::rememberFoldersChosen);
    connect(actions_.recent, &RecentMenu::forgetRequested, this, &MainWindow::forgetFoldersRequested);
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
    connect(actions_.fit, &QAction::triggered, this, &MainWindow::fitRequested);
    connect(actions_.pause, &QAction::triggered, this, &MainWindow::pauseChosen);
    connect(actions_.smoothed, &QAction::triggered, this, &MainWindow::smoothingChosen);
    connect(actions_.table, &QAction::triggered, this, &MainWindow::tableChosen);
    connect(actions_.captioned, &QAction::triggered, this, &MainWindow::captionChosen);
    connect(actions_.errorMap, &QAction::triggered, this, &MainWindow::errorMapChosen);
    connect(actions_.boxFirst, &QAction::triggered, this, &MainWindow::drawOrForgetRegion);
    connect(actions_.alone, &QAction::toggled, this, &MainWindow::showPictureAlone);
    connect(actions_.hideName, &QAction::toggled, this, &MainWindow::hideName);
    connect(actions_.languages, &QActionGroup::triggered, this,
            [this](const QAction* language) { emit languageChosen(language->data().toString()); });
    for (std::size_t i = 0; i < actions_.themes.size(); ++i)
        connect(actions_.themes[i], &QAction::triggered, this, [this, i] { emit themeChosen(ThemeChoice(i)); });
}

void MainWindow::setSubject(const QString& subject, const QString& whileHidden) {
    subject_ = subject;
    subjectWhileHidden_ = whileHidden;
    const QString program = tr("PD-Render - Not for diagnostic use");
    const QString shown = actions_.hideName->isChecked() ? whileHidden : subject;
    setWindowTitle(shown.isEmpty() ? program : shown + " - " + program);
}

void MainWindow::setPatient(const QStringList& lines) {
    patient_ = lines;
    viewport_->update();
}

QStringList MainWindow::patient() const {
    return actions_.hideName->isChecked() && !patient_.isEmpty() ? QStringList(series_->patient()) : patient_;
}

void MainWindow::setLastFolder(const QString& folder) {
    lastFolder_ = folder;
}

void MainWindow::setUndoAvailable(bool undo, bool redo) {
    actions_.undo->setEnabled(undo);
    actions_.redo->setEnabled(redo);
}

void MainWindow::setUndoTexts(const QString& undo, const QString& redo) {
    actions_.undo->setText('&' + undo);
    actions_.redo->setText('&' + redo);
}

void MainWindow::setRecentFolders(const QStringList& folders, bool remembered) {
    actions_.recent->setFolders(folders, remembered);
    start_->setRecent(folders);
}

void MainWindow::setStartShown(bool shown) {
    start_->setVisible(shown);
}

void MainWindow::setExample(const QString& folder) {
    start_->setExample(folder);
}

void MainWindow::setVolumeAvailable(bool available) {
    for (QAction* view : actions_.views)
        view->setEnabled(available);
    for (QAction* action :
         {actions_.firstView, actions_.fit, actions_.pause, actions_.smoothed, actions_.errorMap, actions_.boxFirst})
        action->setEnabled(available);
    look_->setEnabled(available);
}

void MainWindow::setKeys(const QMap<QString, QString>& choices) {
    bindings_.restore(choices);
}

void MainWindow::editKeys() {
    KeysDialog dialog(bindings_, this);
    connect(&dialog, &KeysDialog::keysChanged, this, [this] { emit keysChosen(bindings_.choices()); });
    dialog.exec();
}

void MainWindow::setLanguage(const QString& code) {
    for (QAction* language : actions_.languages->actions())
        language->setChecked(language->data().toString() == code);
}

void MainWindow::setTheme(ThemeChoice choice) {
    actions_.themes[std::size_t(choice)]->setChecked(true);
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

void MainWindow::setPictureOffer(const QString& name, const std::optional<PictureCost>& cost) {
    pictureName_ = name;
    pictureCost_ = cost;
}

/// Sets what the next click on the image picks, in the viewport and on the panels' buttons.
void MainWindow::setPicking(Viewport::Picking picking) {
    viewport_->setPicking(picking);
    tissue_->setPicking(picking == Viewport::Picking::tissue);
    camera_->setPicking(picking == Viewport::Picking::focus);
}

/// Opens the context menu: the most frequent actions, and those that have no button while the image fills the screen.
void MainWindow::showMenu(QPoint place) {
    auto* menu = new QMenu(this);
    menu->setObjectName("pictureMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions({actions_.firstView, actions_.fit, actions_.pause});
    menu->addSeparator();
    menu->addActions({actions_.smoothed, actions_.errorMap, actions_.boxFirst});
    menu->addSeparator();
    menu->addActions({actions_.undo, actions_.redo, actions_.copy, actions_.save});
    menu->addSeparator();
    menu->addActions({actions_.hideName, actions_.alone, actions_.keys});
    menu->popup(viewport_->mapToGlobal(place));
}

void MainWindow::chooseFolder() {
    const QString folder = askForFolder(this, lastFolder_);
    if (!folder.isEmpty())
        emit folderChosen(folder);
}

void MainWindow::chooseFile() {
    const Annotate usual = actions_.captioned->isChecked() ? Annotate::sides : Annotate::none;
    const bool patientKnown = !patient_.isEmpty() && !actions_.hideName->isChecked();
    const auto order =
        askForPicture(this, *actions_.save,
                      {viewport_->sizeInPixels(), pictureName_, folderOfPictures_, pictureCost_, usual, patientKnown});
    if (!order)
        return;
    folderOfPictures_ = QFileInfo(order->file).absolutePath();
    if (order->size)
        emit pictureOrdered(*order);
    else
        emit saveRequested(order->file, order->annotate);
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

/// Starts to draw a box with the next drag, or removes the box.
void MainWindow::drawOrForgetRegion(bool draw) {
    region_->stopDrawing();
    if (draw)
        region_->startDrawing();
    else
        chooseRegion(std::nullopt);
}

void MainWindow::hideName(bool hidden) {
    series_->setNamesHidden(hidden);
    setSubject(subject_, subjectWhileHidden_);
    actions_.recent->menuAction()->setVisible(!hidden);
    start_->setVisible(start_->isVisible() && !hidden);
    viewport_->update();
}

/// Returns the overlay lines: the patient, and in full screen also the accuracy, since the status bar is hidden there.
QStringList MainWindow::whatIsSeen() const {
    QStringList lines = patient();
    if (actions_.alone->isChecked())
        lines << foot_->status().text();
    return lines;
}

void MainWindow::escape() {
    if (keys_->isVisible())
        return keys_->hide();
    if (cut_->giveUp())
        return;
    if (region_->isDrawing()) {
        region_->stopDrawing();
        return actions_.boxFirst->setChecked(false);
    }
    setPicking(Viewport::Picking::nothing);
    cut_->hideHandles();
    actions_.alone->setChecked(false);
    message_->clear();
    emit cancelRequested();
}

void MainWindow::about() {
    QMessageBox::about(this, tr("About PD-Render"),
                       tr("<h3>PD-Render %1</h3><p>Photorealistic images of CT volumes, with a measure of how right "
                          "they are.</p><p><b>Not for diagnostic use.</b> PD-Render is not a certified medical "
                          "device.</p><p>Apache License 2.0. Made with Qt, DCMTK, OpenEXR and oneTBB.</p>")
                           .arg(PDR_VERSION));
}

}  // namespace pdr::ui
