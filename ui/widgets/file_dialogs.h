#pragma once
/// The dialogs for folders and files. Qt saves the places visited by its dialogs in the user's settings, but a folder's
/// name may be a patient's: these dialogs leave the settings unchanged.

#include <QString>
#include <QWidget>

namespace pdr::ui {

/// Asks for a folder, beginning in `start`. Empty: the user cancelled.
QString askForFolder(QWidget* parent, const QString& start);

/// Asks for a file that holds a whole scan (kScanEndings), beginning in `start`. Empty: the user cancelled.
QString askForScan(QWidget* parent, const QString& start);

/// Asks for a label map: a volume file, or a DICOM segmentation. Empty: the user cancelled.
QString askForLabels(QWidget* parent);

/// Asks for a folder with a mask of each part. Empty: the user cancelled.
QString askForMasks(QWidget* parent);

/// Asks for a folder with certificates, beginning in `start`. Empty: the user cancelled.
QString askForCertificates(QWidget* parent, const QString& start);

/// Asks for a file with a look: the program's own (.json) or 3D Slicer's (.vp.json, .vp). Empty: the user cancelled.
QString askForLook(QWidget* parent);

/// Asks for a file with an environment image (.exr). Empty: the user cancelled.
QString askForSky(QWidget* parent);

/// Asks for a plan (.plan.json). Empty: the user cancelled.
QString askForPlan(QWidget* parent);

/// Asks where to save a plan (.plan.json). No name is proposed, since names are easily those of patients. Empty: the
/// user cancelled.
QString askWhereToSavePlan(QWidget* parent);

/// Asks where to export measurements, for spreadsheets (.csv) or 3D Slicer (.mrk.json). No name is proposed either.
/// Empty: the user cancelled.
QString askWhereToExportMarks(QWidget* parent);

/// Asks where to save a look called `name`, in one of these formats. Empty: the user cancelled.
QString askWhereToShare(QWidget* parent, const QString& name);

}  // namespace pdr::ui
