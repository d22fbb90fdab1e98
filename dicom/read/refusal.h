#pragma once
/// Which single images are no CT slice that this program can read, and why.

#include <optional>

#include "dicom/read/slice_header.h"

namespace pdr::dicom {

/// The largest rows and columns taken [pixels]; real CT has up to 2048.
inline constexpr int kMaxSide = 8192;

struct Refusal {
    Stack stack = Stack::notCt;  ///< notCt or unreadable
    Text reason;                 ///< without the file's name: equal for all images of a kind
};

/// Why this image's pixels cannot be decoded into numbers; nothing if they can.
std::optional<Refusal> refusePixels(const SliceHeader& header);

/// The same, and everything that is no CT slice: other modalities, colour, localizers.
std::optional<Refusal> refuseSlice(const SliceHeader& header);

}  // namespace pdr::dicom
