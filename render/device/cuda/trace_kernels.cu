/// Instantiates the path kernels. Compiled once for each PDR_FIRST_MASK: 0, 8, 16, 24.

#include "render/device/cuda/trace_kernels.h"

#include <utility>

namespace pdr {

namespace {

template <std::uint32_t F>
PathProgram programOf() {
    std::vector<const void*> kernels = kernelsOf<ShadeKernel<F>>();
    if constexpr (has(F, kBounces))
        kernels.push_back(queuedKernelsOf<OnwardKernel<F>>().front());
    return {launchPaths<CudaGpu, F>, kernels};
}

template <std::uint32_t First, std::size_t... Masks>
std::array<PathProgram, kMasksPerFile> programs(std::index_sequence<Masks...>) {
    return {programOf<First + std::uint32_t(Masks)>()...};
}

}  // namespace

template <>
std::array<PathProgram, kMasksPerFile> pathProgramsFrom<PDR_FIRST_MASK>() {
    return programs<PDR_FIRST_MASK>(std::make_index_sequence<kMasksPerFile>());
}

}  // namespace pdr
