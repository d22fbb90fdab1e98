#pragma once
/// Writes a Volume as a DICOM CT series (one file per slice, explicit VR little endian) that other tools accept.

#include <filesystem>
#include <string>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr::dicom {

/// The facts that the files state about themselves. Never real patient data.
struct ExportFacts {
    std::string patientName;  ///< DICOM person name, "Family^Given"
    std::string patientId;
    std::string studyDescription;
    std::string seriesDescription;
    std::string derivation;  ///< origin of the voxels, in a sentence
    std::string bodyPart{};  ///< unpaired body part as DICOM calls it: "HEAD"; empty: not known
};

/// Creates `folder` (which must not hold files) and writes size.z files into it. They are written beside it and renamed
/// into place: after an error nothing half-written is left.
Result<void> writeSeries(const Volume& volume, const ExportFacts& facts, const std::filesystem::path& folder,
                         const Progress& progress);

}  // namespace pdr::dicom
