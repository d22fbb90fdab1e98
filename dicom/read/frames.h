#pragma once
/// The functional groups of a multi-frame image (PS3.3, C.7.6.16), which say of each frame where it lies and what its
/// values mean.

#include <vector>

#include "dicom/read/slice_header.h"

class DcmItem;

namespace pdr::dicom {

/// Returns a header for each frame that the groups of `data` describe, in the order of the file: `object`, with what
/// the groups of the frame say in its place. A group is looked for in the frame's own item, else among the shared ones;
/// what legacy converted images leave unassigned there is used where no group states it. The position is never that of
/// the object. Describes one frame more than `object` states at most; more show that the file is damaged.
std::vector<SliceHeader> readFrames(DcmItem& data, const SliceHeader& object);

}  // namespace pdr::dicom
