#include "tests/ptx/runtime/runtime.h"

#include <cstdio>
#include <cstdlib>

#include "tests/ptx/runtime/bad_address.h"
#include "tests/ptx/runtime/counts.h"

namespace pdr::ptx {

namespace {

/// CUDA keeps the last error of each thread of the host.
thread_local cudaError_t lastError = cudaSuccess;

/// Errors after which no call succeeds any more.
bool losesTheDevice(cudaError_t status) {
    return status == cudaErrorIllegalAddress || status == cudaErrorMisalignedAddress ||
           status == cudaErrorLaunchFailure || status == cudaErrorIllegalInstruction ||
           status == cudaErrorECCUncorrectable || status == cudaErrorLaunchTimeout;
}

}  // namespace

Runtime& Runtime::get() {
    static auto* runtime = new Runtime;
    return *runtime;
}

Runtime::Runtime() : defaultStream_(streams.open()) {
    tellBadAddresses();
    if (!settings.counts.empty())
        std::atexit([] { writeCounts(get().settings.counts, get().kernels); });
}

cudaError_t Runtime::begin(const char* name) {
    const cudaError_t wanted = failures_.next(name);
    return wanted != cudaSuccess ? wanted : lost_;
}

cudaError_t Runtime::end(const char* name, cudaError_t status) {
    if (settings.trace)
        std::fprintf(stderr, "call %llu %s: %d\n", static_cast<unsigned long long>(failures_.calls()), name,
                     int(status));
    if (status != cudaSuccess)
        lastError = status;
    if (losesTheDevice(status) && lost_ == cudaSuccess) {
        lost_ = status;
        streams.abandon();
        pinned.letAllGo();
    }
    return status;
}

cudaError_t Runtime::takeLastError() {
    const std::lock_guard lock(guard_);
    return std::exchange(lastError, lost_);
}

void Runtime::stop(const NotKnown& error) {
    std::fprintf(stderr, "ptx: not known: %s\n", error.what());
    std::_Exit(3);
}

}  // namespace pdr::ptx
