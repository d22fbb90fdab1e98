#pragma once
/// Memory for the lists between the kernels of paths (path_kernels.h).

#include "render/device/gpu/gpu_array.h"
#include "render/device/gpu/path_kernels.h"

namespace pdr {

template <Gpu G>
class PathListMemory {
  public:
    explicit PathListMemory(G& gpu) : gpu_(gpu) {}

    /// Returns empty lists with room for `samples` records. `onward`: whether paths continue behind their first vertex.
    PathLists emptied(std::int64_t samples, bool onward) {
        flights_.resize(std::size_t(samples));
        lit_.resize(std::size_t(samples));
        if (onward)
            onward_.resize(std::size_t(samples));
        counts_.resize(1);
        counts_.clear();
        return {flights_.data(), lit_.data(), onward_.data(), counts_.data()};
    }

  private:
    G& gpu_;
    GpuArray<G, FirstFlight> flights_{gpu_};
    GpuArray<G, LitVertex> lit_{gpu_};
    GpuArray<G, OnwardPath> onward_{gpu_};
    GpuArray<G, PathLists::Counts> counts_{gpu_};
};

}  // namespace pdr
