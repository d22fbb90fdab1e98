#pragma once
/// Checks whether an image in DICOM's run-length coding (PS3.5, annex G) can come from an encoder. A decoder makes an
/// image of anything; here, each segment must give exactly one byte of every pixel and end where the next begins, and
/// repeated bytes must be coded as a run, as the standard demands.

#include <cstdint>
#include <span>

#include "render/base/text.h"

namespace pdr::dicom {

/// Returns the damage as a phrase; empty if there is none. `segments`: bytes per pixel.
Text rleDamage(std::span<const std::uint8_t> stream, std::size_t pixels, int segments);

}  // namespace pdr::dicom
