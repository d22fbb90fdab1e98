#pragma once
/// Messages on standard error that all commands share.

#include <cstdio>
#include <string>

#include "render/base/result.h"

namespace pdr::app {

/// Writes `error` to standard error and returns the exit code for it.
inline int failed(const Error& error) {
    std::fprintf(stderr, "pdrender-cli: %s\n", error.text().c_str());
    return 1;
}

/// Writes to standard error why the device "auto" does not render on a GPU, and what to do.
inline void tellOfCpu(const Error& why) {
    std::fprintf(stderr, "note: the CPU renders, since a GPU cannot: %s\n", why.text().c_str());
}

/// Writes to standard error that the GPU is being prepared.
inline void tellOfPreparation(bool begins) {
    if (begins)
        std::fputs("Preparing the GPU...\n", stderr);
}

}  // namespace pdr::app
