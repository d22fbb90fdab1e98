#include "tests/ptx/base/findings.h"

#include <cstdio>

namespace pdr::ptx {

void Findings::tell(const std::string& text) {
    if (told_.insert(text).second)
        std::fprintf(stderr, "ptx: %s\n", text.c_str());
}

}  // namespace pdr::ptx
