#pragma once
/// Parses an object with the DICOM toolkit, in a file or in memory.

#include "dicom/go_on.h"
#include "dicom/read/slice_header.h"
#include "render/base/named_bytes.h"

class DcmFileFormat;

namespace pdr::dicom {

/// The part of an object that is parsed.
enum class Extent {
    header,  ///< everything before the pixel data
    all,
};

/// Fills `content` from the bytes of `object`, whose structure must have been checked; `header` states its coding
/// (hasMetaHeader, transferSyntaxUid). False if the toolkit stopped before the end of `extent`; `content` then holds
/// what it had parsed. It also stops soon after `goOn` returns false, which is asked for each few bytes. Thread-safe.
bool parseObject(const NamedBytes& object, const SliceHeader& header, Extent extent, DcmFileFormat& content,
                 const GoOn& goOn = always);

}  // namespace pdr::dicom
