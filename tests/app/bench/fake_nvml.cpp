/// Stands in for the driver's library libnvidia-ml.so.1, on machines without a GPU: one device, which was 10 % busy
/// until `fakeNvmlBusySince`, and says so for another 200 ms; from then on it is 60 % busy. Signatures: nvml.h.

#include <atomic>
#include <chrono>

extern "C" {

std::atomic<std::chrono::steady_clock::time_point> fakeNvmlBusySince{};
std::atomic<int> fakeNvmlSettledAnswers = 0;  ///< number of answers of 60 %

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
    *device = &fakeNvmlBusySince;
    return index == 0 ? 0 : 2;  // 2: NVML_ERROR_INVALID_ARGUMENT
}
int nvmlDeviceGetUtilizationRates(void*, FakeUtilization* rates) {
    const bool settled = std::chrono::steady_clock::now() - fakeNvmlBusySince.load() > std::chrono::milliseconds(200);
    *rates = {settled ? 60u : 10u, 1};
    fakeNvmlSettledAnswers += settled;
    return 0;
}
}
