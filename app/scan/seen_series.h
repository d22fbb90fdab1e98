#pragma once
/// Fetches a series as the window shows it at first: without the scanner's table. The voxels stand in memory once.

#include <memory>
#include <vector>

#include "app/scan/hidden_voxels.h"
#include "dicom/import.h"
#include "dicom/series.h"
#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/segment/hidden_table.h"

namespace pdr::app {

struct SeenSeries {
    std::shared_ptr<const Volume> volume;        ///< the scan without its table
    segment::HiddenTable table;                  ///< what was hidden of it
    std::shared_ptr<const HiddenVoxels> hidden;  ///< the voxels that `volume` lacks; null if there are none
    std::vector<dicom::Note> notes;              ///< what the user should know about how the voxels were read
};

/// Reads the voxels of `series`, which comes from scanPlace(), and hides the table. `onArrival`: see loadVoxels().
/// Errors: those of loadVoxels(); cancelled().
Result<SeenSeries> seenSeries(const dicom::Series& series, const Progress& progress,
                              const dicom::OnArrival& onArrival = {});

}  // namespace pdr::app
