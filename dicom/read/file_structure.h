#pragma once
/// Walks the elements of a file, without building anything, before the DICOM toolkit reads it. The toolkit recurses
/// into nested sequences (20,000 levels overflow the stack) and allocates what a length field says; a damaged or
/// hostile file must not control either.

#include <cstdint>
#include <string>

#include "dicom/go_on.h"
#include "render/base/named_bytes.h"
#include "render/base/text.h"

namespace pdr::dicom {

struct FileStructure {
    bool isDicom = false;           ///< false: nothing below is valid
    bool hasMetaHeader = false;     ///< whether group 0002 is present
    std::string transferSyntaxUid;  ///< transfer syntax of the data set: as stated, or as found if not stated
    bool reachesPixels = false;     ///< whether everything before the pixel data is sound
    std::uint64_t pixelBytes = 0;   ///< length of the pixel data as they lie in the file, floating-point or not
    std::uint64_t pixelsAt = 0;     ///< offset of their value; in a deflated file, in what is inflated
    bool hasPixelsTwice = false;    ///< whether there are two such elements, and which is the image is not known
    Text damage;                    ///< empty: sound to the last byte; else a phrase ("ends 12 bytes into ...")
};

/// Largest depth of nested sequences; deeper ones are refused. Real files stay below ten.
inline constexpr int kMaxNesting = 64;
/// Largest size of an inflated data set [bytes]: the largest slice that is accepted, and its header.
inline constexpr std::size_t kMaxInflatedBytes = std::size_t(160) << 20;
/// Largest number of elements, items, fragments and values of long texts in one file. A CT slice has some hundred; the
/// toolkit spends 250 bytes on each.
inline constexpr int kMaxElements = 50'000;
/// Number of elements that each frame of a multi-frame image adds to that, and largest sum of all. The groups of a
/// frame hold nine to some sixty elements.
inline constexpr int kMaxFrameElements = 500, kMaxElementsOfAll = 2'000'000;
/// Largest number of bytes in the values that the toolkit reads into memory with the header, and in the texts that it
/// converts.
inline constexpr std::size_t kMaxHeaderBytes = std::size_t(64) << 20;
/// Number of bytes that each frame of a multi-frame image adds to that, and largest sum of all.
inline constexpr std::size_t kMaxFrameBytes = std::size_t(64) << 10, kMaxHeaderBytesOfAll = std::size_t(512) << 20;
/// Largest number of frames in one file; a CT of the whole body has some thousands.
inline constexpr int kMaxFrames = 16'384;

/// Largest size of a text that is a list of values [bytes], and largest number of its values. A description has a
/// hundred; in a long list the toolkit counts all values anew for each, which takes minutes and cannot be cancelled.
inline constexpr std::size_t kMaxListBytes = std::size_t(64) << 10;
inline constexpr int kMaxListValues = 1000;

/// Checks `object`; never throws because of its content. `damage` also says if it cannot be opened. Asks `goOn` at
/// least once in a thousand elements and in a megabyte inflated, and ends with the damage "cancelled" if it returns
/// false.
FileStructure checkStructure(const NamedBytes& object, const GoOn& goOn = always);

}  // namespace pdr::dicom
