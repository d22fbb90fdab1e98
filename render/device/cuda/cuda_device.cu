#include "render/device/cuda/cuda_device.h"

#include "render/device/cuda/cuda_errors.h"
#include "render/device/cuda/cuda_gpu.h"
#include "render/device/cuda/embedded_code.h"
#include "render/device/cuda/trace_kernels.h"
#include "render/device/gpu/gpu_failures.h"
#include "render/device/gpu_device.h"

namespace pdr {

namespace {

const PathProgram& pathProgram(std::uint32_t needed) {
    static const std::array<std::array<PathProgram, kMasksPerFile>, kFeatureMasks / kMasksPerFile> kPrograms{
        pathProgramsFrom<0>(), pathProgramsFrom<8>(), pathProgramsFrom<16>(), pathProgramsFrom<24>()};
    return kPrograms[needed / kMasksPerFile][needed % kMasksPerFile];
}

void append(std::vector<const void*>& kernels, const std::vector<const void*>& others) {
    kernels.insert(kernels.end(), others.begin(), others.end());
}

template <FlatModel Model>
std::vector<const void*> projectionKernels(const FlatScene& scene) {
    return forProjectedTissue<Model>(
        scene, [&]<Tissue Kind>() { return queuedKernelsOf<TraceKernel<ProjectionSampler<Model, Kind>>>(); });
}

/// Returns the kernels that traceLaunchFor() launches, except those of pathProgram().
template <Tissue Kind>
std::vector<const void*> samplingKernels(const FlatScene& scene) {
    switch (scene.optics.model) {
        case FlatModel::absorption:
            return projectionKernels<FlatModel::absorption>(scene);
        case FlatModel::emission:
            return projectionKernels<FlatModel::emission>(scene);
        case FlatModel::emissionAbsorption:
            return projectionKernels<FlatModel::emissionAbsorption>(scene);
        case FlatModel::maximumIntensity:
            return projectionKernels<FlatModel::maximumIntensity>(scene);
        case FlatModel::scattering:
            break;
    }
    if (scene.marched)
        return queuedKernelsOf<TraceKernel<MarchSampler>>();
    using enum ThinTissue;
    std::vector<const void*> kernels = scene.looksAtThin ? queuedKernelsOf<CameraKernel<Kind, looked>>()
                                                         : queuedKernelsOf<CameraKernel<Kind, solved>>();
    append(kernels, scene.lightLooks    ? queuedKernelsOf<ShadowKernel<Kind, allLooked>>()
                    : scene.looksAtThin ? queuedKernelsOf<ShadowKernel<Kind, looked>>()
                                        : queuedKernelsOf<ShadowKernel<Kind, solved>>());
    append(kernels, kernelsOf<AddLightKernel>());
    append(kernels, pathProgram(scene.features).kernels);
    return kernels;
}

}  // namespace

template <>
TraceLaunch<CudaGpu> pathLaunch<CudaGpu>(std::uint32_t needed) {
    return pathProgram(needed).launch;
}

/// Exposure Render's schedule, which is there for comparison, has kernels that are not among these.
template <>
void prepareKernels<CudaGpu>(CudaGpu& gpu, const FlatScene& scene) {
    std::vector<const void*> kernels =
        kernelsOf<BuildRangesKernel, BoundFineKernel, BoundCoarseKernel, ClearDepthsKernel, ProjectCellsKernel,
                  SpreadWideCellsKernel, ViewDepthsKernel, ForgetFaultsKernel, AccumulateKernel, ResolveKernel,
                  CountErrorsKernel, FinalizeKernel>();
    append(kernels, forTissue(scene, [&]<Tissue Kind>() { return samplingKernels<Kind>(scene); }));
    gpu.prepare(kernels);
}

template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::whole, ThinTissue::solved>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}
template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::whole, ThinTissue::looked>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}
template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::masked, ThinTissue::solved>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}
template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::masked, ThinTissue::looked>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}

template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::parted, ThinTissue::solved>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}

template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<Tissue::parted, ThinTissue::looked>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::whole, ThinTissue::solved>& kernel,
                  std::int64_t lightPaths) {
    gpu.launchQueued(kernel, lightPaths, GpuStream::compute);
}
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::whole, ThinTissue::looked>& kernel,
                  std::int64_t lightPaths) {
    gpu.launchQueued(kernel, lightPaths, GpuStream::compute);
}
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::masked, ThinTissue::solved>& kernel,
                  std::int64_t lightPaths) {
    gpu.launchQueued(kernel, lightPaths, GpuStream::compute);
}
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::masked, ThinTissue::looked>& kernel,
                  std::int64_t lightPaths) {
    gpu.launchQueued(kernel, lightPaths, GpuStream::compute);
}

