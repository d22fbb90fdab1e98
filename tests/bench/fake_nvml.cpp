/// Stands in for the driver's library libnvidia-ml.so.1, on machines without a GPU: one device, as busy as it is told.
/// Signatures: nvml.h.

#include <atomic>

extern "C" {

std::atomic<unsigned> fakeNvmlBusyPercent = 0;

struct FakeUtilization {
    unsigned gpu, memory;
};

int nvmlInit_v2() {
    return 0;
}
int nvmlShutdown() {
    return 0;
}
int nvmlDeviceGetHandleByIndex_v2(unsigned index, void** device) {
    *device = &fakeNvmlBusyPercent;
    return index == 0 ? 0 : 2;  // 2: NVML_ERROR_INVALID_ARGUMENT
}
int nvmlDeviceGetUtilizationRates(void* device, FakeUtilization* rates) {
    *rates = {static_cast<std::atomic<unsigned>*>(device)->load(), 1};
    return 0;
}
}
