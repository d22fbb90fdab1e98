#pragma once
/// A row of values in the memory of a Gpu, released with its owner.

#include <cstddef>
#include <type_traits>
#include <utility>

#include "render/device/gpu/gpu.h"

namespace pdr {

/// Data is null after an error; the Gpu keeps it. All copies go by the compute stream.
template <Gpu G, class T>
class GpuBuffer {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    GpuBuffer() = default;
    /// Its values are not yet set. `gpu` must outlive it.
    GpuBuffer(G& gpu, std::size_t count)
        : gpu_(&gpu), data_(static_cast<T*>(gpu.allocate(count * sizeof(T)))), count_(count) {}
    GpuBuffer(GpuBuffer&& other) noexcept
        : gpu_(other.gpu_), data_(std::exchange(other.data_, nullptr)), count_(std::exchange(other.count_, 0)) {}
    GpuBuffer& operator=(GpuBuffer&& other) noexcept {
        std::swap(gpu_, other.gpu_);
        std::swap(data_, other.data_);
        std::swap(count_, other.count_);
        return *this;
    }
    ~GpuBuffer() {
        if (data_ != nullptr)
            gpu_->release(data_);
    }

    T* data() const { return data_; }
    std::size_t count() const { return count_; }

    /// All values, of as many at `host`.
    void set(const T* host) { gpu_->copyToDevice(data_, host, count_ * sizeof(T), GpuStream::compute); }
    void get(T* host) const { gpu_->copyToHost(host, data_, count_ * sizeof(T), GpuStream::compute); }
    void clear() { gpu_->clear(data_, count_ * sizeof(T), GpuStream::compute); }

  private:
    G* gpu_ = nullptr;
    T* data_ = nullptr;
    std::size_t count_ = 0;
};

}  // namespace pdr
