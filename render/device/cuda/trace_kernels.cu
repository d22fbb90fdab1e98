/// Instantiates the path kernels. Compiled once for each PDR_FIRST_MASK: 0, 8, 16, 24.

#include "render/device/cuda/trace_kernels.h"

#include <utility>

namespace pdr {

namespace {

template <std::uint32_t First, std::size_t... Masks>
std::array<TraceLaunch<CudaGpu>, kMasksPerFile> launches(std::index_sequence<Masks...>) {
    return {launchPaths<CudaGpu, First + std::uint32_t(Masks)>...};
}

}  // namespace

template <>
std::array<TraceLaunch<CudaGpu>, kMasksPerFile> pathLaunchesFrom<PDR_FIRST_MASK>() {
    return launches<PDR_FIRST_MASK>(std::make_index_sequence<kMasksPerFile>());
}

}  // namespace pdr
