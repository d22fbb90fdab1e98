#pragma once
/// Runs independent work on all cores and reports the progress of all of it.

#include <cstddef>
#include <functional>
#include <string_view>

#include "dicom/go_on.h"
#include "render/base/progress.h"

namespace pdr::dicom {

/// Calls `work(i, goOn)` once for every i in [0, count), in no order, on all cores; `progress` is called on the calling
/// thread only. `work` should end soon when its goOn returns false. Returns false if progress requested a stop: some i
/// were left out then. Some are also left out if `work` throws; the exception is thrown again here.
bool onAllCores(std::size_t count, const std::function<void(std::size_t, const GoOn&)>& work, const Progress& progress,
                std::string_view step);

}  // namespace pdr::dicom
