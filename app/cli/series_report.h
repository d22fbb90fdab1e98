#pragma once
/// Facts about one series that `info` prints, as JSON and as text.

#include <nlohmann/json.hpp>
#include <string>

#include "dicom/series.h"
#include "render/base/progress.h"

namespace pdr::app {

/// Returns series, verdict and slices always; grid, HU statistics and checksum where the pixels can be decoded as a
/// stack:
///   size [voxels], spacingMm, originMm (centre of voxel 0,0,0), rowDirection, columnDirection (patient space LPS)
///   hu: lowest, highest, mean over all voxels; huWithoutPadding: the same without padding
///   sha256 of the HU volume as int16 little-endian, x fastest, before padding is masked
/// Decodes the pixels, so it takes as long as loading.
/// `withDescription`: adds the free-text description of the series, which may contain a name.
nlohmann::ordered_json reportOf(const dicom::Series& series, bool withDescription, const Progress& progress);

/// Returns the report for a person: a few lines, indented.
std::string textOf(const nlohmann::ordered_json& report);

}  // namespace pdr::app
