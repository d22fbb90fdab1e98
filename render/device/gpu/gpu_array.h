#pragma once
/// Arrays in a GPU's memory, and in the host's memory that a GPU copies to by itself.

#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "render/device/gpu/gpu.h"

namespace pdr {

/// Success, or the error that the GPU has kept.
template <Gpu G>
Result<void> takeStatus(G& gpu) {
    if (std::optional<Error> error = gpu.takeError())
        return *std::move(error);
    return {};
}

/// `count` values in device memory; not set. The GPU must outlive it. Null after an error.
template <Gpu G, class T>
class GpuArray {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    explicit GpuArray(G& gpu, std::size_t count = 0) : gpu_(&gpu) { resize(count); }
    ~GpuArray() { gpu_->release(data_); }
    GpuArray(const GpuArray&) = delete;
    GpuArray& operator=(const GpuArray&) = delete;

    T* data() const { return data_; }
    std::size_t size() const { return count_; }

    /// What was there is lost. Memory is taken anew only where there is too little.
    void resize(std::size_t count) {
        if (count > room_) {
            gpu_->release(std::exchange(data_, nullptr));
            room_ = 0;
            data_ = static_cast<T*>(gpu_->allocate(count * sizeof(T)));
            room_ = data_ != nullptr ? count : 0;
        }
        count_ = data_ != nullptr ? count : 0;
    }
    void free() {
        gpu_->release(std::exchange(data_, nullptr));
        room_ = count_ = 0;
    }
    void assign(std::span<const T> values) {
        resize(values.size());
        copyFrom(values.data());
    }
    void copyFrom(const T* host) { gpu_->copyToDevice(data_, host, count_ * sizeof(T), GpuStream::compute); }
    void copyTo(T* host) const { gpu_->copyToHost(host, data_, count_ * sizeof(T), GpuStream::compute); }
    void clear() { gpu_->clear(data_, count_ * sizeof(T), GpuStream::compute); }

  private:
    G* gpu_;
    T* data_ = nullptr;
    std::size_t count_ = 0, room_ = 0;
};

/// A table that is sent again only where it differs from what was sent last.
template <Gpu G, class T>
class GpuTable {
  public:
    explicit GpuTable(G& gpu) : array_(gpu) {}

    const T* data() const { return array_.data(); }

    void update(std::span<const T> values) {
        const bool same = sent_.size() == values.size() &&
                          (values.empty() || std::memcmp(sent_.data(), values.data(), values.size_bytes()) == 0);
        if (same)
            return;
        sent_.assign(values.begin(), values.end());
        array_.assign(sent_);
    }
    /// Whatever comes next is sent: after an error nobody knows what is there.
    void forget() { sent_.clear(); }

  private:
    GpuArray<G, T> array_;
    std::vector<T> sent_;
};

/// `count` bytes of host memory that copies go to behind the host's back.
template <Gpu G>
class PinnedBytes {
  public:
    PinnedBytes(G& gpu, std::size_t count) : gpu_(gpu) { resize(count); }
    ~PinnedBytes() { gpu_.releasePinned(data_); }
    PinnedBytes(const PinnedBytes&) = delete;
    PinnedBytes& operator=(const PinnedBytes&) = delete;

    std::byte* data() const { return data_; }

    /// What was there is lost. Memory is taken anew only where there is too little; nothing may be on its way to it.
    void resize(std::size_t count) {
        if (count <= room_)
            return;
        gpu_.releasePinned(std::exchange(data_, nullptr));
        data_ = static_cast<std::byte*>(gpu_.allocatePinned(count));
        room_ = data_ != nullptr ? count : 0;
    }

  private:
    G& gpu_;
    std::byte* data_ = nullptr;
    std::size_t room_ = 0;
};

}  // namespace pdr
