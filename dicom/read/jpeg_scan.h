#pragma once
/// Whether the entropy-coded data of a JPEG picture can be what an encoder wrote. Decoders of JPEG make a picture of
/// anything; here a code that does not exist, a run beyond the end of a block, a mean beyond what a sample can hold, a
/// scan that is not used up exactly by its pixels, and long runs of zero bytes that stand for a change are damage.

#include "dicom/read/jpeg_stream.h"

namespace pdr::dicom {

/// A phrase that says what is wrong, or nothing. What cannot be told from the outside (the bits that refine a
/// progressive picture, codings of no use in DICOM) is left to the decoder.
Text jpegDamage(const JpegStream& stream);

}  // namespace pdr::dicom
