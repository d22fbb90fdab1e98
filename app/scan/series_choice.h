#pragma once
/// Chooses the series of a folder to show, or explains why none can be shown.

#include <string>

#include "dicom/series.h"
#include "render/base/result.h"

namespace pdr::app {

/// Returns whether a series can be loaded, and without being asked for: resampled ones are not.
bool isShownUnasked(const dicom::Series& series);

/// Returns the index in scan.series of the first series that is shown unasked, one in HU if there is any; -1 if there
/// is none.
int firstLoadable(const dicom::ScanResult& scan);

/// Returns the index in scan.series of the only series that is shown unasked, or of the only one in HU, if all series
/// are of one patient; -1 if the user has to choose, or if there is none.
int onlyLoadable(const dicom::ScanResult& scan);

/// Returns why no series can be loaded, each reason once; the caller fills in `where` and `hint`.
Error nothingLoadable(const dicom::ScanResult& scan);

/// Returns the series with this `id` (SeriesFacts::id), or the first that is shown unasked for an empty `id`. Errors:
/// there is none, with the reasons.
Result<dicom::Series> chosenSeries(const dicom::ScanResult& scan, const std::string& id);

}  // namespace pdr::app
