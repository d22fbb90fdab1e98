#pragma once
/// What tests/mutations/run writes around a piece of source: planted(NUMBER) ? (the bug) : (what was there).

#include <cstdlib>

namespace pdr {

/// The number of the bug that PDR_PLANTED names; 0: none.
inline const unsigned long kPlanted = [] {
    const char* number = std::getenv("PDR_PLANTED");
    return number ? std::strtoul(number, nullptr, 10) : 0;
}();

inline bool planted(unsigned long bug) {
    return kPlanted == bug;
}

}  // namespace pdr
