#pragma once
/// A volume as a texture of a GPU.

#include <utility>

#include "render/device/gpu/gpu.h"

namespace pdr {

/// A texture of a volume; empty at first. The GPU must outlive it.
template <Gpu G>
class GpuTexture {
  public:
    explicit GpuTexture(G& gpu) : gpu_(gpu) {}
    ~GpuTexture() { free(); }
    GpuTexture(const GpuTexture&) = delete;
    GpuTexture& operator=(const GpuTexture&) = delete;

    /// Returns the value for FlatVolume::texture; 0: there is none.
    std::uint64_t handle() const { return handle_; }

    static std::size_t bytesFor(ivec3 voxels) {
        return std::size_t(voxels.x) * voxels.y * voxels.z * sizeof(std::int16_t);
    }
    /// Makes the texture of a volume in host memory, in the order of the compute stream. There is none after an error.
    void make(const std::int16_t* voxels, ivec3 size) {
        free();
        handle_ = gpu_.makeTexture(voxels, size);
    }
    void free() { gpu_.releaseTexture(std::exchange(handle_, 0)); }

  private:
    G& gpu_;
    std::uint64_t handle_ = 0;
};

}  // namespace pdr
