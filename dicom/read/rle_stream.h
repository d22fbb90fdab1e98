#pragma once
/// Whether a picture in DICOM's run-length coding (PS3.5, annex G) can be what an encoder wrote. A decoder makes a
/// picture of anything; here each segment must give exactly one byte of every pixel and end where the next begins, and
/// what repeats must be coded as a run, as the standard asks.

#include <cstdint>
#include <span>

#include "render/base/text.h"

namespace pdr::dicom {

/// A phrase that says what is wrong, or nothing. `segments`: bytes a pixel.
Text rleDamage(std::span<const std::uint8_t> stream, std::size_t pixels, int segments);

}  // namespace pdr::dicom
