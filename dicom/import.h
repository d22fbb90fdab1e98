#pragma once
/// Imports DICOM objects as Hounsfield units, in two steps: headers first, pixels on request.

#include <filesystem>
#include <functional>
#include <memory>

#include "dicom/series.h"
#include "dicom/series_source.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/arriving_volume.h"

namespace pdr::dicom {

/// Reads the headers of all objects of `source`, which must not be null, and sorts them into series; these keep the
/// source. A stray, damaged or foreign object does not affect the rest. Errors: those of SeriesSource::list(); no DICOM
/// in it (ErrorKind::refused); cancelled.
Result<ScanResult> scanSource(const std::shared_ptr<const SeriesSource>& source, const Progress& progress);

/// Scans all files below `folder` (any name, any depth). Links are followed, but nothing is read twice, and no link
/// leads back up. Errors: no such folder, a file instead of a folder, no permission, empty, no DICOM in it, cancelled.
Result<ScanResult> scanFolder(const std::filesystem::path& folder, const Progress& progress);

/// Returns the files in the ZIP archive `archive` (any name, any depth). Each is unpacked into memory whenever it is
/// opened; nothing is written to the disk. Links, archives within the archive and names that lead out of it are left
/// out by name. Errors: no such file, damaged, encrypted, more than 100,000 files, 64 GB or 200 times its size.
Result<std::shared_ptr<const SeriesSource>> openArchive(const std::filesystem::path& archive);

enum class Padding {
    /// Padding voxels become Volume::kAirHu and are flagged; so do voxels outside the round field that some GE scanners
    /// leave undeclared (stored -2000 where slope is 1 and intercept -1024).
    maskAsAir,
    keep,  ///< padding voxels keep the stored HU, but are flagged, too; for checksums only
};

/// Takes the volume that a series is read into before its first slice arrives, on the thread that reads. Its slices can
/// be looked at until the reading ends, in whatever way.
using OnArrival = std::function<void(std::shared_ptr<const ArrivingVolume>)>;

/// Decodes the pixels of `series` into HU = stored * slope + intercept, rounded and clamped to int16, slices in the
/// order given, on all cores, the middle one first. Needs verdict.loadable(); `Padding::keep` also accepts any stack
/// whose slices agree in size. `series` must come from a scan. Appends to `notes`, if not null, what only the pixels
/// show; the volume's remarks are the codes of the verdict's notes and of these. `onArrival` is called once, but not
/// for slices that are resampled. Errors: the verdict's reason, a file that is gone, damaged or no longer the one that
/// was scanned (named), not enough memory (figures), cancelled.
Result<Volume> loadSeries(const Series& series, Padding padding, const Progress& progress,
                          std::vector<Note>* notes = nullptr, const OnArrival& onArrival = {});

}  // namespace pdr::dicom
