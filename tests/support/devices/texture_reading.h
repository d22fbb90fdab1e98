#pragma once
/// Reads a volume on a GPU, to test whether its texture units agree with the computation that replaces them elsewhere.

#include <span>
#include <vector>

#include "render/device/gpu/gpu_scene.h"
#include "render/kernel/volume_sampling.h"

namespace pdr::test {

/// Kernel that reads the HU at each place (index space).
struct ReadKernel {
    FlatVolume volume;
    const vec3* places;
    float* hu;

    PDR_HD void operator()(std::int64_t index) const { hu[index] = hounsfield(volume, places[index]); }
};

/// Returns the HU of `scene`'s volume at `places`, filtered as the scene requests, as the programs of `gpu` compute it.
template <Gpu G>
Result<std::vector<float>> readOn(G& gpu, std::shared_ptr<const PreparedScene> scene, std::span<const vec3> places) {
    GpuScene<G> there(gpu);
    if (Result<void> uploaded = there.upload(std::move(scene)); !uploaded)
        return uploaded.error();
    GpuArray<G, vec3> from(gpu);
    GpuArray<G, float> to(gpu, places.size());
    from.assign(places);
    gpu.launch(ReadKernel{there.flat().volume, from.data(), to.data()}, std::int64_t(places.size()),
               GpuStream::compute);
    std::vector<float> hu(places.size());
    to.copyTo(hu.data());
    gpu.awaitAll();
    if (Result<void> done = takeStatus(gpu); !done)
        return done.error();
    return hu;
}

}  // namespace pdr::test
