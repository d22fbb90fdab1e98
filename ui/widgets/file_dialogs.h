#pragma once
/// The dialogs for folders and files. Qt keeps where its dialogs have been in the user's settings, but a folder's name
/// may be a patient's: these leave the settings as they were.

#include <QString>
#include <QWidget>

namespace pdr::ui {

/// Asks for a folder, beginning in `start`; empty: the user cancelled.
QString askForFolder(QWidget* parent, const QString& start);

/// Asks for a folder with certificates, beginning in `start`; empty: the user cancelled.
QString askForCertificates(QWidget* parent, const QString& start);

/// Asks for a file with a look: ours (.json) or 3D Slicer's (.vp.json, .vp); empty: the user cancelled.
QString askForLook(QWidget* parent);

/// Asks for a file with a picture of surroundings (.exr); empty: the user cancelled.
QString askForSky(QWidget* parent);

/// Asks where a look called `name` goes, in one of these formats; empty: the user cancelled.
QString askWhereToShare(QWidget* parent, const QString& name);

}  // namespace pdr::ui
