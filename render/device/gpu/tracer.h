#pragma once
/// Launches of samples: the one table from what a scene calls for to the program compiled for it.

#include <array>
#include <utility>

#include "render/device/gpu/gpu.h"
#include "render/device/gpu/trace_kernels.h"

namespace pdr {

template <Gpu G, class Take>
void launchTrace(G& gpu, const FlatScene& scene, const TraceTarget& target) {
    gpu.launchQueued(TraceKernel<Take>{scene, target}, target.grid.count(), GpuStream::compute);
}

template <Gpu G>
using TraceLaunch = void (*)(G& gpu, const FlatScene& scene, const TraceTarget& target);

/// The program for a scene that calls for `needed`: effects that are not told apart are always in it, and change
/// nothing where they are not called for.
constexpr std::uint32_t compiledMask(std::uint32_t specialized, std::uint32_t needed) {
    return (needed & specialized) | ((kFeatureMasks - 1) & ~specialized);
}

template <Gpu G, std::size_t... Masks>
constexpr std::array<TraceLaunch<G>, sizeof...(Masks)> pathLaunches(std::index_sequence<Masks...>) {
    return {launchTrace<G, PathSampler<compiledMask(G::kSpecializedFeatures, std::uint32_t(Masks))>>...};
}

/// The program for paths that need these effects. Specialised where the compiler takes long over them: cuda/.
template <Gpu G>
TraceLaunch<G> pathLaunch(std::uint32_t needed) {
    static constexpr auto kPaths = pathLaunches<G>(std::make_index_sequence<kFeatureMasks>());
    return kPaths[needed];
}

template <Gpu G>
TraceLaunch<G> traceLaunchFor(const FlatScene& scene) {
    switch (scene.optics.model) {
        case FlatModel::absorption:
            return launchTrace<G, ProjectionSampler<FlatModel::absorption>>;
        case FlatModel::emission:
            return launchTrace<G, ProjectionSampler<FlatModel::emission>>;
        case FlatModel::emissionAbsorption:
            return launchTrace<G, ProjectionSampler<FlatModel::emissionAbsorption>>;
        case FlatModel::maximumIntensity:
            return launchTrace<G, ProjectionSampler<FlatModel::maximumIntensity>>;
        case FlatModel::scattering:
            break;
    }
    return scene.marched ? launchTrace<G, MarchSampler> : pathLaunch<G>(scene.features);
}

/// Takes the samples of `target` and adds them to `sums` and `moments`. In the compute stream.
template <Gpu G>
void traceAndAdd(G& gpu, const FlatScene& scene, const TraceTarget& target, PixelSums* sums, Moments* moments) {
    traceLaunchFor<G>(scene)(gpu, scene, target);
    gpu.launch(AccumulateKernel{target, scene.camera.film.x, sums, moments}, target.grid.pixels(), GpuStream::compute);
}

}  // namespace pdr
