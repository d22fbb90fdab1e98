#include "render/denoise/plane_memory.h"

#include <algorithm>
#include <vector>

#include "render/base/huge_pages.h"

namespace pdr::denoise {
namespace {

/// Smaller arrays are better kept by the heap.
constexpr std::size_t kLeastBytes = std::size_t(1) << 18;

struct Array {
    void* memory;
    std::size_t bytes;
};

/// The arrays that a thread keeps, the last one freed at the end.
class Kept {
  public:
    Kept() { arrays_.reserve(kMostKeptBytes / kLeastBytes); }  // keep() must not fail
    Kept(const Kept&) = delete;
    Kept& operator=(const Kept&) = delete;
    ~Kept() { drop(); }

    void drop() {
        for (const Array& array : arrays_)
            freeHugePages(array.memory, array.bytes);
        arrays_.clear();
        bytes_ = 0;
    }

    std::size_t bytes() const { return bytes_; }

    /// Returns an array of that size; null: there is none.
    void* take(std::size_t bytes) {
        const auto found = std::find_if(arrays_.rbegin(), arrays_.rend(),
                                        [bytes](const Array& array) { return array.bytes == bytes; });
        if (found == arrays_.rend())
            return nullptr;
        void* const memory = found->memory;
        arrays_.erase(std::next(found).base());
        bytes_ -= bytes;
        return memory;
    }

    /// Keeps an array instead of those that were freed longest ago, if it is not too large; returns whether it does.
    bool keep(const Array& array) {
        if (array.bytes > kMostKeptBytes)
            return false;
        while (bytes_ + array.bytes > kMostKeptBytes) {
            freeHugePages(arrays_.front().memory, arrays_.front().bytes);
            bytes_ -= arrays_.front().bytes;
            arrays_.erase(arrays_.begin());
        }
        arrays_.push_back(array);
        bytes_ += array.bytes;
        return true;
    }

  private:
    std::vector<Array> arrays_;
    std::size_t bytes_ = 0;
};

Kept& keptHere() {
    thread_local Kept kept;
    return kept;
}

}  // namespace

void* allocateForPlane(std::size_t bytes) {
    void* const kept = bytes >= kLeastBytes ? keptHere().take(bytes) : nullptr;
    return kept != nullptr ? kept : allocateInHugePages(bytes);
}

void freeOfPlane(void* memory, std::size_t bytes) {
    if (bytes < kLeastBytes || !keptHere().keep({memory, bytes}))
        freeHugePages(memory, bytes);
}

std::size_t keptForPlanes() {
    return keptHere().bytes();
}

void dropKeptForPlanes() {
    keptHere().drop();
}

}  // namespace pdr::denoise
