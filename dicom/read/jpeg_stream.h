#pragma once
/// Reads the marker segments of a JPEG or JPEG-LS image (ISO 10918-1, annex B) before a decoder trusts them: for a
/// progressive image it allocates what the frame header states (8 GB for 65,500 x 65,500), whatever the DICOM header
/// says.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "render/base/portable.h"
#include "render/base/text.h"

namespace pdr::dicom {

/// A Huffman code as it is written: the number of codes of each length, and their symbols, shortest first.
struct HuffmanCode {
    std::array<int, 17> counts{};  ///< number of codes by length, 1 to 16; [0] is not used
    std::vector<std::uint8_t> symbols;
};

/// A scan with the settings that apply when it begins.
struct JpegScan {
    std::optional<HuffmanCode> dc, ac;
    int first = 0, last = 0;  ///< Ss, Se: the band of coefficients; lossless: Ss is the predictor
    int high = 0, low = 0;    ///< Ah, Al: the bits of the coefficients that this scan brings
    int dcStep = 1;           ///< value of one step of a block's mean
    int restartInterval = 0;  ///< units between restart markers; 0 = no such markers
    std::vector<std::span<const std::uint8_t>> parts;  ///< entropy-coded data, split at the restart markers
};

struct JpegStream {
    enum class Kind { none, sequential, progressive, lossless, jpegLs, other };
    Kind kind = Kind::none;  ///< none: there is no frame header
    int precision = 0;       ///< bits per sample
    ivec2 size{0};           ///< columns, rows
    int components = 0;
    std::vector<JpegScan> scans;  ///< empty for JPEG-LS, whose decoder checks them itself
    Text damage;                  ///< a phrase ("it ends without its end marker"), or empty
};

/// Reads the marker segments of `stream`, and never beyond its end, whatever they say.
JpegStream readJpeg(std::span<const std::uint8_t> stream);

}  // namespace pdr::dicom
