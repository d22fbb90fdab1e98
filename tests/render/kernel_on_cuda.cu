/// The kernel headers, compiled for a GPU: compiling is the test. One thread, one pixel; nothing is launched.

#include "render/device/gpu/kroes_programs.h"
#include "render/kernel/integrator.h"
#include "render/kernel/kroes_path.h"
#include "render/kernel/march.h"
#include "render/kernel/pixel.h"
#include "render/kernel/projection.h"

namespace pdr {

template <std::uint32_t F>
__global__ void renderPixels(FlatScene scene, SampleRange samples, PixelSums* sums) {
    const ivec2 pixel(blockIdx.x * blockDim.x + threadIdx.x, blockIdx.y * blockDim.y + threadIdx.y);
    if (pixel.x >= scene.camera.film.x || pixel.y >= scene.camera.film.y)
        return;
    const vec2 depths = matterDepths(scene, pixel);
    PixelSums& sum = sums[pixel.y * scene.camera.film.x + pixel.x];
    for (std::uint32_t i = 0; i < samples.count; ++i)
        addSample(sum, showsNothing(scene, depths)
                           ? plainBackground(scene)
                           : tracePath<F>(scene, pixel, samples.first + i, depths, Unwatched()).radiance);
}

template __global__ void renderPixels<0>(FlatScene, SampleRange, PixelSums*);
template __global__ void renderPixels<kFeatureMasks - 1>(FlatScene, SampleRange, PixelSums*);

template <FlatModel Model>
__global__ void projectPixels(FlatScene scene, PixelSums* sums) {
    const ivec2 pixel(blockIdx.x * blockDim.x + threadIdx.x, blockIdx.y * blockDim.y + threadIdx.y);
    const Path path = cameraStart(scene, pixel, 0, matterDepths(scene, pixel));
    addSample(sums[pixel.y * scene.camera.film.x + pixel.x], project<Model>(scene, path.leg.ray, backdrop<Model>(scene, path.leg)).radiance);
}

template __global__ void projectPixels<FlatModel::absorption>(FlatScene, PixelSums*);
template __global__ void projectPixels<FlatModel::emission>(FlatScene, PixelSums*);
template __global__ void projectPixels<FlatModel::emissionAbsorption>(FlatScene, PixelSums*);
template __global__ void projectPixels<FlatModel::maximumIntensity>(FlatScene, PixelSums*);

__global__ void marchRay(FlatScene scene, Ray ray, RandomStream random, float* ends) {
    const float step = marchStep(scene.volume, kExposureRenderStep);
    ends[0] = marchToCollision(scene, ray, random, step);
    ends[1] = marchTransmittance(scene, ray, random, step);
}

__global__ void marchSample(FlatScene scene, PixelSums* sums) {
    const ivec2 pixel(blockIdx.x, blockIdx.y);
    addSample(sums[blockIdx.x], kroesSample(scene, pixel, 0, matterDepths(scene, pixel)).radiance);
}

template <class Program>
__global__ void runProgram(Program program) {
    program(blockIdx.x * blockDim.x + threadIdx.x);
}

template __global__ void runProgram(kroes::Blur);
template __global__ void runProgram(kroes::RunningMean);
template __global__ void runProgram(kroes::AddToBlock);
template __global__ void runProgram(kroes::MergeBlock);
template __global__ void runProgram(kroes::ShowMean);
template __global__ void runProgram(kroes::ShowSums);
template __global__ void runProgram(kroes::Autofocus);

}  // namespace pdr
