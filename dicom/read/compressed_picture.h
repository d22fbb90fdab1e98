#pragma once
/// From compressed pixel data to plain pixels, without believing it.

#include "dicom/read/slice_header.h"

class DcmDataset;

namespace pdr::dicom {

/// Decodes the pixel data of `data` in place, where it is compressed. Returns what is wrong with it, as a phrase
/// ("the compressed picture cannot be decoded"); empty: nothing that can be told from the outside. Thread-safe.
Text decompress(DcmDataset& data, const SliceHeader& header);

}  // namespace pdr::dicom
