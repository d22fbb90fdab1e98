#pragma once
/// Fetches the voxels of a scene, from a DICOM folder or a raw file: the one way to them, for the window and the
/// command line.

#include <memory>
#include <string>
#include <vector>

#include "dicom/series.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/scene/scene_file.h"

namespace pdr::app {

struct FetchedVolume {
    WantedVolume wanted;
    std::vector<dicom::Note> notes;               ///< what a user should know about how they were read
    std::shared_ptr<const dicom::Series> series;  ///< whose they are; null: a raw file's
};

/// Those of `series`, as `source` wants them. Errors: those of the DICOM import; cancelled().
Result<FetchedVolume> fetchSeries(const dicom::Series& series, const VolumeSource& source, const Progress& progress);
/// Errors: those of the DICOM import and of raw files.
Result<FetchedVolume> fetchVolume(const VolumeSource& source, const Progress& progress);

}  // namespace pdr::app
