#include "ui/window/main_window.h"

#include <QApplication>
#include <QGridLayout>
#include <QMenuBar>
#include <QMessageBox>
#include <QShortcut>
#include <QStatusBar>
#include <QVBoxLayout>
#include <algorithm>

#include "render/base/version.h"
#include "ui/keys/keys_dialog.h"
#include "ui/widgets/file_dialogs.h"
#include "ui/widgets/wheel_guard.h"
#include "ui/window/program_icon.h"

namespace pdr::ui {
namespace {

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
      views_(new ViewGrid(viewport_)),
      tools_{&viewport_->tools()},
      accuracyStatus_(new AccuracyStatus),
      message_(new MessageBar(viewport_)),
      start_(new StartPanel),
      keys_(new KeysOverlay(this)),
      docks_(new WindowDocks(*this, *views_)),
      actions_(fillMenus(*menuBar())) {
    // Lay out the view and the status bar
    auto* inPlaceOfTheImage = new QGridLayout(viewport_);
    inPlaceOfTheImage->addWidget(start_, 0, 0, Qt::AlignCenter);
    start_->hide();
    viewport_->setOverlay([this] { return linesOverImage(); });
    setCentralWidget(views_);
    statusBar()->addWidget(accuracyStatus_, 1);
    statusBar()->setSizeGripEnabled(false);

    // Connect menus, keys and the view
    for (const QAction* menu : menuBar()->actions())
        addActions(menu->menu()->actions());  // so that keys work while the menu bar is hidden
    viewport_->addAction(actions_.pause);     // its key counts there only
    for (QAction* toggle : {docks_->toolBar().toggleViewAction(), docks_->sideBarToggle()}) {
        actions_.view->insertAction(actions_.endOfPanels, toggle);
        addAction(toggle);
    }
    connectActions();
    connectView();
    connect(new QShortcut(Qt::Key_Escape, this), &QShortcut::activated, this, &MainWindow::escape);

    // Set the state of a window in which nothing is open
    guardWheels(*this);
    setWindowIcon(programIcon());
    setAcceptDrops(true);
    for (QAction* action : {actions_.undo, actions_.redo, actions_.save, actions_.copy})
        action->setEnabled(false);
    setSubject({});
    viewport_->setFocus();
}

void MainWindow::connectActions() {
    connect(actions_.open, &QAction::triggered, this, &MainWindow::chooseFolder);
    connect(actions_.openFile, &QAction::triggered, this, &MainWindow::chooseFile);
    connect(start_, &StartPanel::openRequested, actions_.open, &QAction::trigger);
    connect(start_, &StartPanel::folderChosen, this, &MainWindow::folderChosen);
    connect(actions_.recent, &RecentMenu::folderChosen, this, &MainWindow::folderChosen);
    connect(actions_.quit, &QAction::triggered, this, &QWidget::close);
    connect(actions_.alone, &QAction::toggled, this, &MainWindow::showImageAlone);
    connect(actions_.hideName, &QAction::toggled, this, &MainWindow::hideNames);
    connect(actions_.languages, &QActionGroup::triggered, this,
            [this](const QAction* language) { emit languageChosen(language->data().toString()); });
    for (std::size_t i = 0; i < actions_.themes.size(); ++i)
        connect(actions_.themes[i], &QAction::triggered, this, [this, i] { emit themeChosen(ThemeChoice(i)); });
    connect(actions_.keys, &QAction::triggered, keys_, [this] { keys_->toggle(bindings().actions()); });
    connect(actions_.editKeys, &QAction::triggered, this, &MainWindow::editKeys);
    connect(actions_.about, &QAction::triggered, this, &MainWindow::about);
}

void MainWindow::connectView() {
    connect(viewport_, &Viewport::resetRequested, actions_.firstView, &QAction::trigger);
    connect(viewport_, &Viewport::menuRequested, this, &MainWindow::showMenu);
}

QAction* MainWindow::addPanel(QWidget* panel, const PanelInfo& info) {
    QAction* toggle = docks_->add(panel, info);
    actions_.view->insertAction(actions_.endOfPanels, toggle);
    addAction(toggle);
    guardWheels(*panel);
    return toggle;
}

void MainWindow::addSlice(QWidget* view, ViewTools& tools) {
    views_->addSlice(view);
    tools_.push_back(&tools);
}

void MainWindow::addMenu(const QString& title, const std::function<void(QMenu&)>& fill) {
    auto* menu = new QMenu(title, menuBar());
    menuBar()->insertMenu(menuBar()->actions().last(), menu);
    fill(*menu);
    addActions(menu->actions());
    menu->setToolTipsVisible(true);
}

void MainWindow::fillToolBar() {
    docks_->toolBar().fill(namedActions(*menuBar()));
}

/// Returns the keys of all actions. Their defaults are those that they have when this is first called, at the latest
/// when the user's keys are restored.
KeyBindings& MainWindow::bindings() {
    if (!bindings_)
        bindings_.emplace(namedActions(*menuBar()));
    return *bindings_;
}

void MainWindow::setSubject(const QString& subject, const QString& whileHidden) {
    subject_ = subject;
    subjectWhileHidden_ = whileHidden;
    const QString program = tr("PD-Render - Not for diagnostic use");
    const QString shown = actions_.hideName->isChecked() ? whileHidden : subject;
    setWindowTitle(shown.isEmpty() ? program : shown + " - " + program);
}

void MainWindow::setPatient(const QStringList& lines, const QStringList& whileHidden) {
    patient_ = lines;
    patientWhileHidden_ = whileHidden;
    viewport_->update();
}

void MainWindow::setLastFolder(const QString& folder) {
    lastFolder_ = QFileInfo(folder).isFile() ? QFileInfo(folder).absolutePath() : folder;
}

void MainWindow::setRecentFolders(const QStringList& folders, bool remembered) {
    actions_.recent->setFolders(folders, remembered);
    start_->setRecent(folders);
}

void MainWindow::setKeys(const QMap<QString, QString>& choices) {
    bindings().restore(choices);
}

void MainWindow::editKeys() {
    KeysDialog dialog(bindings(), this);
    connect(&dialog, &KeysDialog::keysChanged, this, [this] { emit keysChosen(bindings().choices()); });
    dialog.exec();
}

void MainWindow::setLanguage(const QString& code) {
    for (QAction* language : actions_.languages->actions())
        language->setChecked(language->data().toString() == code);
}

void MainWindow::setTheme(ThemeChoice choice) {
    actions_.themes[std::size_t(choice)]->setChecked(true);
}

void MainWindow::setQuestionOnClosing(const QString& question) {
    questionOnClosing_ = question;
}

/// Opens the context menu: the most frequent actions, and those that have no button while the image fills the screen.
void MainWindow::showMenu(QPoint place) {
    auto* menu = new QMenu(this);
    menu->setObjectName("imageMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addActions({actions_.firstView, actions_.fit, actions_.pause});
    menu->addSeparator();
    menu->addActions({actions_.denoised, actions_.errorMap, actions_.boxFirst});
    menu->addSeparator();
    menu->addActions({actions_.undo, actions_.redo, actions_.copy, actions_.save});
    menu->addSeparator();
    menu->addActions({actions_.hideName, actions_.alone, actions_.keys});
    if (const auto fractions = viewport_->fractionsAt(place))
        emit imageMenuOpens(menu, *fractions);
    menu->popup(viewport_->mapToGlobal(place));
}

void MainWindow::chooseFolder() {
    const QString folder = askForFolder(this, lastFolder_);
    if (!folder.isEmpty())
        emit folderChosen(folder);
}

void MainWindow::chooseFile() {
    const QString file = askForScan(this, lastFolder_);
    if (!file.isEmpty())
        emit folderChosen(folderOf(QFileInfo(file)));
}

void MainWindow::showImageAlone(bool alone) {
    if (alone)
        docks_->setAway(true);
    menuBar()->setVisible(!alone);
    statusBar()->setVisible(!alone);
    viewport_->setCaptionShown(alone);
    setWindowState(alone ? windowState() | Qt::WindowFullScreen : windowState() & ~Qt::WindowFullScreen);
    if (!alone)
        docks_->setAway(false);
}

void MainWindow::hideNames(bool hidden) {
    setSubject(subject_, subjectWhileHidden_);
    actions_.recent->menuAction()->setVisible(!hidden);
    start_->setVisible(start_->isVisible() && !hidden);
    viewport_->update();
    emit namesHiddenChanged(hidden);
}

/// Returns the lines in the image's corner: the patient, and in full screen also the accuracy, since the status bar is
/// hidden there.
QStringList MainWindow::linesOverImage() const {
    QStringList lines = patient();
    if (actions_.alone->isChecked())
        lines << accuracyStatus_->status().text();
    return lines;
}

void MainWindow::escape() {
    if (keys_->isVisible())
        return keys_->hide();
    if (std::ranges::any_of(tools_, [](ViewTools* tools) { return tools->cancel(); }))
        return;
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
