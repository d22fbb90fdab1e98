#pragma once
/// Arrays in a GPU's memory, and in host memory for asynchronous copies.

#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

#include "render/device/gpu/gpu.h"

namespace pdr {

/// Returns success, or the error that the GPU has stored.
template <Gpu G>
Result<void> takeStatus(G& gpu) {
    if (std::optional<Error> error = gpu.takeError())
        return *std::move(error);
    return {};
}

/// Allocators of an array: device memory, or host memory for asynchronous copies.
struct DeviceMemory {
    static void* take(auto& gpu, std::size_t bytes) { return gpu.allocate(bytes); }
    static void give(auto& gpu, void* memory) { gpu.release(memory); }
};
struct PinnedMemory {
    static void* take(auto& gpu, std::size_t bytes) { return gpu.allocatePinned(bytes); }
    static void give(auto& gpu, void* memory) { gpu.releasePinned(memory); }
};

/// An array of `count` values, uninitialized. The GPU must outlive it. data() is null after an error.
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

    /// Resizes the array; its content is lost. Memory is allocated anew only if there is too little; no copy to it may
    /// be under way.
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

    /// Copy from and to host memory, in the order of the compute stream.
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

/// A table that is sent only if it differs from the one sent last; the host does not wait for it.
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
    /// Makes the next update() send its table in any case: after an error it is unknown what the device holds.
    void forget() { sent_.resize(0); }

  private:
    G& gpu_;
    GpuArray<G, T> array_;
    PinnedArray<G, T> sent_;
    typename G::Event arrived_{};  ///< end of the last copy
};

}  // namespace pdr
