#include "render/device/cuda/cuda_device.h"

#include "render/device/cuda/cuda_gpu.h"
#include "render/device/cuda/trace_kernels.h"
#include "render/device/gpu_device.h"

namespace pdr {

template <>
TraceLaunch<CudaGpu> pathLaunch<CudaGpu>(std::uint32_t needed) {
    static const std::array<std::array<TraceLaunch<CudaGpu>, kMasksPerFile>, kFeatureMasks / kMasksPerFile> kLaunches{
        pathLaunchesFrom<0>(), pathLaunchesFrom<8>(), pathLaunchesFrom<16>(), pathLaunchesFrom<24>()};
    return kLaunches[needed / kMasksPerFile][needed % kMasksPerFile];
}

template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<false>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}
template <>
void launchCamera(CudaGpu& gpu, const CameraKernel<true>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<false>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}
template <>
void launchShadow(CudaGpu& gpu, const ShadowKernel<true>& kernel, std::int64_t samples) {
    gpu.launchQueued(kernel, samples, GpuStream::compute);
}

namespace {

constexpr const char* kName = "cuda";

std::string versionText(int version) {
    return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

/// Returns the reason why no GPU can be used.
Error noGpu(cudaError_t status) {
    int driver = 0, runtime = 0;
    cudaDriverGetVersion(&driver);
    cudaRuntimeGetVersion(&runtime);
    if (status == cudaErrorInsufficientDriver && driver == 0)
        return {phrase("there is no driver for a GPU of NVIDIA's"), kName, phrase("Install one, or render on the CPU."),
                ErrorKind::refused};
    if (status == cudaErrorInsufficientDriver)
        return {
            phrase("the driver is too old: it knows CUDA %1, %2 is needed", versionText(driver), versionText(runtime)),
            kName, phrase("Install a newer driver, or render on the CPU.")};
    if (status == cudaErrorNoDevice)
        return {phrase("there is no GPU of NVIDIA's"), kName, phrase("Render on the CPU."), ErrorKind::refused};
    return {phrase("the GPU cannot be used (%1)", std::string(cudaGetErrorString(status))), kName,
            phrase("Render on the CPU.")};
}

/// First compute capability that nvcc compiles for: 7.5, Turing.
constexpr int kOldest = 75;

/// Checks that this program has machine code for the GPU, or code that its driver can translate.
Result<void> checkAge(int index) {
    int major = 0, minor = 0;
    const cudaError_t status[] = {cudaDeviceGetAttribute(&major, cudaDevAttrComputeCapabilityMajor, index),
                                  cudaDeviceGetAttribute(&minor, cudaDevAttrComputeCapabilityMinor, index)};
    cudaGetLastError();
    const bool isKnown = status[0] == cudaSuccess && status[1] == cudaSuccess;
    if (!isKnown || 10 * major + minor >= kOldest)
        return {};
    return Error{
        phrase("the GPU is too old for this program: it is of compute capability %1.%2, 7.5 or later is needed", major,
               minor),
        kName, phrase("Render on the CPU.")};
}

DeviceInfo infoOf(int index) {
    cudaDeviceProp properties{};
    if (cudaGetDeviceProperties(&properties, index) != cudaSuccess)
        cudaGetLastError();  // otherwise the next launch would report this error
    return {index == 0 ? kName : kName + (":" + std::to_string(index)),
            std::string(properties.name) + ", " + bytesText(properties.totalGlobalMem)};
}

}  // namespace

Result<std::vector<DeviceInfo>> cudaDevices() {
    int count = 0;
    const cudaError_t status = cudaGetDeviceCount(&count);
    cudaGetLastError();
    if (status != cudaSuccess || count == 0)
        return noGpu(status == cudaSuccess ? cudaErrorNoDevice : status);
    std::vector<DeviceInfo> infos;
    for (int i = 0; i < count; ++i)
        infos.push_back(infoOf(i));
    return Result<std::vector<DeviceInfo>>(std::move(infos));
}

Result<std::unique_ptr<Device>> makeCudaDevice(int index) {
    const Result<std::vector<DeviceInfo>> known = cudaDevices();
    if (!known)
        return known.error();
    if (index < 0 || std::size_t(index) >= known->size())
        return Error{phrase("there is no such GPU"), "cuda:" + std::to_string(index),
                     phrase("The last one is cuda:%1.", known->size() - 1)};
    if (Result<void> isNew = checkAge(index); !isNew)
        return isNew.error();
    auto device = std::make_unique<GpuDevice<CudaGpu>>((*known)[std::size_t(index)], index);
    if (Result<void> works = takeStatus(device->gpu()); !works)
        return works.error();
    return Result<std::unique_ptr<Device>>(std::move(device));
}

}  // namespace pdr
