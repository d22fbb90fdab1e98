/// Small programs with one fault each, and some without: faults_test.cpp says what must be seen of each.
///   ptx_faults CASE

#include <cuda_runtime.h>

#include <cstdio>
#include <cstring>
#include <functional>
#include <map>
#include <string>

#include "tests/ptx/checks/arithmetic.h"

namespace {

constexpr int kCount = 100;
constexpr int kThreads = 128;

__global__ void addOne(const int* from, int* to, int count) {
    const int i = int(threadIdx.x);
    if (i < count)
        to[i] = from[i] + 1;
}
__global__ void writeInPairs(int* to) {
    to[threadIdx.x / 2] = int(threadIdx.x);
}
__global__ void count(unsigned* to) {
    atomicAdd(to, 1u);
}
__global__ void loadWide(const char* from, long long* to) {
    *to = *reinterpret_cast<const long long*>(from);
}
/// Lanes with an odd number ask alone for votes that all must give.
__global__ void voteApart(unsigned* to) {
    if (threadIdx.x % 2 == 1)
        while (true)
            if (__ballot_sync(0x0000FFFFu, true) == 1)
                return;
    to[threadIdx.x] = __ballot_sync(0xFFFFFFFFu, true);
}
/// Lanes part and meet again before they vote.
__global__ void voteTogether(unsigned* to) {
    unsigned sum = 0;
    for (unsigned n = 0; n < threadIdx.x % 7; ++n)
        sum += n;
    const unsigned all = __ballot_sync(0xFFFFFFFFu, sum > 3);
    const unsigned fifth = __shfl_sync(0xFFFFFFFFu, sum + 100, 5);
    to[threadIdx.x] = all ^ (fifth + sum);
}

/// Two streams, two arrays of the device's and one of the host's.
struct Setup {
    cudaStream_t compute, copy;
    int *from = nullptr, *to = nullptr, *pinned = nullptr;

    Setup() {
        cudaStreamCreateWithFlags(&compute, cudaStreamNonBlocking);
        cudaStreamCreateWithFlags(&copy, cudaStreamNonBlocking);
        cudaMalloc(reinterpret_cast<void**>(&from), kCount * sizeof(int));
        cudaMalloc(reinterpret_cast<void**>(&to), kCount * sizeof(int));
        cudaHostAlloc(reinterpret_cast<void**>(&pinned), kCount * sizeof(int), cudaHostAllocDefault);
        cudaMemsetAsync(to, 0, kCount * sizeof(int), compute);
    }
    unsigned* counts() const { return reinterpret_cast<unsigned*>(to); }
    void clearSource() const { cudaMemsetAsync(from, 0, kCount * sizeof(int), compute); }
    void fetch() const { cudaMemcpyAsync(pinned, to, kCount * sizeof(int), cudaMemcpyDeviceToHost, copy); }
    void fetchAfterCompute() const {
        cudaEvent_t event;
        cudaEventCreateWithFlags(&event, cudaEventDisableTiming);
        cudaEventRecord(event, compute);
        cudaStreamWaitEvent(copy, event, 0);
        fetch();
    }
};

using Case = std::function<void(const Setup&)>;

void addAndFetch(const Setup& s, int count) {
    s.clearSource();
    addOne<<<1, kThreads, 0, s.compute>>>(s.from, s.to, count);
    s.fetchAfterCompute();
}

const std::map<std::string, Case> kCases{
    {"sound", [](const Setup& s) { addAndFetch(s, kCount); }},
    {"beyond", [](const Setup& s) { addAndFetch(s, kCount + 1); }},
    {"unset",
     [](const Setup& s) {
         addOne<<<1, kThreads, 0, s.compute>>>(s.from, s.to, kCount);
         s.fetchAfterCompute();
     }},
    {"freed",
     [](const Setup& s) {
         cudaFree(s.from);
         addOne<<<1, kThreads, 0, s.compute>>>(s.from, s.to, kCount);
     }},
    {"misaligned",
     [](const Setup& s) {
         s.clearSource();
         loadWide<<<1, 1, 0, s.compute>>>(reinterpret_cast<const char*>(s.from) + 4,
                                          reinterpret_cast<long long*>(s.to));
     }},
    {"race", [](const Setup& s) { writeInPairs<<<1, kThreads, 0, s.compute>>>(s.to); }},
    {"atomics",
     [](const Setup& s) {
         count<<<10, kThreads, 0, s.compute>>>(s.counts());
         s.fetchAfterCompute();
     }},
    {"lanesApart", [](const Setup& s) { voteApart<<<1, 32, 0, s.compute>>>(s.counts()); }},
    {"lanesTogether",
     [](const Setup& s) {
         voteTogether<<<1, 32, 0, s.compute>>>(s.counts());
         s.fetchAfterCompute();
     }},
    {"noEvent",
     [](const Setup& s) {
         s.clearSource();
         addOne<<<1, kThreads, 0, s.compute>>>(s.from, s.to, kCount);
         s.fetch();
     }},
    {"readEarly",
     [](const Setup& s) {
         addAndFetch(s, kCount);
         std::printf("%d\n", s.pinned[0]);
     }},
    {"writtenEarly",
     [](const Setup& s) {
         std::memset(s.pinned, 0, kCount * sizeof(int));
         cudaMemcpyAsync(s.to, s.pinned, kCount * sizeof(int), cudaMemcpyHostToDevice, s.compute);
         s.pinned[0] = 1;
     }},
    {"hostFollows", [](const Setup& s) { std::printf("%d\n", *s.from); }},
};

}  // namespace

int main(int count, char** arguments) {
    const std::string name = count == 2 ? arguments[1] : "";
    if (name == "arithmetic")
        return pdr::ptx::arithmeticDiffers();
    const auto found = kCases.find(name);
    if (found == kCases.end())
        return 2;
    const Setup setup;
    std::memset(setup.pinned, 0, kCount * sizeof(int));
    found->second(setup);
    const cudaError_t status = cudaDeviceSynchronize();
    long long sum = 0;
    for (int n = 0; n < kCount; ++n)
        sum += setup.pinned[n];
    std::printf("status %d sum %lld\n", int(status), sum);
    return 0;
}
