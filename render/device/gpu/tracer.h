#pragma once
/// Launches of samples: the only table from what a scene needs to the program compiled for it.

#include <algorithm>
#include <array>
#include <utility>

#include "render/device/gpu/gpu.h"
#include "render/device/gpu/path_kernels.h"
#include "render/device/gpu/path_lists.h"

namespace pdr {

/// A function that takes the samples of `target`, in the compute stream.
template <Gpu G>
using TraceLaunch = void (*)(G& gpu, const FlatScene& scene, const TraceTarget& target, PathListMemory<G>& lists);

/// Calls launch(first, count) for parts of [0, all) of at most `most` each. One launch for a very large film would take
/// seconds; drivers end what keeps a display waiting so long.
template <class Launch>
void inParts(std::int64_t all, std::int64_t most, const Launch& launch) {
    for (std::int64_t first = 0; first < all; first += most)
        launch(first, std::min(all - first, most));
}

/// Returns how many rays a launch traces at most where a ray needs no memory of its own.
template <Gpu G>
std::int64_t raysTogether(const G& gpu) {
    return 16 * gpu.pathsTogether();
}

template <Gpu G, class Take>
void launchTrace(G& gpu, const FlatScene& scene, const TraceTarget& target, PathListMemory<G>&) {
    inParts(target.grid.count(), raysTogether(gpu), [&](std::int64_t first, std::int64_t rays) {
        gpu.launchQueued(TraceKernel<Take>{scene, target, first}, rays, GpuStream::compute);
    });
}

/// Launch the path kernels that are the same for all effects. They are specialized where the compiler takes long over
/// them: cuda/.
template <Gpu G, Tissue Kind, ThinTissue Thin>
void launchCamera(G& gpu, const CameraKernel<Kind, Thin>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}
template <Gpu G, Tissue Kind, ThinTissue Thin>
void launchShadow(G& gpu, const ShadowKernel<Kind, Thin>& kernel, std::int64_t lightPaths) {
    gpu.launchQueued(kernel, lightPaths, GpuStream::compute);
}
template <Gpu G>
void launchAddLight(G& gpu, const AddLightKernel& kernel, std::int64_t samples) {
    gpu.launch(kernel, samples, GpuStream::compute);
}

/// Launches all kernels of paths. Kind: that of the scene's tissue; Thin, Light: how flights of the camera and of light
/// pass thin tissue.
template <Gpu G, std::uint32_t F, Tissue Kind, ThinTissue Thin, ThinTissue Light>
void launchPathsOf(G& gpu, const FlatScene& scene, const TraceTarget& target, PathListMemory<G>& memory) {
    const bool onward = has(F, kBounces) && scene.maxBounces > 1;
    inParts(target.grid.count(), gpu.pathsTogether(), [&](std::int64_t first, std::int64_t samples) {
        const PathLists lists = memory.emptied(samples, onward);
        launchCamera(gpu, CameraKernel<Kind, Thin>{scene, target, lists, first}, samples);
        gpu.launch(ShadeKernel<F>{scene, target, lists}, samples, GpuStream::compute);
        launchShadow(gpu, ShadowKernel<Kind, Light>{scene, lists}, samples * kMostEvents);
        launchAddLight(gpu, AddLightKernel{target, lists}, samples);
        if constexpr (has(F, kBounces))
            if (onward)
                gpu.launchQueued(OnwardKernel<F>{scene, target, lists}, samples, GpuStream::compute);
    });
}

template <Gpu G, std::uint32_t F, Tissue Kind>
void launchPaths(G& gpu, const FlatScene& scene, const TraceTarget& target, PathListMemory<G>& memory) {
    using enum ThinTissue;
    if (scene.looksAtThin && scene.lightLooks)
        launchPathsOf<G, F, Kind, looked, allLooked>(gpu, scene, target, memory);
    else if (scene.lightLooks)
        launchPathsOf<G, F, Kind, solved, allLooked>(gpu, scene, target, memory);
    else if (scene.looksAtThin)
        launchPathsOf<G, F, Kind, looked, looked>(gpu, scene, target, memory);
    else
        launchPathsOf<G, F, Kind, solved, solved>(gpu, scene, target, memory);
}

template <Gpu G, std::uint32_t F>
void launchPaths(G& gpu, const FlatScene& scene, const TraceTarget& target, PathListMemory<G>& memory) {
    forTissue(scene, [&]<Tissue Kind>() { launchPaths<G, F, Kind>(gpu, scene, target, memory); });
}

/// Returns the mask of the program for a scene that needs `needed`. Effects that are not specialized are always in it,
/// and change nothing where they are not needed.
constexpr std::uint32_t compiledMask(std::uint32_t specialized, std::uint32_t needed) {
    return (needed & specialized) | ((kFeatureMasks - 1) & ~specialized);
}

template <Gpu G, std::size_t... Masks>
constexpr std::array<TraceLaunch<G>, sizeof...(Masks)> pathLaunches(std::index_sequence<Masks...>) {
    return {launchPaths<G, compiledMask(G::kSpecializedFeatures, std::uint32_t(Masks))>...};
}

/// Returns the launch for paths that need these effects. It is specialized like those above.
template <Gpu G>
TraceLaunch<G> pathLaunch(std::uint32_t needed) {
    static constexpr auto kPaths = pathLaunches<G>(std::make_index_sequence<kFeatureMasks>());
    return kPaths[needed];
}

template <Gpu G, FlatModel Model>
TraceLaunch<G> projectionLaunch(const FlatScene& scene) {
    return forProjectedTissue<Model>(
        scene, [&]<Tissue Kind>() { return TraceLaunch<G>(launchTrace<G, ProjectionSampler<Model, Kind>>); });
}

template <Gpu G>
TraceLaunch<G> traceLaunchFor(const FlatScene& scene) {
    switch (scene.optics.model) {
        case FlatModel::absorption:
            return projectionLaunch<G, FlatModel::absorption>(scene);
        case FlatModel::emission:
            return projectionLaunch<G, FlatModel::emission>(scene);
        case FlatModel::emissionAbsorption:
            return projectionLaunch<G, FlatModel::emissionAbsorption>(scene);
        case FlatModel::maximumIntensity:
            return projectionLaunch<G, FlatModel::maximumIntensity>(scene);
        case FlatModel::scattering:
            break;
    }
    return scene.marched ? launchTrace<G, MarchSampler> : pathLaunch<G>(scene.features);
}

/// Lets the driver translate the kernels for images of `scene`, where it must. Only CUDA needs it: cuda/.
template <Gpu G>
void prepareKernels(G&, const FlatScene&) {}

/// Takes the samples of `target`, adds them to `sums`, and moves full blocks to `moments` unless that is null. In the
/// compute stream.
template <Gpu G>
void traceAndAdd(G& gpu, const FlatScene& scene, const TraceTarget& target, PathListMemory<G>& lists, PixelSums* sums,
                 Moments* moments) {
    traceLaunchFor<G>(scene)(gpu, scene, target, lists);
    gpu.launch(AccumulateKernel{target, scene.camera.film.x, sums, moments}, target.grid.pixels(), GpuStream::compute);
}

}  // namespace pdr
