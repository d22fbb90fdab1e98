#pragma once
/// A small CT series of a made-up head, for tests that need files.

#include <filesystem>

#include "dicom/write/export.h"
#include "render/volume/phantom.h"

namespace pdr {

/// Writes 64 slices of 64 x 57 voxels into `folder`, which must not hold files.
inline Result<void> writePhantomSeries(const std::filesystem::path& folder, const std::string& description = "Head") {
    const Volume head = headPhantom({64, 57, 64}, {3.9, 4.9, 3.9});
    const dicom::ExportFacts facts{"Phantom^Head", "PHANTOM", "Test", description, "A head made from formulas."};
    return dicom::writeSeries(head, facts, folder, noProgress);
}

}  // namespace pdr
