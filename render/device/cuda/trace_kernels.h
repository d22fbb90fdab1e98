#pragma once
/// The path kernels, of each set of effects, compiled side by side in files of their own.

#include <array>
#include <vector>

#include "render/device/cuda/cuda_gpu.h"
#include "render/device/gpu/tracer.h"

namespace pdr {

inline constexpr std::uint32_t kMasksPerFile = 8;

/// What is compiled of a set of effects.
struct PathProgram {
    TraceLaunch<CudaGpu> launch;
    std::vector<const void*> kernels;  ///< the kernels that only it has
};

/// Returns the programs for the masks from First on. Defined in trace_kernels.cu, which is compiled once for each
/// First.
template <std::uint32_t First>
std::array<PathProgram, kMasksPerFile> pathProgramsFrom();

template <>
TraceLaunch<CudaGpu> pathLaunch<CudaGpu>(std::uint32_t needed);
template <>
void prepareKernels<CudaGpu>(CudaGpu& gpu, const FlatScene& scene);
template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::whole, ThinTissue::solved>& kernel, std::int64_t samples);
template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::whole, ThinTissue::looked>& kernel, std::int64_t samples);
template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::masked, ThinTissue::solved>& kernel, std::int64_t samples);
template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::masked, ThinTissue::looked>& kernel, std::int64_t samples);
template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::parted, ThinTissue::solved>& kernel, std::int64_t samples);
template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::parted, ThinTissue::looked>& kernel, std::int64_t samples);
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::whole, ThinTissue::solved>& kernel, std::int64_t lightPaths);
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::whole, ThinTissue::looked>& kernel, std::int64_t lightPaths);
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::masked, ThinTissue::solved>& kernel,
                  std::int64_t lightPaths);
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::masked, ThinTissue::looked>& kernel,
                  std::int64_t lightPaths);
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::parted, ThinTissue::solved>& kernel,
                  std::int64_t lightPaths);
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::parted, ThinTissue::looked>& kernel,
                  std::int64_t lightPaths);
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::whole, ThinTissue::allLooked>& kernel,
                  std::int64_t lightPaths);
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::masked, ThinTissue::allLooked>& kernel,
                  std::int64_t lightPaths);
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::parted, ThinTissue::allLooked>& kernel,
                  std::int64_t lightPaths);
template <>
void launchAddLight(CudaGpu& gpu, const AddLightKernel& kernel, std::int64_t samples);

}  // namespace pdr
