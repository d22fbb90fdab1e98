#pragma once
/// Errors that several modules report: each one is worded only here and has its kind.

#include <cstddef>
#include <string>

#include "render/base/result.h"

namespace pdr {

/// Returns the error of a step that was asked to stop.
inline Error cancelled() {
    return {phrase("cancelled"), "", "", ErrorKind::cancelled};
}

/// Returns a size as text: "1.5 GB", below 0.1 GB "20.0 MB".
inline Text bytesText(std::size_t bytes) {
    const double mega = double(bytes) / 1e6;
    return mega < 100 ? phrase("%1 MB", fixedNumber(mega, 1)) : phrase("%1 GB", fixedNumber(mega / 1e3, 1));
}

/// Returns the error that memory does not suffice. `purpose`: "to decode it"; may be empty.
inline Error notEnoughMemory(const Text& purpose, std::string where, Text hint) {
    return {purpose.empty() ? phrase("there is not enough memory") : phrase("there is not enough memory %1", purpose),
            std::move(where), std::move(hint), ErrorKind::memory};
}

/// Returns the error that memory does not suffice for voxels of so many bytes.
inline Error notEnoughMemoryForVoxels(std::size_t bytes, std::string where) {
    return notEnoughMemory(phrase("for its voxels (%1)", bytesText(bytes)), std::move(where),
                           phrase("Close other programs, or take a smaller volume."));
}

/// Returns the error that the memory of a device is too small. `device`: its name; `needed`, `free`: bytes.
inline Error memoryTooSmall(const std::string& device, std::size_t needed, std::size_t free) {
    return {phrase("its memory is too small: %1 are needed at a time, %2 are free", bytesText(needed), bytesText(free)),
            device, phrase("Make the image smaller, close programs that use the device, or choose another device."),
            ErrorKind::memory};
}

}  // namespace pdr
