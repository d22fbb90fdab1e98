#pragma once
/// A DICOM file that gzip has packed (slice.dcm.gz), unpacked into memory.

#include <filesystem>

#include "render/base/named_bytes.h"
#include "render/base/result.h"

namespace pdr::dicom {

/// Returns the unpacked bytes of `file`. Only what begins as a DICOM file with a meta header is unpacked; anything
/// else is left as it lies, which is no DICOM. Errors: a DICOM file that is damaged, cut off, larger than
/// 200 times its packed size, or than the memory that is free.
Result<NamedBytes> openPacked(const std::filesystem::path& file);

}  // namespace pdr::dicom
