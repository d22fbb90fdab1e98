#include "render/base/huge_pages.h"

#include <sys/mman.h>

namespace pdr {

namespace {

constexpr std::size_t kHugePage = std::size_t(2) << 20;

/// Returns whether an array is large enough for huge pages. In smaller ones, up to half a page would be wasted on each.
bool usesHugePages(std::size_t bytes) {
    return bytes >= 2 * kHugePage;
}

}  // namespace

void* allocateInHugePages(std::size_t bytes) {
    if (!usesHugePages(bytes))
        return ::operator new(bytes);
    void* memory = ::operator new(bytes, std::align_val_t(kHugePage));
    // This is a request: if the system does not grant it, everything works as well.
    madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
    return memory;
}

void freeHugePages(void* memory, std::size_t bytes) {
    if (usesHugePages(bytes))
        ::operator delete(memory, std::align_val_t(kHugePage));
    else
        ::operator delete(memory);
}

}  // namespace pdr
