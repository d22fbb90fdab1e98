#pragma once
/// An object of one image or of many frames, opened to decode them.

#include <vector>

#include "dicom/go_on.h"
#include "dicom/import.h"
#include "dicom/read/file_state.h"
#include "dicom/read/fragments.h"
#include "dicom/read/pixels.h"
#include "dicom/read/slice_header.h"
#include "render/base/named_bytes.h"

namespace pdr::dicom {

/// An object that was opened to decode its frames, one or many: its header is read once, its pixels frame by frame.
class ImageFile {
  public:
    /// Opens `object`. Errors: file gone, damaged, no image, or in a coding that cannot be read; each names the object.
    /// `goOn`: see readSliceHeader().
    static Result<ImageFile> open(const NamedBytes& object, const GoOn& goOn = always);

    int frames() const { return header_.frames; }

    /// Decodes the frame of that index into voxels of `unit`. Errors: no such frame, damaged, or written anew since it
    /// was opened. Thread-safe.
    Result<DecodedSlice> decode(int frame, Padding padding, const ValueUnit& unit = {}) const;

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

}  // namespace pdr::dicom
