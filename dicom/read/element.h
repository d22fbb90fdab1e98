#pragma once
/// The headers of the elements of a DICOM file, as they lie in it (PS3.5, chapter 7).

#include <cstdint>
#include <optional>
#include <string>

#include "dicom/read/byte_source.h"

namespace pdr::dicom {

inline constexpr std::uint32_t kUndefined = 0xFFFFFFFF;
inline constexpr std::uint32_t kItem = 0xFFFEE000, kItemEnd = 0xFFFEE00D, kSequenceEnd = 0xFFFEE0DD;
inline constexpr std::uint32_t kTransferSyntax = 0x00020010, kNumberOfFrames = 0x00280008, kPixelData = 0x7FE00010;
/// Elements that hold pixels as floating-point numbers of 32 and 64 bits.
inline constexpr std::uint32_t kFloatPixelData = 0x7FE00008, kDoubleFloatPixelData = 0x7FE00009;

struct Encoding {
    bool explicitVr = true;
    bool bigEndian = false;
};

/// The header of one element, as it lies in the file.
struct Element {
    std::uint32_t tag = 0;  ///< group in the upper half
    enum class Kind {
        plain,
        sequence,
        unknown,          ///< written as "unknown"; a sequence if it has no length
        unknownSequence,  ///< written as "unknown", but a sequence by the dictionary
    };
    Kind kind = Kind::plain;
    enum class Text {
        none,
        plain,  ///< one value of any length
        list,   ///< values of letters, separated by backslashes
    };
    Text text = Text::none;
    std::uint32_t length = 0;
    std::uint64_t value = 0;  ///< offset of its value in the file
};

/// Formats a tag: "(7fe0,0010)".
std::string hexTag(std::uint32_t tag);

/// Returns the header of the element at `at`; none if the file ends inside it.
std::optional<Element> readElement(ByteSource& source, std::uint64_t at, Encoding encoding);

/// Detects the coding of a data set that does not state it, from its first element, as the toolkit does.
Encoding detectEncoding(ByteSource& source, std::uint64_t at);

/// Returns whether the bytes at `at` can be the first element of a DICOM file: group 0002 or 0008, known, of sensible
/// length.
bool looksLikeElement(ByteSource& source, std::uint64_t at);

}  // namespace pdr::dicom
