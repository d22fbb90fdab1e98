#pragma once
/// Decompresses pixel data without trusting it.

#include "dicom/read/slice_header.h"

class DcmDataset;

namespace pdr::dicom {

/// Decodes the pixel data of `data` in place if it is compressed. Returns what is wrong with it, as a phrase ("the
/// compressed image cannot be decoded"); empty if nothing can be seen from the outside. Thread-safe.
Text decompress(DcmDataset& data, const SliceHeader& header);

}  // namespace pdr::dicom
