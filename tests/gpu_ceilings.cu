// What a GPU can do at most, to hold the renderer's figures against: bytes copied, eight voxels gathered around a
// place, multiplications and additions issued, launches and the gaps between them. Medians of seven.
#include <cuda_runtime.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>

namespace {

constexpr int kRepeats = 7;

__device__ std::uint32_t indexOfThread() {
    return blockIdx.x * blockDim.x + threadIdx.x;
}

__global__ void fillWithHashes(std::uint32_t* words, std::size_t count) {
    for (std::size_t i = indexOfThread(); i < count; i += std::size_t(gridDim.x) * blockDim.x)
        words[i] = std::uint32_t(i) * 2654435761u ^ std::uint32_t(i >> 7);
}

__global__ void copyAll(const float4* from, float4* to, std::size_t count) {
    for (std::size_t i = indexOfThread(); i < count; i += std::size_t(gridDim.x) * blockDim.x)
        to[i] = from[i];
}

struct Grid {
    const std::int16_t* voxels;
    int row, slice;        // voxels from one to the next
    std::uint32_t places;  // at which eight can be read
};

/// Coherent: the lanes of a warp read around one place, as rays of neighbouring pixels do; else each anywhere.
__global__ void gatherEights(Grid grid, bool coherent, int rounds, int* kept) {
    std::uint32_t state = ((coherent ? indexOfThread() / 32 : indexOfThread()) + 1) * 2654435761u;
    const int aside = coherent ? int(threadIdx.x % 8 + threadIdx.x % 32 / 8 * grid.row) : 0;
    int sum = 0;
    for (int round = 0; round < rounds; ++round) {
        state = state * 1664525u + 1013904223u;
        const std::int16_t* corner = grid.voxels + ((std::uint64_t(state) * grid.places) >> 32) + aside;
        for (int n = 0; n < 8; ++n)
            sum += corner[(n & 1) + (n >> 1 & 1) * grid.row + (n >> 2) * grid.slice];
    }
    if (sum == 0x7FFFFFF)  // never: so that nothing is left out
        *kept = sum;
}

/// Eight independent chains of a product and a sum, which are two instructions: built without contraction.
__global__ void multiplyAndAdd(float factor, int rounds, float* kept) {
    float chains[8];
    for (int i = 0; i < 8; ++i)
        chains[i] = float(threadIdx.x + i);
    for (int round = 0; round < rounds; ++round)
#pragma unroll
        for (float& chain : chains)
            chain = chain * factor + 1.0f;
    float sum = 0;
    for (const float chain : chains)
        sum += chain;
    if (sum == -1)
        *kept = sum;
}

__global__ void doNothing() {}

/// Begin and end of a launch of one thread, in ns of the clock that all multiprocessors share.
struct Span {
    unsigned long long begin, end;
};

__device__ unsigned long long now() {
    unsigned long long time;
    asm volatile("mov.u64 %0, %%globaltimer;" : "=l"(time));
    return time;
}

/// Takes at least `nanoseconds`, longer than the host needs for the next launch.
__global__ void waitFor(unsigned long long nanoseconds, Span* span) {
    span->begin = now();
    while (now() - span->begin < nanoseconds) {
    }
    span->end = now();
}

/// Mean time from the end of a launch to the begin of the next, in us; `clears`: with 8 bytes cleared between, as for
/// the index of a queue.
double gapBetweenLaunches(Span* spans, unsigned long long* word, bool clears) {
    constexpr int kLaunches = 200;
    constexpr unsigned long long kEach = 30'000;  // ns
    for (int i = 0; i < kLaunches; ++i) {
        if (clears)
            cudaMemsetAsync(word, 0, sizeof *word, nullptr);
        waitFor<<<1, 1>>>(kEach, spans + i);
    }
    std::array<Span, kLaunches> there{};
    cudaMemcpy(there.data(), spans, sizeof there, cudaMemcpyDeviceToHost);
    double gaps = 0;
    for (int i = 1; i < kLaunches; ++i)
        gaps += double(there[i].begin - there[i - 1].end);
    return 1e-3 * gaps / (kLaunches - 1);
}

/// Median time of `launch`, after one that does not count.
template <class Launch>
double seconds(const Launch& launch) {
    cudaEvent_t begin, end;
    cudaEventCreate(&begin);
    cudaEventCreate(&end);
    std::array<float, kRepeats + 1> milliseconds{};
    for (float& taken : milliseconds) {
        cudaEventRecord(begin);
        launch();
        cudaEventRecord(end);
        cudaEventSynchronize(end);
        cudaEventElapsedTime(&taken, begin, end);
    }
    std::sort(milliseconds.begin() + 1, milliseconds.end());
    return 1e-3 * double(milliseconds[1 + kRepeats / 2]);
}

}  // namespace

