#pragma once
/// Shows a folder in the window, while it is read, and the volume that is read from it.

#include <memory>

#include "app/desktop/desktop_parts.h"

namespace pdr::app {

/// Makes all holders of the document's volume, its parts or its masks release them: the next series waits for that.
void letGoOfVolume(const DesktopParts& parts);
/// Shows the start page without an image, and releases everything of the previous one.
void showNothing(const DesktopParts& parts);
/// Shows the series of `folder`. If only one can be shown, it is loaded; else the user chooses from the list, or a
/// message says why none can be shown.
void showScan(const DesktopParts& parts, const dicom::ScanResult& scan, const QString& folder);
/// Shows the folders opened last, as far as they are remembered.
void showRecentFolders(const DesktopParts& parts);
/// Closes the current volume to free its memory, and reads the series `index` of the last scan.
void showReading(const DesktopParts& parts, int index);
/// Shows the series `index` of the last scan. `volume`: its voxels without the `table`; `findings`: what was found in
/// it; `hidden`: the voxels of the table.
void showVolume(const DesktopParts& parts, std::shared_ptr<const Volume> volume, int index,
                const segment::HiddenTable& table, const segment::Findings& findings,
                std::shared_ptr<const HiddenVoxels> hidden);
/// Shows the progress of reading.
void showProgress(const DesktopParts& parts, double fraction, const QString& step);
/// Updates the window when reading has ended without a new image: the current image stays, if there is one.
void showReadingEnded(const DesktopParts& parts);

}  // namespace pdr::app
