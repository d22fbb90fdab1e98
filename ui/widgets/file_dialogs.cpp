#include "ui/widgets/file_dialogs.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QGridLayout>
#include <QSettings>
#include <QStandardPaths>
#include <QUrl>
#include <QVariant>
#include <array>

#include "ui/output/picture_size_box.h"

namespace pdr::ui {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("fileDialogs", text);
}

/// What Qt's dialogs have written about places, by this program or another; written again when it dies.
class KeptPlaces {
  public:
    KeptPlaces() {
        for (std::size_t i = 0; i < kKeys.size(); ++i)
            values_[i] = settings_.value(kKeys[i]);
    }
    ~KeptPlaces() {
        for (std::size_t i = 0; i < kKeys.size(); ++i)
            values_[i].isValid() ? settings_.setValue(kKeys[i], values_[i]) : settings_.remove(kKeys[i]);
    }

  protected:
    static constexpr std::array kKeys{"FileDialog/history", "FileDialog/lastVisited", "FileDialog/shortcuts"};
    std::array<QVariant, kKeys.size()> values_;
    QSettings settings_{QSettings::UserScope, "QtProject"};
};

/// Qt's own dialog, since what a desktop's keeps is out of our hands. It writes its settings when it dies: by then it
/// has nothing to tell, and what was there before comes back after it.
class ForgetfulDialog : KeptPlaces, public QFileDialog {
  public:
    ForgetfulDialog(QWidget* parent, const QString& title) : QFileDialog(parent, title) {
        setOption(QFileDialog::DontUseNativeDialog);
    }
    ~ForgetfulDialog() override {
        setDirectory(QDir::rootPath());
        setHistory({});
        setSidebarUrls({});
    }
};

QString askForFolderOf(QWidget* parent, const QString& title, const QString& start) {
    ForgetfulDialog dialog(parent, title);
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
    if (!start.isEmpty())
        dialog.setDirectory(start);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString askForFile(QWidget* parent, const QString& title, const QString& filter) {
    ForgetfulDialog dialog(parent, title);
    dialog.setFileMode(QFileDialog::ExistingFile);
    dialog.setNameFilter(filter);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

/// Where people look for what they have saved.
QString documents() {
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
    return QDir(folder).exists() ? folder : QDir::homePath();
}

/// Below the files: the layout of Qt's own dialog is a grid.
void addBelow(QFileDialog& dialog, QWidget* widget) {
    if (auto* grid = qobject_cast<QGridLayout*>(dialog.layout()))
        grid->addWidget(widget, grid->rowCount(), 0, 1, -1);
}

}  // namespace

QString askForFolder(QWidget* parent, const QString& start) {
    return askForFolderOf(parent, translated("Open a folder with a CT"), start);
}

QString askForCertificates(QWidget* parent, const QString& start) {
    return askForFolderOf(parent, translated("The folder of this machine's certificates"), start);
}

QString askForLook(QWidget* parent) {
    return askForFile(parent, translated("Import a look"), translated("Looks, also of 3D Slicer (*.json *.vp)"));
}

QString askForSky(QWidget* parent) {
    return askForFile(parent, translated("Light by a picture of a sky or a room"),
                      translated("Panorama, twice as wide as high (*.exr)"));
}

QString askWhereToShare(QWidget* parent, const QString& name) {
    const QString ours = translated("Look (*.json)");
    const QString slicer = translated("3D Slicer, curves only (*.vp.json)");
    const QString old = translated("3D Slicer before 5.9, curves only (*.vp)");
    ForgetfulDialog dialog(parent, translated("Export the look"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters({ours, slicer, old});
    dialog.setDefaultSuffix("json");
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, [&](const QString& filter) {
        dialog.setDefaultSuffix(filter == ours ? "json" : filter == slicer ? "vp.json" : "vp");
    });
    dialog.selectFile(QString(name).replace('/', '-'));
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

std::optional<PictureOrder> askForPicture(QWidget* parent, const QAction& save, const PictureOffer& offer) {
    const QString png = translated("PNG picture (*.png)");
    const QString exr = translated("OpenEXR with the error of every pixel (*.exr)");
    ForgetfulDialog dialog(parent, translated("Save the picture"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters({png, exr});
    dialog.setDirectory(offer.folder.isEmpty() ? documents() : offer.folder);
    // With a suffix from the dialog itself it also asks before it overwrites.
    dialog.setDefaultSuffix("png");
    auto* box = new PictureSizeBox(offer);
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
    return PictureOrder{dialog.selectedFiles().value(0), box->chosenSize(), box->stop(), box->annotate()};
}

}  // namespace pdr::ui
