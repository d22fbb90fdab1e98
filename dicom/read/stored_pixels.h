#pragma once
/// Converts stored pixels to values.

#include "dicom/read/compressed_image.h"
#include "dicom/read/pixels.h"

namespace pdr::dicom {

/// Returns the values of `raw`, all pixels of an image, x fastest: of 8, 16 or 32 bits, as the format of `decoding`
/// says.
template <class Raw>
DecodedSlice toHu(const Raw* raw, const SliceHeader& header, const Decoding& decoding, Padding padding);

/// Returns the values of floating-point pixels, float or double; what is no finite number was not measured.
template <class Real>
DecodedSlice realsToHu(const Real* raw, const SliceHeader& header, Padding padding);

}  // namespace pdr::dicom
