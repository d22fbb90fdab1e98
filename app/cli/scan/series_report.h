#pragma once
/// Facts about one series that `info` prints, as JSON and as text.

#include <nlohmann/json.hpp>
#include <string>

#include "app/cli/step_clock.h"
#include "dicom/series.h"
#include "render/base/progress.h"

namespace pdr::app {

/// What a report has beside what it always has.
struct WantedFacts {
    bool description = false;  ///< the free-text description of the series, which may contain a name
    bool times = false;        ///< how long each step took
};

/// Returns series, verdict and slices always; grid, HU statistics and checksum where the pixels can be decoded as a
/// stack:
///   size [voxels], spacingMm between columns, rows and the planes of slices; driftMm: how far each slice lies along
///   rows and columns from the one before, 0 but for a tilted gantry; originMm (centre of voxel 0,0,0), rowDirection,
///   columnDirection (patient space LPS)
///   hu: lowest, highest, mean over all voxels; huWithoutPadding: the same without padding
///   sha256 of the HU volume as int16 little-endian, x fastest, before padding is masked
///   readSeconds, statisticsSeconds, checksumSeconds, tableSeconds if `wanted` has times: from files to voxels in
///   memory, and what each further step took; with ProcessorSeconds, the processor time of each
/// Decodes the pixels, so it takes as long as loading.
nlohmann::ordered_json reportOf(const dicom::Series& series, const WantedFacts& wanted, const Progress& progress);

/// Adds the time of `step` to a report: readSeconds, readProcessorSeconds for "read".
void addTime(nlohmann::ordered_json& report, const std::string& step, const StepTime& time);

/// Returns the report for a person: a few lines, indented.
std::string textOf(const nlohmann::ordered_json& report);

}  // namespace pdr::app
