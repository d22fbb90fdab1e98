/// CUDA's functions about devices, versions and errors.

#include <cstdio>
#include <string>

#include "tests/ptx/runtime/runtime.h"

using namespace pdr::ptx;

extern "C" {

cudaError_t cudaGetDeviceCount(int* count) {
    return Runtime::get().call("cudaGetDeviceCount", [&](Runtime& r) {
        const bool isTooOld = r.settings.driver / 1000 < CUDART_VERSION / 1000;
        *count = isTooOld ? 0 : r.settings.devices;
        return isTooOld ? cudaErrorInsufficientDriver : *count > 0 ? cudaSuccess : cudaErrorNoDevice;
    });
}
cudaError_t cudaDriverGetVersion(int* version) {
    return Runtime::get().call("cudaDriverGetVersion", [&](Runtime& r) {
        *version = r.settings.driver;
        return cudaSuccess;
    });
}
cudaError_t cudaRuntimeGetVersion(int* version) {
    return Runtime::get().call("cudaRuntimeGetVersion", [&](Runtime&) {
        *version = CUDART_VERSION;
        return cudaSuccess;
    });
}
/// All devices have the same memory and streams, so that which one is chosen need not be kept.
cudaError_t cudaSetDevice(int device) {
    return Runtime::get().call("cudaSetDevice", [&](Runtime& r) {
        return device >= 0 && device < r.settings.devices ? cudaSuccess : cudaErrorInvalidDevice;
    });
}
cudaError_t cudaGetDeviceProperties(cudaDeviceProp* properties, int) {
    return Runtime::get().call("cudaGetDeviceProperties", [&](Runtime& r) {
        *properties = {};
        std::snprintf(properties->name, sizeof properties->name, "PTX on the CPU");
        properties->totalGlobalMem = r.memory.totalBytes();
        properties->major = r.settings.capability / 10;
        properties->minor = r.settings.capability % 10;
        properties->multiProcessorCount = r.settings.processors;
        properties->warpSize = kLanes;
        properties->maxThreadsPerBlock = 1024;
        return cudaSuccess;
    });
}
cudaError_t cudaDeviceGetAttribute(int* value, cudaDeviceAttr attribute, int) {
    return Runtime::get().call("cudaDeviceGetAttribute", [&](Runtime& r) {
        switch (attribute) {
            case cudaDevAttrMultiProcessorCount:
                *value = r.settings.processors;
                return cudaSuccess;
            case cudaDevAttrComputeCapabilityMajor:
                *value = r.settings.capability / 10;
                return cudaSuccess;
            case cudaDevAttrComputeCapabilityMinor:
                *value = r.settings.capability % 10;
                return cudaSuccess;
            case cudaDevAttrMaxTexture3DWidth:
            case cudaDevAttrMaxTexture3DHeight:
            case cudaDevAttrMaxTexture3DDepth:
                *value = r.settings.largestTexture;
                return cudaSuccess;
            default:
                throw NotKnown("device attribute " + std::to_string(attribute));
        }
    });
}
cudaError_t cudaMemGetInfo(std::size_t* free, std::size_t* total) {
    return Runtime::get().call("cudaMemGetInfo", [&](Runtime& r) {
        *free = r.memory.freeBytes();
        *total = r.memory.totalBytes();
        return cudaSuccess;
    });
}
const char* cudaGetErrorString(cudaError_t status) {
    static thread_local char text[64];
    std::snprintf(text, sizeof text, "CUDA error %d", int(status));
    return text;
}
cudaError_t cudaGetLastError() {
    return Runtime::get().takeLastError();
}

}  // extern "C"