template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::parted, ThinTissue::solved>& kernel,
                  std::int64_t lightPaths) {
    gpu.launchQueued(kernel, lightPaths, GpuStream::compute);
}

template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::parted, ThinTissue::looked>& kernel,
                  std::int64_t lightPaths) {
    gpu.launchQueued(kernel, lightPaths, GpuStream::compute);
}
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::whole, ThinTissue::allLooked>& kernel,
                  std::int64_t lightPaths) {
    gpu.launchQueued(kernel, lightPaths, GpuStream::compute);
}
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::masked, ThinTissue::allLooked>& kernel,
                  std::int64_t lightPaths) {
    gpu.launchQueued(kernel, lightPaths, GpuStream::compute);
}
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<Tissue::parted, ThinTissue::allLooked>& kernel,
                  std::int64_t lightPaths) {
    gpu.launchQueued(kernel, lightPaths, GpuStream::compute);
}
template <>
void launchAddLight(CudaGpu& gpu, const AddLightKernel& kernel, std::int64_t samples) {
    gpu.launch(kernel, samples, GpuStream::compute);
}

namespace {

constexpr const char* kName = "cuda";

/// First compute capability that nvcc compiles for: 7.5, Turing.
constexpr int kOldest[] = {7, 5};

std::string nameOf(int index) {
    return index == 0 ? kName : kName + (":" + std::to_string(index));
}

/// Returns the number of GPUs. Errors: why there is none.
Result<int> countGpus() {
    int count = 0, driver = 0;
    const cudaError_t status = cudaGetDeviceCount(&count);
    cudaGetLastError();  // otherwise the next launch would report this error
    cudaDriverGetVersion(&driver);
    if (status == cudaErrorInsufficientDriver && driver == 0)
        return Error{phrase("there is no driver for a GPU of NVIDIA's"), kName,
                     phrase("Install one, or render on the CPU."), ErrorKind::refused};
    if (status == cudaErrorNoDevice || (status == cudaSuccess && count == 0))
        return Error{phrase("there is no GPU of NVIDIA's"), kName, phrase("Render on the CPU."), ErrorKind::refused};
    if (status != cudaSuccess)
        return cudaFailure(status, kName, "looking for GPUs");
    return count;
}

Result<cudaDeviceProp> propertiesOf(int index) {
    cudaDeviceProp properties{};
    const cudaError_t status = cudaGetDeviceProperties(&properties, index);
    if (status == cudaSuccess)
        return properties;
    const Error error = cudaFailure(status, nameOf(index), "asking what it is");
    cudaGetLastError();
    return error;
}

/// Checks that this program has machine code for the GPU, or code that its driver can translate.
Result<void> checkAge(const cudaDeviceProp& gpu) {
    const auto text = [](int major, int minor) { return std::to_string(major) + "." + std::to_string(minor); };
    if (gpu.major > kOldest[0] || (gpu.major == kOldest[0] && gpu.minor >= kOldest[1]))
        return {};
    return gpuTooOld(gpu.name, text(gpu.major, gpu.minor), text(kOldest[0], kOldest[1]));
}

DeviceInfo infoOf(int index, const Result<cudaDeviceProp>& gpu) {
    return {nameOf(index),
            gpu ? std::string(gpu->name) + ", " + bytesText(gpu->totalGlobalMem) : gpu.error().what.c_str()};
}

}  // namespace

Result<std::vector<DeviceInfo>> cudaDevices() {
    const Result<int> count = countGpus();
    if (!count)
        return count.error();
    std::vector<DeviceInfo> infos;
    for (int i = 0; i < *count; ++i)
        infos.push_back(infoOf(i, propertiesOf(i)));
    return Result<std::vector<DeviceInfo>>(std::move(infos));
}

Result<std::unique_ptr<Device>> makeCudaDevice(int index, const PreparationObserver& preparing) {
    const Result<int> count = countGpus();
    if (!count)
        return count.error();
    if (index < 0 || index >= *count)
        return Error{phrase("there is no such GPU"), "cuda:" + std::to_string(index),
                     phrase("The last one is cuda:%1.", *count - 1)};
    const Result<cudaDeviceProp> gpu = propertiesOf(index);
    if (!gpu)
        return gpu.error();
    if (Result<void> isNew = checkAge(*gpu); !isNew)
        return isNew.error();
    auto device = std::make_unique<GpuDevice<CudaGpu>>(
        infoOf(index, gpu), index, std::string(gpu->name),
        hasMachineCodeFor(gpu->major, gpu->minor) ? PreparationObserver() : preparing);
    if (Result<void> works = takeStatus(device->gpu()); !works)
        return works.error();
    return Result<std::unique_ptr<Device>>(std::move(device));
}

}  // namespace pdr
