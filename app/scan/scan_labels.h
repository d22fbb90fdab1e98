#pragma once
/// Label maps of a scan, from the files of other programs. Window and command line read them through this code.

#include <filesystem>

#include "dicom/series.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/label_fit.h"
#include "render/volume/label_map.h"

namespace pdr::app {

/// Reads the label map in `file`, a folder of masks or a DICOM segmentation if its ending is that of no volume, on the
/// grid that it has there. `scan`: the grid of the voxels that were read; `series`: what they were read from, null for
/// a raw file. Errors: those of readLabelFile(), readLabelFolder() and dicom::readSegmentation(); each names the file.
Result<LabelMap> readLabels(const std::filesystem::path& file, const VolumeGeometry& scan, const dicom::Series* series,
                            const Progress& progress);

/// Reads a label map as readLabels() does, onto the grid of the scan. Errors: also those of labelsOn().
Result<LabelMap> readScanLabels(const std::filesystem::path& file, const VolumeGeometry& scan,
                                const dicom::Series* series, Resampling resampling, const Progress& progress);

}  // namespace pdr::app
