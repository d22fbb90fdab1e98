#include "render/base/huge_pages.h"

#include <sys/mman.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace pdr {

namespace {

constexpr std::size_t kHugePage = std::size_t(2) << 20;

/// Returns whether an array is large enough for huge pages. In smaller ones, up to half a page would be wasted on each.
bool usesHugePages(std::size_t bytes) {
    return bytes >= 2 * kHugePage;
}

/// Writes to each page, on all cores. The system clears a page when it is first written, which takes longer than what
/// is then done with it, and would fall to the one thread that sets up the array.
void touchPages(std::byte* memory, std::size_t bytes) {
    constexpr std::size_t kPage = 4096, kTogether = 16 * kHugePage / kPage;
    const auto touch = [&](const tbb::blocked_range<std::size_t>& part) {
        for (std::size_t page = part.begin(); page < part.end(); ++page)
            memory[page * kPage] = std::byte(0);
    };
    // Isolated: a caller that holds a lock must not be given other work meanwhile, which may wait for that lock.
    tbb::this_task_arena::isolate(
        [&] { tbb::parallel_for(tbb::blocked_range<std::size_t>(0, bytes / kPage, kTogether), touch); });
}

}  // namespace

void* allocateInHugePages(std::size_t bytes) {
    if (!usesHugePages(bytes))
        return ::operator new(bytes);
    void* memory = ::operator new(bytes, std::align_val_t(kHugePage));
    // This is a request: if the system does not grant it, everything works as well.
    madvise(memory, bytes / kHugePage * kHugePage, MADV_HUGEPAGE);
    touchPages(static_cast<std::byte*>(memory), bytes);
    return memory;
}

void freeHugePages(void* memory, std::size_t bytes) {
    if (usesHugePages(bytes))
        ::operator delete(memory, std::align_val_t(kHugePage));
    else
        ::operator delete(memory);
}

}  // namespace pdr
