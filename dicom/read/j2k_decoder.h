#pragma once
/// Decodes JPEG 2000 and High-Throughput JPEG 2000 through OpenJPEG.

#include <cstdint>
#include <vector>

#include "dicom/read/j2k_stream.h"

namespace pdr::dicom {

struct J2kImage {
    J2kStream stream;
    bool isMended = false;             ///< whether a length was put right; see mendLastLength()
    std::vector<std::uint16_t> words;  ///< the pixels' bits, row by row from the top; empty if the stream is damaged
};

/// Decodes `stream`, a grey image of `size` pixels (columns, rows) and at most 16 bits. All that the decoder complains
/// about counts as damage, and is in the image's stream. Thread-safe; uses no thread of its own.
J2kImage decodeJ2k(std::vector<std::uint8_t> stream, ivec2 size);

}  // namespace pdr::dicom
