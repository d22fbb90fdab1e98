#pragma once
/// Many independent files, all cores, one voice that reports.

#include <cstddef>
#include <functional>
#include <string_view>

#include "render/base/progress.h"

namespace pdr::dicom {

/// Calls `work(i)` once for every i in [0, count), in no order, on all cores; `progress` is called on the calling
/// thread only. Returns false when progress said stop: then some i were left out; likewise when `work` throws, which is
/// thrown here again.
bool onAllCores(std::size_t count, const std::function<void(std::size_t)>& work, const Progress& progress,
                std::string_view step);

}  // namespace pdr::dicom
