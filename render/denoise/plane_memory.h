#pragma once
/// Memory for the values of planes. Filters make and drop dozens of planes of one size, and new pages from the system
/// take longer than most filters do; so a thread keeps what its planes leave, for its next ones.

#include <cstddef>
#include <new>

namespace pdr::denoise {

/// Most memory that a thread keeps.
inline constexpr std::size_t kMostKeptBytes = std::size_t(32) << 20;

/// Throws std::bad_alloc.
void* allocateForPlane(std::size_t bytes);
void freeOfPlane(void* memory, std::size_t bytes);
/// Returns the memory that this thread keeps.
std::size_t keptForPlanes();
/// Returns what this thread keeps to the system, so that nothing is left of an image that is closed.
void dropKeptForPlanes();

template <class T>
struct PlaneAllocator {
    using value_type = T;

    PlaneAllocator() = default;
    template <class Other>
    PlaneAllocator(const PlaneAllocator<Other>&) {}

    T* allocate(std::size_t count) { return static_cast<T*>(allocateForPlane(count * sizeof(T))); }
    /// Begins the life of a number without a value; see Plane::unset().
    template <class Element>
    void construct(Element* at) {
        ::new (static_cast<void*>(at)) Element;
    }
    void deallocate(T* memory, std::size_t count) { freeOfPlane(memory, count * sizeof(T)); }

    bool operator==(const PlaneAllocator&) const = default;
};

}  // namespace pdr::denoise
