#pragma once
/// What the user reads when a GPU's memory does not suffice.

#include <cstddef>
#include <cstdio>
#include <string>

#include "render/base/result.h"

namespace pdr {

/// "1.5 GB", below 0.1 GB "20.0 MB".
inline std::string bytesText(std::size_t bytes) {
    char text[40];
    const double mega = double(bytes) / 1e6;
    std::snprintf(text, sizeof text, mega < 100 ? "%.1f MB" : "%.1f GB", mega < 100 ? mega : mega / 1e3);
    return text;
}

/// `device`: its name.
inline Error memoryTooSmall(const std::string& device, std::size_t needed, std::size_t free) {
    return {"its memory is too small: " + bytesText(needed) + " are needed at a time, " + bytesText(free) + " are free",
            device, "Make the picture smaller, close programs that use the device, or choose another device."};
}

}  // namespace pdr
