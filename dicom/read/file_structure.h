#pragma once
/// Walks the elements of a file, without building anything, before the DICOM toolkit may touch it. The toolkit recurses
/// into nested sequences (20,000 levels overflow the stack) and allocates what a length field says; neither is left to
/// a damaged or hostile file.

#include <cstdint>
#include <filesystem>
#include <string>

#include "dicom/go_on.h"
#include "render/base/text.h"

namespace pdr::dicom {

struct FileStructure {
    bool isDicom = false;           ///< else nothing below means anything
    bool hasMetaHeader = false;     ///< group 0002 is there
    std::string transferSyntaxUid;  ///< of the data set: as stated, or as found where nothing is stated
    bool reachesPixels = false;     ///< everything before the pixel data is sound
    std::uint64_t pixelBytes = 0;   ///< length of the pixel data element as it lies in the file
    Text damage;                    ///< empty: sound to the last byte; else a phrase ("ends 12 bytes into ...")
};

/// Sequences nested deeper than this are refused. Real files stay below ten.
inline constexpr int kMaxNesting = 64;
/// A deflated data set may not grow beyond this many bytes: the largest slice taken, and its header.
inline constexpr std::size_t kMaxInflatedBytes = std::size_t(160) << 20;
/// Elements, items, fragments and values of long texts in one file. A CT slice has some hundred; the toolkit spends 250
/// bytes on each.
inline constexpr int kMaxElements = 50'000;
/// Bytes of the values that the toolkit reads into memory with the header, and of the texts that it converts.
inline constexpr std::size_t kMaxHeaderBytes = std::size_t(64) << 20;

/// Bytes of a text that is a list of values, and its values. A description has a hundred; of a long list the toolkit
/// counts all values anew for each, which takes minutes and cannot be ended.
inline constexpr std::size_t kMaxListBytes = std::size_t(64) << 10;
inline constexpr int kMaxListValues = 1000;

/// Reads `file`; never throws for what is in it. `damage` also tells when it cannot be opened. Asks `goOn` at least
/// once in a thousand elements and in a megabyte inflated, and ends with the damage "cancelled" when told to.
FileStructure checkStructure(const std::filesystem::path& file, const GoOn& goOn = always);

}  // namespace pdr::dicom
