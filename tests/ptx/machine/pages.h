#pragma once
/// Address space that takes memory only where it is touched.

#include <sys/mman.h>

#include "tests/ptx/base/findings.h"
#include "tests/ptx/base/numbers.h"

namespace pdr::ptx {

inline constexpr u64 kPage = 4096;  ///< bytes

/// Returns room for `count` zeros, which stays until the program ends. Throws NotKnown where the system refuses.
template <class T>
T* reserve(u64 count, int protection = PROT_READ | PROT_WRITE) {
    void* pages = mmap(nullptr, count * sizeof(T), protection, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (pages == MAP_FAILED)
        throw NotKnown("no address space for the device's memory");
    return static_cast<T*>(pages);
}

}  // namespace pdr::ptx
