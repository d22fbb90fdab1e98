#pragma once
/// Arrays in a GPU's memory, and in the host's memory that a GPU copies to by itself.

#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

#include "render/device/gpu/gpu.h"

namespace pdr {

/// Success, or the error that the GPU has kept.
template <Gpu G>
Result<void> takeStatus(G& gpu) {
    if (std::optional<Error> error = gpu.takeError())
        return *std::move(error);
    return {};
}

/// Who lends an array its memory: the device, or the host, for copies that go to and from there behind its back.
struct DeviceMemory {
    static void* take(auto& gpu, std::size_t bytes) { return gpu.allocate(bytes); }
    static void give(auto& gpu, void* memory) { gpu.release(memory); }
};
struct PinnedMemory {
    static void* take(auto& gpu, std::size_t bytes) { return gpu.allocatePinned(bytes); }
    static void give(auto& gpu, void* memory) { gpu.releasePinned(memory); }
};

/// `count` values; not set. The GPU must outlive it. Null after an error.
template <Gpu G, class T, class Memory = DeviceMemory>
class GpuArray {
    static_assert(std::is_trivially_copyable_v<T>);
    static constexpr bool kOnDevice = std::is_same_v<Memory, DeviceMemory>;

  public:
    explicit GpuArray(G& gpu, std::size_t count = 0) : gpu_(gpu) { resize(count); }
    ~GpuArray() { Memory::give(gpu_, data_); }
    GpuArray(const GpuArray&) = delete;
    GpuArray& operator=(const GpuArray&) = delete;

    T* data() const { return data_; }
    std::size_t size() const { return count_; }

    /// What was there is lost. Memory is taken anew only where there is too little; nothing may be on its way to it.
    void resize(std::size_t count) {
        if (count > room_) {
            free();
            data_ = static_cast<T*>(Memory::take(gpu_, count * sizeof(T)));
            room_ = data_ != nullptr ? count : 0;
        }
        count_ = data_ != nullptr ? count : 0;
    }
    void free() {
        Memory::give(gpu_, std::exchange(data_, nullptr));
        room_ = count_ = 0;
    }

    /// From and to host memory, in the order of the compute stream.
    void assign(std::span<const T> values) requires kOnDevice {
        resize(values.size());
        copyFrom(values.data());
    }
    void copyFrom(const T* host) requires kOnDevice {
        gpu_.copyToDevice(data_, host, count_ * sizeof(T), GpuStream::compute);
    }
    void copyTo(T* host) const requires kOnDevice {
        gpu_.copyToHost(host, data_, count_ * sizeof(T), GpuStream::compute);
    }
    void clear() requires kOnDevice { gpu_.clear(data_, count_ * sizeof(T), GpuStream::compute); }

  private:
    G& gpu_;
    T* data_ = nullptr;
    std::size_t count_ = 0, room_ = 0;
};

template <Gpu G, class T>
using PinnedArray = GpuArray<G, T, PinnedMemory>;

/// A table that is sent again only where it differs from what was sent last, and without the host waiting for it.
template <Gpu G, class T>
class GpuTable {
  public:
    explicit GpuTable(G& gpu) : gpu_(gpu), array_(gpu), sent_(gpu) {}

    const T* data() const { return array_.data(); }

    void update(std::span<const T> values) {
        if (values.size() == sent_.size() &&
            (values.empty() || std::memcmp(sent_.data(), values.data(), values.size_bytes()) == 0))
            return;
        gpu_.await(arrived_);
        sent_.resize(values.size());
        array_.resize(values.size());
        if (sent_.size() == 0)
            return;
        std::memcpy(sent_.data(), values.data(), values.size_bytes());
        array_.copyFrom(sent_.data());
        gpu_.record(arrived_, GpuStream::compute);
    }
    /// Whatever comes next is sent: after an error nobody knows what is there.
    void forget() { sent_.resize(0); }

  private:
    G& gpu_;
    GpuArray<G, T> array_;
    PinnedArray<G, T> sent_;
    typename G::Event arrived_{};  ///< what was sent last
};

}  // namespace pdr
