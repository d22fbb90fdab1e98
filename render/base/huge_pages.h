#pragma once
/// Memory for large arrays with scattered accesses, in pages of 2 MB where the system provides them. The processor
/// caches the addresses of a few thousand pages; at 4 kB each, these cover less than a large volume.

#include <cstddef>
#include <new>
#include <vector>

namespace pdr {

/// Allocates like operator new. Throws std::bad_alloc.
void* allocateInHugePages(std::size_t bytes);
void freeHugePages(void* memory, std::size_t bytes);

template <class T>
struct HugePageAllocator {
    using value_type = T;

    HugePageAllocator() = default;
    template <class Other>
    HugePageAllocator(const HugePageAllocator<Other>&) {}

    T* allocate(std::size_t count) { return static_cast<T*>(allocateInHugePages(count * sizeof(T))); }
    /// Begins the life of a number without a value. Who makes an array writes all of it, and the system provides each
    /// page to the thread that writes to it first.
    template <class Element>
    void construct(Element* at) {
        ::new (static_cast<void*>(at)) Element;
    }
    void deallocate(T* memory, std::size_t count) { freeHugePages(memory, count * sizeof(T)); }

    bool operator==(const HugePageAllocator&) const = default;
};

/// An array whose elements have no value before they are written, unless it is made with one.
template <class T>
using HugePageVector = std::vector<T, HugePageAllocator<T>>;

}  // namespace pdr
