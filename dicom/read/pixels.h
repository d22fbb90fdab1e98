#pragma once
/// Decodes slices into Hounsfield units.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "dicom/go_on.h"
#include "dicom/import.h"
#include "dicom/named_bytes.h"
#include "dicom/read/file_state.h"
#include "dicom/read/fragments.h"
#include "dicom/read/slice_header.h"

namespace pdr::dicom {

struct DecodedSlice {
    ivec2 size{0};                      ///< columns, rows
    std::vector<std::int16_t> hu;       ///< x fastest; rounded and clamped to int16
    std::size_t clipped = 0;            ///< number of pixels whose HU lie outside int16
    bool hasLost = false;               ///< whether the coding has lost something, and the header does not say so
    bool isMended = false;              ///< whether a wrong length in the coding was put right
    SliceIdentity identity;             ///< what the file said when its pixels were read
    std::vector<std::uint8_t> padding;  ///< 1 = nothing measured; empty if there is no such pixel
};

/// Returns the error of a `file` that is no longer the one that was scanned.
Error changedFile(const std::filesystem::path& file);

/// An object that was opened to decode its frames, one or many: its header is read once, its pixels frame by frame.
class ImageFile {
  public:
    /// Opens `object`. Errors: file gone, damaged, no image, or in a coding that cannot be read; each names the object.
    /// `goOn`: see readSliceHeader().
    static Result<ImageFile> open(const NamedBytes& object, const GoOn& goOn = always);

    int frames() const { return header_.frames; }

    /// Decodes the frame of that index. Errors: no such frame, damaged, or written anew since it was opened.
    /// Thread-safe.
    Result<DecodedSlice> decode(int frame, Padding padding) const;

  private:
    Result<void> readChecked(const GoOn& goOn);
    Result<DecodedSlice> decodeFrame(const SliceHeader& frame, Padding padding) const;
    Result<DecodedSlice> decodeCodedFrame(const SliceHeader& frame, Padding padding) const;

    NamedBytes object_;
    FileState state_;
    SliceHeader header_;
    std::vector<SliceHeader> frames_;               ///< empty: it is one image without functional groups
    std::vector<std::vector<Fragment>> fragments_;  ///< one list for each frame, if they are compressed
};

/// Decodes a frame of `object`; the errors are those of ImageFile. Thread-safe.
Result<DecodedSlice> decodeSlice(const NamedBytes& object, Padding padding, int frame = 0);

/// Decodes `slice` of `source`. Errors: those of SeriesSource::open() and of the decoding.
Result<DecodedSlice> decodeSlice(const SeriesSource& source, const SliceRef& slice, Padding padding);

}  // namespace pdr::dicom
