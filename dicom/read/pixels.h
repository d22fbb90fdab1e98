#pragma once
/// Decodes slices into Hounsfield units.

#include <cstdint>
#include <filesystem>
#include <vector>

#include "dicom/import.h"
#include "dicom/read/slice_header.h"
#include "render/base/named_bytes.h"

namespace pdr::dicom {

struct DecodedSlice {
    ivec2 size{0};                 ///< columns, rows
    std::vector<std::int16_t> hu;  ///< x fastest; rounded and clamped to int16
    std::size_t clipped = 0;       ///< number of pixels whose HU lie outside int16
    bool hasLost = false;          ///< whether the coding has lost something, and the header does not say so
    bool isMended = false;         ///< whether a wrong length in the coding was put right
    SliceIdentity identity;        ///< what the file said when its pixels were read
    ValueRanges ranges;            ///< those of `hu`
    /// That of the values, before they were rounded and clamped, without padding; only of pixels that are
    /// floating-point numbers or have more than 16 bits.
    ValueRange values = ValueRange::none();
    std::vector<std::uint8_t> padding;  ///< 1 = nothing measured; empty if there is no such pixel
};

/// Returns the error of an `object` whose bytes are damaged.
Error damagedObject(const NamedBytes& object, Text what);

/// Returns the error of a `file` that is no longer the one that was scanned.
Error changedFile(const std::filesystem::path& file);

/// Decodes the only image of `object`, whose header has been read, or one frame of it that is not compressed. Errors:
/// damaged. Thread-safe.
Result<DecodedSlice> decodePixels(const NamedBytes& object, const SliceHeader& header, Padding padding);
Result<DecodedSlice> decodePlainFrame(const NamedBytes& object, const SliceHeader& frame, Padding padding);

/// Decodes a frame of `object`; the errors are those of ImageFile. Thread-safe.
Result<DecodedSlice> decodeSlice(const NamedBytes& object, Padding padding, int frame = 0);

/// Decodes `slice` of `series`, which comes from a scan, into voxels of its unit. Errors: those of SeriesSource::open()
/// and of the decoding.
Result<DecodedSlice> decodeSlice(const Series& series, const SliceRef& slice, Padding padding);

}  // namespace pdr::dicom