int main() {
    cudaDeviceProp gpu{};
    constexpr std::size_t kBytes = std::size_t(2) << 30;
    char *from = nullptr, *to = nullptr;
    if (cudaGetDeviceProperties(&gpu, 0) != cudaSuccess || cudaMalloc(&from, kBytes) != cudaSuccess ||
        cudaMalloc(&to, kBytes) != cudaSuccess) {
        std::printf("%s\n", cudaGetErrorString(cudaGetLastError()));
        return 1;
    }
    std::printf("%s, %d multiprocessors, L2 %.1f MB, %.1f GB\n", gpu.name, gpu.multiProcessorCount,
                double(gpu.l2CacheSize) / 1e6, double(gpu.totalGlobalMem) / 1e9);
    const int blocks = gpu.multiProcessorCount * 16;
    fillWithHashes<<<blocks, 256>>>(reinterpret_cast<std::uint32_t*>(from), kBytes / 4);

    const double copying = seconds(
        [&] { copyAll<<<blocks, 256>>>(reinterpret_cast<float4*>(from), reinterpret_cast<float4*>(to), kBytes / 16); });
    std::printf("copy                                  %8.0f GB/s\n", 2e-9 * double(kBytes) / copying);
    for (const bool coherent : {true, false})
        for (const int edge : {256, 512, 1024}) {
            constexpr int kRounds = 200, kThreads = 128;
            const std::uint32_t voxels = std::uint32_t(edge) * edge * (edge == 256 ? 108 : edge);
            const Grid grid{reinterpret_cast<std::int16_t*>(from), edge, edge * edge,
                            voxels - std::uint32_t(edge) * edge - 16u * edge};
            const double taken = seconds(
                [&] { gatherEights<<<blocks, kThreads>>>(grid, coherent, kRounds, reinterpret_cast<int*>(to)); });
            std::printf("eight voxels of %4d x %4d, %s %8.2f G/s\n", edge, edge,
                        coherent ? "lanes together" : "lanes apart   ", 1e-9 * blocks * kThreads * kRounds / taken);
        }
    constexpr int kRounds = 20'000;
    const double computing =
        seconds([&] { multiplyAndAdd<<<blocks, 256>>>(1.0000001f, kRounds, reinterpret_cast<float*>(to)); });
    std::printf("products and sums                     %8.0f G/s\n", 1e-9 * blocks * 256.0 * kRounds * 16 / computing);
    const double launching = seconds([] {
        for (int i = 0; i < 100; ++i)
            doNothing<<<1, 32>>>();
    });
    std::printf("an empty launch                       %8.2f us\n", 1e6 * launching / 100);
    auto* spans = reinterpret_cast<Span*>(to);
    auto* word = reinterpret_cast<unsigned long long*>(from);
    std::printf("from one launch's end to the next     %8.2f us\n", gapBetweenLaunches(spans, word, false));
    std::printf("the same with a number cleared        %8.2f us\n", gapBetweenLaunches(spans, word, true));
    return cudaDeviceSynchronize() == cudaSuccess ? 0 : 1;
}
