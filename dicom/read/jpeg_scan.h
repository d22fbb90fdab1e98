#pragma once
/// Checks whether the entropy-coded data of a JPEG image can come from an encoder. JPEG decoders make an image of
/// anything; here, a code that does not exist, a run beyond the end of a block, a mean beyond what a sample can hold, a
/// scan that is not used up exactly by its pixels, and long runs of zero bytes that stand for a change are damage.

#include "dicom/read/jpeg_stream.h"

namespace pdr::dicom {

/// Returns the damage as a phrase; empty if there is none. What cannot be seen from the outside (the bits that refine a
/// progressive image, codings of no use in DICOM) is left to the decoder.
Text jpegDamage(const JpegStream& stream);

}  // namespace pdr::dicom
