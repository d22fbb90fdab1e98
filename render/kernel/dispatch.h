#pragma once
/// The one table from a feature mask to the code compiled for it.

#include <array>
#include <utility>

#include "render/kernel/pixel.h"

namespace pdr {

/// Samples one row of a tile: pixels [x, x + width) of row y, `sums` at the first.
using RowKernel = void (*)(const FlatScene& scene, int x, int width, int y, SampleRange samples, PixelSums* sums);

template <std::uint32_t F>
void renderRow(const FlatScene& scene, int x, int width, int y, SampleRange samples, PixelSums* sums) {
    for (int i = 0; i < width; ++i)
        renderPixel<F>(scene, {x + i, y}, samples, sums[i]);
}

template <std::size_t... Masks>
constexpr std::array<RowKernel, sizeof...(Masks)> rowKernels(std::index_sequence<Masks...>) {
    return {&renderRow<std::uint32_t(Masks)>...};
}

inline constexpr std::array<RowKernel, kFeatureMasks> kRowKernels =
    rowKernels(std::make_index_sequence<kFeatureMasks>());

}  // namespace pdr
