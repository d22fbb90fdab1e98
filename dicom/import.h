#pragma once
/// Imports a folder as Hounsfield units, in two steps: headers first, pixels on request.

#include <filesystem>

#include "dicom/series.h"
#include "render/base/progress.h"
#include "render/base/result.h"

namespace pdr::dicom {

/// Reads the headers of every file below `folder` (any name, any depth) and sorts them into series. Links are followed,
/// but nothing is read twice, and no link leads back up. A stray, damaged or foreign file does not affect the rest.
/// Errors: no such folder, a file instead of a folder, no permission, no DICOM in it, cancelled.
Result<ScanResult> scanFolder(const std::filesystem::path& folder, const Progress& progress);

enum class Padding {
    /// Padding voxels become Volume::kAirHu and are flagged; so do voxels outside the round field that some GE scanners
    /// leave undeclared (stored -2000 where slope is 1 and intercept -1024).
    maskAsAir,
    keep,  ///< padding voxels keep the stored HU, but are flagged, too; for checksums only
};

/// Decodes the pixels of `series` into HU = stored * slope + intercept, rounded and clamped to int16, slices in the
/// order given, on all cores. Needs verdict.loadable(); `Padding::keep` also accepts any stack whose slices agree in
/// size. Appends to `notes`, if not null, what only the pixels show; the volume's remarks are the codes of the
/// verdict's notes and of these. Errors: the verdict's reason, a file that is gone, damaged or no longer the one that
/// was scanned (named), not enough memory (figures), cancelled.
Result<Volume> loadSeries(const Series& series, Padding padding, const Progress& progress,
                          std::vector<Note>* notes = nullptr);

}  // namespace pdr::dicom
