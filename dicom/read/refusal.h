#pragma once
/// Decides which images are no slices that this program can read, and why, and which are in Hounsfield units.

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

/// Returns whether the pixels of an image stand for Hounsfield units. CT does unless it states another unit (Rescale
/// Type, PS3.3, C.8.2.1.1) or quantity; where it states no rescale, only numbers with a sign can be HU. Of other
/// modalities OT and XA do if they say so. When in doubt, they do not.
bool isInHu(const SliceHeader& header);

/// Returns why this image is not a readable slice of a volume: as refusePixels(), or localizer, unusable rescale, other
/// modality without a place, or values that are no HU and of more than 16 bits.
std::optional<Refusal> refuseSlice(const SliceHeader& header);

}  // namespace pdr::dicom
