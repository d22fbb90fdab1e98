#pragma once
/// Decompresses pixel data without trusting it.

#include <cstdint>
#include <vector>

#include "dicom/read/slice_header.h"

class DcmDataset;

namespace pdr::dicom {

/// What decoding has shown.
struct Decoding {
    Text damage;            ///< a phrase ("the compressed image cannot be decoded"), or empty: none can be seen
    PixelFormat format;     ///< how decoded pixels are stored; a JPEG 2000 stream may state otherwise than the header
    bool hasLost = false;   ///< whether the stream says that its coding has lost something, whatever the header says
    bool isMended = false;  ///< whether a wrong length in the stream was put right
    std::vector<std::uint16_t> words{};  ///< the pixels, if they were not decoded in place
};

/// Decodes the pixel data of `data` in place if it is compressed; what the toolkit does not decode comes as words.
/// Thread-safe.
Decoding decompress(DcmDataset& data, const SliceHeader& header);

}  // namespace pdr::dicom
