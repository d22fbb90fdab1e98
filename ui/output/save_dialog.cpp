#include "ui/output/save_dialog.h"

#include <QCoreApplication>
#include <QDir>
#include <QGridLayout>
#include <QStandardPaths>

#include "ui/output/image_size_box.h"
#include "ui/widgets/forgetful_dialog.h"

namespace pdr::ui {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("saveDialog", text);
}

/// Returns the documents folder, where users look for saved files, or else the home folder.
QString documents() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(folder).exists() ? folder : QDir::homePath();
}

/// Adds a widget below the list of files. The layout of Qt's own dialog is a grid.
void addBelow(QFileDialog& dialog, QWidget* widget) {
    if (auto* grid = qobject_cast<QGridLayout*>(dialog.layout()))
        grid->addWidget(widget, grid->rowCount(), 0, 1, -1);
}

}  // namespace

std::optional<ImageOrder> askForImage(QWidget* parent, const QAction& save, const ImageOffer& offer) {
    const QString png = translated("PNG image (*.png)");
    const QString exr = translated("OpenEXR with the error of every pixel (*.exr)");
    ForgetfulDialog dialog(parent, translated("Save the image"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters({png, exr});
    dialog.setDirectory(offer.folder.isEmpty() ? documents() : offer.folder);
    // With its own default suffix, the dialog also asks before it overwrites a file.
    dialog.setDefaultSuffix("png");
    auto* box = new ImageSizeBox(offer);
    addBelow(dialog, box);
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
        dialog.setDefaultSuffix(filter == exr ? "exr" : "png");
        box->setAnnotatable(filter != exr);
    });
    QObject::connect(&save, &QAction::enabledChanged, &dialog, [&](bool enabled) {
        if (!enabled)
            dialog.reject();
    });
    dialog.selectFile(offer.name);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return ImageOrder{dialog.selectedFiles().value(0), box->chosenSize(), box->stop(), box->annotate()};
}

}  // namespace pdr::ui
