#pragma once
/// Reads the marker segments of a JPEG 2000 codestream (ISO 15444-1, annex A; High-Throughput: ISO 15444-15) before a
/// decoder trusts them, and mends a length that some writers state wrongly.

#include <cstdint>
#include <span>
#include <vector>

#include "render/base/portable.h"
#include "render/base/text.h"

namespace pdr::dicom {

struct J2kStream {
    ivec2 size{0};          ///< columns, rows
    int precision = 0;      ///< bits per sample
    bool isSigned = false;  ///< whether samples are signed
    int components = 0;
    bool isReversible = true;  ///< whether all filters are those that lose nothing
    Text damage;               ///< a phrase ("it ends inside its header"), or empty
};

/// Reads the headers of `stream`, and never beyond its end, whatever they say. More tiles, precincts or code blocks
/// than a decoder should allocate count as damage. Samples are not looked at: JPEG 2000 has no checksum.
J2kStream readJ2k(std::span<const std::uint8_t> stream);

/// Removes what lies around the codestream: the boxes of a .jp2 file before it, and padding with zeros behind it.
void trimToCodestream(std::vector<std::uint8_t>& stream);

/// Mends a last tile part that states more bytes than there are although the codestream is complete: it ends with its
/// end marker. Its length becomes 0, which stands for "up to the end" (A.4.2). Returns whether there was one.
bool mendLastLength(std::vector<std::uint8_t>& stream);

}  // namespace pdr::dicom
