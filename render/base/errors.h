#pragma once
/// Errors that more than one room reports: each is worded here, once, and has its kind.

#include <cstddef>
#include <cstdio>
#include <string>

#include "render/base/result.h"

namespace pdr {

/// A step that was asked to stop has ended.
inline Error cancelled() {
    return {"cancelled", "", "", ErrorKind::cancelled};
}

/// "1.5 GB", below 0.1 GB "20.0 MB".
inline std::string bytesText(std::size_t bytes) {
    char text[40];
    const double mega = double(bytes) / 1e6;
    std::snprintf(text, sizeof text, mega < 100 ? "%.1f MB" : "%.1f GB", mega < 100 ? mega : mega / 1e3);
    return text;
}

/// `purpose`: " to decode it"; may be empty.
inline Error notEnoughMemory(const std::string& purpose, std::string where, std::string hint) {
    return {"there is not enough memory" + purpose, std::move(where), std::move(hint), ErrorKind::memory};
}

/// Of a device. `device`: its name.
inline Error memoryTooSmall(const std::string& device, std::size_t needed, std::size_t free) {
    return {"its memory is too small: " + bytesText(needed) + " are needed at a time, " + bytesText(free) + " are free",
            device, "Make the picture smaller, close programs that use the device, or choose another device.",
            ErrorKind::memory};
}

}  // namespace pdr
