#pragma once
/// How large a JPEG or JPEG-LS picture says it is, read before a decoder may believe it: for a progressive picture the
/// decoder allocates what the frame header states (8 GB for 65,500 x 65,500), whatever the DICOM header says.

#include <cstdint>
#include <optional>
#include <span>

#include "render/base/portable.h"

namespace pdr::dicom {

/// Columns and rows in the frame header (SOF) of the code stream; nothing where there is none. ISO 10918-1, B.1.1.
std::optional<ivec2> jpegSize(std::span<const std::uint8_t> stream);

}  // namespace pdr::dicom
