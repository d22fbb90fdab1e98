#pragma once
/// Writes a Volume as a DICOM CT series (one file per slice, explicit VR little endian) that other tools accept.

#include <filesystem>
#include <string>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr::dicom {

/// What the files say about themselves. Never real patient data.
struct ExportFacts {
    std::string patientName;  ///< DICOM person name, "Family^Given"
    std::string patientId;
    std::string studyDescription;
    std::string seriesDescription;
    std::string derivation;  ///< where the voxels come from, in a sentence
    std::string bodyPart{};  ///< one that is no pair, as DICOM calls it: "HEAD"; empty: not known
};

/// Creates `folder` (which must not hold files) and writes size.z files into it. Written beside and renamed into place:
/// after an error nothing half-written is left.
Result<void> writeSeries(const Volume& volume, const ExportFacts& facts, const std::filesystem::path& folder,
                         const Progress& progress);

}  // namespace pdr::dicom
