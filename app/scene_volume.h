#pragma once
/// Fetches the voxels that a scene file asks for, from a DICOM folder or a raw file.

#include <memory>
#include <string>

#include "dicom/series.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/scene/scene_file.h"

namespace pdr::app {

/// The series with `uid`, or the first loadable one for an empty `uid`. Errors: none is there, with the reasons why.
Result<dicom::Series> chosenSeries(const dicom::ScanResult& scan, const std::string& uid);

/// Errors: those of the DICOM import and of raw files.
Result<std::shared_ptr<const Volume>> fetchVolume(const VolumeSource& source, const Progress& progress);

}  // namespace pdr::app
