#pragma once
/// Fetches the voxels of a scene, from a DICOM folder or a raw file. Both window and command line read voxels through
/// this code.

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
    std::vector<dicom::Note> notes;               ///< what the user should know about how the voxels were read
    std::shared_ptr<const dicom::Series> series;  ///< series of the voxels; null for a raw file
    std::ptrdiff_t loadableSeries = 0;            ///< how many series fetchVolume() had to choose from
};

/// Reads the voxels of `series`, as requested by `source`. Errors: those of the DICOM import; cancelled().
Result<FetchedVolume> fetchSeries(const dicom::Series& series, const VolumeSource& source, const Progress& progress);
/// Reads the voxels that `source` names. Errors: those of the DICOM import and of raw files.
Result<FetchedVolume> fetchVolume(const VolumeSource& source, const Progress& progress);

}  // namespace pdr::app
