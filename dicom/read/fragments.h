#pragma once
/// The fragments of compressed pixel data, and the frame that each belongs to (PS3.5, A.4).

#include <cstdint>
#include <vector>

#include "dicom/read/byte_source.h"

namespace pdr::dicom {

/// A run of bytes of an object.
struct Fragment {
    std::uint64_t at = 0;     ///< offset of its first byte
    std::uint32_t bytes = 0;  ///< its length
};

/// What compressed pixel data consist of.
struct FragmentList {
    std::vector<std::uint32_t> offsets;  ///< the basic offset table; empty: none is stated
    std::vector<Fragment> fragments;     ///< in the order of the file
};

/// Returns the fragments of the pixel data that begin at `at`; the structure of `source` must have been checked.
FragmentList readFragments(ByteSource& source, std::uint64_t at);

/// Returns the fragments of each of `frames` frames. As many fragments as frames are one each; else an offset table
/// says where frames begin or, if it is none or wrong, the markers that JPEG and JPEG 2000 streams begin with. Extended
/// Offset Tables are not needed: their frames are one fragment each. Empty if nothing gives that number of frames.
std::vector<std::vector<Fragment>> fragmentsOfFrames(ByteSource& source, const FragmentList& list, int frames);

}  // namespace pdr::dicom
