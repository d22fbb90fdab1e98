#include "render/device/cuda/cuda_errors.h"

#include "render/device/gpu/gpu_failures.h"

namespace pdr {
namespace {

std::string versionText(int version) {
    return std::to_string(version / 1000) + "." + std::to_string(version % 1000 / 10);
}

Error tooOldFor(const std::string& gpu) {
    int driver = 0, runtime = 0;
    cudaDriverGetVersion(&driver);
    cudaRuntimeGetVersion(&runtime);
    return driverTooOld(gpu, versionText(driver), versionText(runtime));
}

std::size_t freeBytes() {
    std::size_t free = 0, total = 0;
    return cudaMemGetInfo(&free, &total) == cudaSuccess ? free : 0;
}

/// Returns whether all calls of the process fail from here on (CUDA Runtime API, cudaError_t: "the process must be
/// terminated and relaunched").
bool isLost(cudaError_t status) {
    switch (status) {
        case cudaErrorContained:
        case cudaErrorIllegalAddress:
        case cudaErrorAssert:
        case cudaErrorHardwareStackError:
        case cudaErrorIllegalInstruction:
        case cudaErrorMisalignedAddress:
        case cudaErrorInvalidAddressSpace:
        case cudaErrorInvalidPc:
        case cudaErrorLaunchFailure:
        case cudaErrorTensorMemoryLeak:
        case cudaErrorMpsClientTerminated:
        case cudaErrorExternalDevice:
        case cudaErrorNvlinkUncorrectable:
        case cudaErrorCudartUnloading:
            return true;
        default:
            return false;
    }
}

}  // namespace

Error cudaFailure(cudaError_t status, const std::string& gpu, const char* doing) {
    const std::string detail = std::string(doing) + ": " + cudaGetErrorString(status);
    switch (status) {
        case cudaErrorInsufficientDriver:
        case cudaErrorCallRequiresNewerDriver:
        case cudaErrorCompatNotSupportedOnDevice:
            return tooOldFor(gpu);
        case cudaErrorSystemDriverMismatch:
            return driverMixed(gpu);
        case cudaErrorNoKernelImageForDevice:
        case cudaErrorInvalidDeviceFunction:
        case cudaErrorInvalidKernelImage:
        case cudaErrorInvalidPtx:
        case cudaErrorUnsupportedPtxVersion:
        case cudaErrorJitCompilerNotFound:
        case cudaErrorJitCompilationDisabled:
            return gpuCodeMissing(gpu, detail);
        case cudaErrorDevicesUnavailable:
            return gpuInUse(gpu);
        case cudaErrorMemoryAllocation:
            return gpuMemoryTaken(gpu, freeBytes());
        case cudaErrorLaunchTimeout:
            return gpuTimedOut(gpu);
        case cudaErrorECCUncorrectable:
            return gpuMemoryDamaged(gpu);
        default:
            return isLost(status) ? gpuLost(gpu, detail) : gpuFailed(gpu, detail);
    }
}

}  // namespace pdr
