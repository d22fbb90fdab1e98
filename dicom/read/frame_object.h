#pragma once
/// One compressed frame as an object of its own, for decoders that read whole objects.

#include <cstdint>
#include <span>
#include <vector>

#include "dicom/read/slice_header.h"

namespace pdr::dicom {

/// Returns the bytes of a data set in explicit little endian, without a meta header, that holds the pixel format of
/// `header` and `stream` as its only fragment.
std::vector<std::uint8_t> frameObject(const SliceHeader& header, std::span<const std::uint8_t> stream);

}  // namespace pdr::dicom
