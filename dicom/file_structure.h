#pragma once
/// Walks the elements of a file, without building anything, before the DICOM toolkit may touch it. The toolkit recurses
/// into nested sequences (20,000 levels overflow the stack) and allocates what a length field says; neither is left to
/// a damaged or hostile file.

#include <cstdint>
#include <filesystem>
#include <string>

namespace pdr::dicom {

struct FileStructure {
    bool isDicom = false;           ///< else nothing below means anything
    bool hasMetaHeader = false;     ///< group 0002 is there
    std::string transferSyntaxUid;  ///< of the data set: as stated, or as found where nothing is stated
    bool reachesPixels = false;     ///< everything before the pixel data is sound
    std::uint64_t pixelBytes = 0;   ///< length of the pixel data element as it lies in the file
    std::string damage;             ///< empty: sound to the last byte; else a phrase ("ends 12 bytes into ...")
};

/// Sequences nested deeper than this are refused. Real files stay below ten.
inline constexpr int kMaxNesting = 64;
/// A deflated data set may not grow beyond this many bytes.
inline constexpr std::size_t kMaxInflatedBytes = std::size_t(256) << 20;

/// Reads `file`; never throws for what is in it. `damage` also tells when it cannot be opened.
FileStructure checkStructure(const std::filesystem::path& file);

}  // namespace pdr::dicom
