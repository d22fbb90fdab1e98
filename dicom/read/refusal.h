#pragma once
/// Decides which images are not CT slices that this program can read, and why.

#include <optional>

#include "dicom/read/slice_header.h"

namespace pdr::dicom {

/// Largest number of rows and of columns that is accepted [pixels]; real CT has up to 2048.
inline constexpr int kMaxSide = 8192;

struct Refusal {
    Stack stack = Stack::notCt;  ///< notCt or unreadable
    Text reason;                 ///< reason without the file's name: equal for all images of a kind
};

/// Returns why this image's pixels cannot be decoded into numbers; none if they can.
std::optional<Refusal> refusePixels(const SliceHeader& header);

/// Returns why this image is not a readable CT slice: as refusePixels(), or localizer, unusable rescale, other
/// modality, unless that is one of volumes in HU and states HU.
std::optional<Refusal> refuseSlice(const SliceHeader& header);

}  // namespace pdr::dicom
