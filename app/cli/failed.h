#pragma once
/// How every command ends on an error.

#include <cstdio>

#include "render/base/result.h"

namespace pdr::app {

/// Says `error` on standard error and returns the exit code for it.
inline int failed(const Error& error) {
    std::fprintf(stderr, "pdrender-cli: %s\n", error.text().c_str());
    return 1;
}

}  // namespace pdr::app
