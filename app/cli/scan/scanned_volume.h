#pragma once
/// The scan as it was read, for what is measured: with its table, without interpolated slices, not clamped.

#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "dicom/series.h"
#include "render/base/result.h"
#include "render/scene/table.h"
#include "render/volume/volume.h"

namespace pdr::app {

struct ScannedVolume {
    std::shared_ptr<const Volume> volume;         ///< all that was read
    std::shared_ptr<const Volume> seen;           ///< `volume` without the table where that is hidden
    VolumeGeometry body;                          ///< the part of the grid that `seen` fills
    std::shared_ptr<const dicom::Series> series;  ///< null for a raw file
    std::vector<std::filesystem::path> files;     ///< files that it was read from, except those of a DICOM folder
};

/// Reads the scan of a DICOM folder, or the one that a scene file names, with a progress line. Writes notes to standard
/// error: those of the import, and that there are other series. `seriesUid`: empty for the first that can be loaded.
/// `table`: hidden for the scan as the window has it, whatever a scene file says. Errors: those of scene files and of
/// the import; cancelled() on a stop.
Result<ScannedVolume> scannedVolume(const std::filesystem::path& path, const std::string& seriesUid,
                                    Table table = Table::shown, const std::stop_token& stop = {});

}  // namespace pdr::app
