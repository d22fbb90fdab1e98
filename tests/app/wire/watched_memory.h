#pragma once
/// Watches what a test program takes by operator new, and what it leaves behind. For one file of a program only.

#include <malloc.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <new>
#include <span>

namespace pdr::test {

struct WatchedMemory {
    std::atomic<std::size_t> live = 0, peak = 0;     ///< bytes
    std::atomic<const std::byte*> secret = nullptr;  ///< kSecretBytes that no memory may hold when it is given back
    std::atomic<int> leaks = 0;                      ///< times that some did
    static constexpr std::size_t kSecretBytes = 16;

    void taken(std::size_t bytes) {
        const std::size_t now = live += bytes;
        for (std::size_t before = peak; before < now && !peak.compare_exchange_weak(before, now);) {
        }
    }
    void given(const void* memory, std::size_t bytes) {
        live -= bytes;
        if (const std::byte* wanted = secret;
            wanted != nullptr && memmem(memory, bytes, wanted, kSecretBytes) != nullptr)
            ++leaks;
    }
};
inline WatchedMemory watched;

/// The most memory that `work` has held at once, beyond what was held before [bytes].
template <class Work>
std::size_t mostHeldBy(Work&& work) {
    const std::size_t before = watched.live;
    watched.peak = before;
    work();
    return watched.peak - before;
}

}  // namespace pdr::test

void* operator new(std::size_t bytes) {
    void* memory = std::malloc(std::max<std::size_t>(bytes, 1));
    if (memory == nullptr)
        throw std::bad_alloc();
    pdr::test::watched.taken(malloc_usable_size(memory));
    return memory;
}
void operator delete(void* memory) noexcept {
    if (memory != nullptr)
        pdr::test::watched.given(memory, malloc_usable_size(memory));
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    operator delete(memory);
}
