#pragma once
/// The pixels of a segmentation, frame by frame.

#include <cstdint>
#include <span>
#include <vector>

#include "dicom/read/image_file.h"
#include "dicom/read/slice_header.h"
#include "render/base/result.h"

class DcmItem;

namespace pdr::dicom {

class FramePixels {
  public:
    /// `data`: the data set of `object`, which must outlive this. Errors: a pixel format that is none of a
    /// segmentation, or a coding that is not read; fewer pixels than stated.
    static Result<FramePixels> open(const NamedBytes& object, const SliceHeader& header, DcmItem& data);

    /// Writes the numbers of a frame into `out`, columns x rows, x fastest. Errors: damaged.
    Result<void> read(int frame, std::span<std::uint16_t> out) const;

  private:
    FramePixels(int bits, std::span<const std::uint8_t> bytes) : bits_(bits), bytes_(bytes) {}

    int bits_;                             ///< width of a pixel: 1, 8 or 16
    std::span<const std::uint8_t> bytes_;  ///< the pixels of all frames; empty: they are compressed
    std::vector<ImageFile> coded_;         ///< one, if they are compressed
};

}  // namespace pdr::dicom
