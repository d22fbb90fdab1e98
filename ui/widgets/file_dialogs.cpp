#include "ui/widgets/file_dialogs.h"

#include <QCoreApplication>

#include "render/volume/file/scan_endings.h"
#include "ui/widgets/forgetful_dialog.h"

namespace pdr::ui {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("fileDialogs", text);
}

QString askForFolderOf(QWidget* parent, const QString& title, const QString& start) {
    ForgetfulDialog dialog(parent, title);
    dialog.setFileMode(QFileDialog::Directory);
    dialog.setOption(QFileDialog::ShowDirsOnly);
    if (!start.isEmpty())
        dialog.setDirectory(start);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString askForFile(QWidget* parent, const QString& title, const QString& filter, const QString& start = {}) {
    ForgetfulDialog dialog(parent, title);
    if (!start.isEmpty())
        dialog.setDirectory(start);
    dialog.setFileMode(QFileDialog::ExistingFile);
    dialog.setNameFilter(filter);
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

}  // namespace

QString askForFolder(QWidget* parent, const QString& start) {
    return askForFolderOf(parent, translated("Open a folder with a CT"), start);
}

QString askForScan(QWidget* parent, const QString& start) {
    QStringList patterns;
    for (const char* ending : kScanEndings)
        patterns << QString("*") + ending;
    return askForFile(parent, translated("Open a scan in one file"),
                      translated("Scans in one file (%1)").arg(patterns.join(' ')), start);
}

QString askForLabels(QWidget* parent) {
    return askForFile(
        parent, translated("Open a label map"),
        translated("Label maps (*.nii *.nii.gz *.nrrd *.mha *.mhd *.dcm)") + ";;" + translated("All files (*)"));
}

QString askForMasks(QWidget* parent) {
    return askForFolderOf(parent, translated("Open a folder with a mask of each part"), {});
}

QString askForCertificates(QWidget* parent, const QString& start) {
    return askForFolderOf(parent, translated("The folder of this machine's certificates"), start);
}

QString askForLook(QWidget* parent) {
    return askForFile(parent, translated("Import a look"), translated("Looks, also of 3D Slicer (*.json *.vp)"));
}

QString askForSky(QWidget* parent) {
    return askForFile(parent, translated("Light from an environment image"),
                      translated("Panorama, twice as wide as high (*.exr)"));
}

QString askForPlan(QWidget* parent) {
    return askForFile(parent, translated("Open a plan"), translated("Plans (*.plan.json *.json)"));
}

QString askWhereToSavePlan(QWidget* parent) {
    ForgetfulDialog dialog(parent, translated("Save the plan"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilter(translated("Plans (*.plan.json *.json)"));
    dialog.setDefaultSuffix("plan.json");
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString askWhereToExportMarks(QWidget* parent) {
    const QString table = translated("Table for spreadsheets (*.csv)");
    ForgetfulDialog dialog(parent, translated("Export the measurements"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters({table, translated("Markups of 3D Slicer (*.mrk.json)")});
    dialog.setDefaultSuffix("csv");
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog,
                     [&](const QString& filter) { dialog.setDefaultSuffix(filter == table ? "csv" : "mrk.json"); });
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
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

}  // namespace pdr::ui
