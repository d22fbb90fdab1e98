/// Events of the main window: shown, hidden, closed, resized, and files dropped on it.

#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QMessageBox>
#include <QMimeData>

#include "render/volume/file/scan_endings.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

QString folderOf(const QFileInfo& path) {
    const bool isScan = !scanEnding(path.fileName().toStdString()).empty();
    return path.isFile() && !isScan ? path.absolutePath() : path.absoluteFilePath();
}

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::WindowStateChange)
        emit unseenChanged(isMinimized());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    const bool closes = questionOnClosing_.isEmpty() ||
                        QMessageBox::question(this, tr("PD-Render"), questionOnClosing_) == QMessageBox::Yes;
    event->setAccepted(closes && confirmsLoss());
}

bool MainWindow::confirmsLoss() {
    return unsaved_.isEmpty() || QMessageBox::question(this, tr("PD-Render"), unsaved_) == QMessageBox::Yes;
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

/// Opens what was dropped. A file stands for the folder that contains it, except one that holds a whole scan, an
/// OpenEXR environment image or a plan. Several files of one folder count once.
void MainWindow::dropEvent(QDropEvent* event) {
    QStringList folders;
    for (const QUrl& url : event->mimeData()->urls())
        folders << folderOf(QFileInfo(url.toLocalFile()));
    folders.removeDuplicates();
    const QFileInfo dropped(event->mimeData()->urls().value(0).toLocalFile());
    event->acceptProposedAction();
    if (dropped.isFile() && dropped.suffix().compare("exr", Qt::CaseInsensitive) == 0)
        emit skyDropped(dropped.absoluteFilePath());
    else if (dropped.isFile() && dropped.suffix().compare("json", Qt::CaseInsensitive) == 0)
        emit planDropped(dropped.absoluteFilePath());
    else
        emit folderChosen(folders.first());
    if (folders.size() > 1)
        emit othersLeftOut();
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    keys_->setGeometry(rect());
    docks_->makeRoom();
}

}  // namespace pdr::ui
