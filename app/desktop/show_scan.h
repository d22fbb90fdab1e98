#pragma once
/// What the window shows of a folder, while it is read, and of the volume that comes of it.

#include <memory>

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// All that holds the document's volume, its parts or its masks beside it drops them: the next series waits for that.
void letGoOfVolume(const DesktopParts& parts);
/// An invitation to open a folder, and no picture; nothing of the one before is kept.
void showNothing(const DesktopParts& parts);
/// The series of `folder`. The only one that can be shown is loaded; else the list is there to choose from, and if
/// there is none a message says why.
void showScan(const DesktopParts& parts, const dicom::ScanResult& scan, const QString& folder);
/// The folders opened last, as far as they are remembered.
void showRecentFolders(const DesktopParts& parts);
/// Closes what is shown, so that there is room, and reads the series `index` of the last scan.
void showReading(const DesktopParts& parts, int index);
/// The series `index` of the last scan, whose voxels without its `table` are `volume`; what was found in it, and the
/// voxels that are hidden with the table.
void showVolume(const DesktopParts& parts, std::shared_ptr<const Volume> volume, int index,
                const segment::HiddenTable& table, const segment::Findings& findings,
                std::shared_ptr<const HiddenVoxels> hidden);
/// How far reading has come.
void showProgress(const DesktopParts& parts, double fraction, const QString& step);
/// Reading has ended without a new picture: what is shown stays, if anything is.
void showReadingEnded(const DesktopParts& parts);

}  // namespace pdr::app
