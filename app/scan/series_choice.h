#pragma once
/// Which series of a folder is shown, and why none can be.

#include <string>

#include "dicom/series.h"
#include "render/base/result.h"

namespace pdr::app {

/// The place in scan.series of the first one that can be loaded; -1: none can.
int firstLoadable(const dicom::ScanResult& scan);

/// The place in scan.series of the only one that can be loaded, of the only patient there is; -1: somebody has to
/// choose, or there is none.
int onlyLoadable(const dicom::ScanResult& scan);

/// Why none can, in one sentence per reason; `where` and `hint` are left to who asks.
Error nothingLoadable(const dicom::ScanResult& scan);

/// The entry with this `id` (SeriesFacts::id), or the first loadable one for an empty `id`. Errors: none is there, with
/// the reasons why.
Result<dicom::Series> chosenSeries(const dicom::ScanResult& scan, const std::string& id);

}  // namespace pdr::app
