#include "render/device/device_list.h"

#include <charconv>
#include <optional>

#include "render/device/emulated/emulated_gpu.h"

#if defined(PDR_HAS_CUDA)
#include "render/device/cuda/cuda_device.h"
#endif

namespace pdr {

namespace {

#if !defined(PDR_HAS_CUDA)
/// Returns the error of a program that was built without a CUDA compiler.
Error withoutCuda() {
    return {phrase("this program was built without CUDA"), "cuda",
            phrase("Render on the CPU, or build it where the CUDA Toolkit is."), ErrorKind::refused};
}
Result<std::vector<DeviceInfo>> cudaDevices() {
    return withoutCuda();
}
Result<std::unique_ptr<Device>> makeCudaDevice(int, const PreparationObserver&) {
    return withoutCuda();
}
#endif

/// Returns the number of the GPU in "cuda" or "cuda:1"; none if `name` is something else.
std::optional<int> cudaIndex(const std::string& name) {
    if (name == "cuda")
        return 0;
    if (!name.starts_with("cuda:"))
        return std::nullopt;
    int index = 0;
    const char *begin = name.data() + 5, *end = name.data() + name.size();
    const auto [stop, error] = std::from_chars(begin, end, index);
    if (begin == end || stop != end || error != std::errc() || index < 0)
        return std::nullopt;
    return index;
}

}  // namespace

std::vector<DeviceInfo> devicesHere() {
    std::vector<DeviceInfo> devices{makeCpuDevice()->info()};
    if (const auto gpus = cudaDevices())
        devices.insert(devices.end(), gpus->begin(), gpus->end());
    return devices;
}

Result<std::unique_ptr<Device>> openDevice(const std::string& name, int threads, const WhySpare& told,
                                           const PreparationObserver& preparing) {
    if (name == "cpu")
        return makeCpuDevice(threads);
    if (name == "emulated")
        return makeEmulatedGpu(threads);
    if (name == "lockstep")
        return makeLockstepGpu(threads);
    if (name == "auto") {
        Result<std::unique_ptr<Device>> gpu = makeCudaDevice(0, preparing);
        if (gpu)
            return gpu;
        if (told && gpu.error().kind != ErrorKind::refused)
            told(gpu.error());
        return makeCpuDevice(threads);
    }
    if (const std::optional<int> index = cudaIndex(name)) {
        Result<std::unique_ptr<Device>> gpu = makeCudaDevice(*index, preparing);
        if (gpu)
            return gpu;
        Error error = gpu.error();
        error.where = name;
        return error;
    }
    return Error{phrase("there is no such device"), name, phrase("Choose auto, cpu, cuda or cuda:1.")};
}

std::unique_ptr<Device> withCpuAsSpare(std::unique_ptr<Device> device, int threads, const WhySpare& told) {
    if (device->info().hostMemory)
        return device;
    return withSpare(
        std::move(device), [threads] { return openDevice("cpu", threads); }, told);
}

Result<std::unique_ptr<Device>> openDeviceToTheEnd(const std::string& name, int threads, const WhySpare& told,
                                                   const PreparationObserver& preparing) {
    Result<std::unique_ptr<Device>> device = openDevice(name, threads, told, preparing);
    if (!device || name != "auto")
        return device;
    return withCpuAsSpare(*std::move(device), threads, told);
}

}  // namespace pdr
