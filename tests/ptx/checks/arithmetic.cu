#include "tests/ptx/checks/arithmetic.h"

#include <cuda_runtime.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace pdr::ptx {

namespace {

struct Numbers {
    float a, b;
    int i, j;
};
struct Results {
    float sum, quotient, root, least, most, nearest, lower, inverse;
    int toInt, nearInt, high, shifted, quotientInt, rest;
    unsigned toUnsigned, permuted, bits, shiftedUnsigned;
    double wide;
    long long product;
    short narrow;
};

#if !defined(__CUDA_ARCH__)
/// A whole number in [low, high], as conversions in PTX give: NaN becomes 0.
double saturated(double whole, double low, double high) {
    return whole != whole ? 0 : std::fmin(std::fmax(whole, low), high);
}
unsigned permutedBytes(unsigned low, unsigned high, unsigned choice) {
    const std::uint64_t both = std::uint64_t(high) << 32 | low;
    unsigned result = 0;
    for (int byte = 0; byte < 4; ++byte)
        result |= unsigned(both >> 8 * (choice >> 4 * byte & 7) & 0xFF) << 8 * byte;
    return result;
}
#endif

/// Whatever C++ leaves open is written twice.
__host__ __device__ void computeWhatCppLeavesOpen(const Numbers& n, Results& r) {
#if defined(__CUDA_ARCH__)
    r.toInt = int(n.a);
    r.nearInt = __float2int_rn(n.b);
    r.toUnsigned = unsigned(n.a);
    r.high = __mulhi(n.i, n.j);
    r.permuted = __byte_perm(unsigned(n.i), unsigned(n.j), 0x7604);
    r.bits = unsigned(__popc(unsigned(n.i)));
#else
    r.toInt = int(saturated(std::trunc(double(n.a)), -2147483648.0, 2147483647.0));
    r.nearInt = int(saturated(std::nearbyint(double(n.b)), -2147483648.0, 2147483647.0));
    r.toUnsigned = unsigned(saturated(std::trunc(double(n.a)), 0, 4294967295.0));
    r.high = int(r.product >> 32);
    r.permuted = permutedBytes(unsigned(n.i), unsigned(n.j), 0x7604);
    r.bits = unsigned(__builtin_popcount(unsigned(n.i)));
#endif
}

__host__ __device__ Results compute(const Numbers& n) {
    Results r{};
    r.sum = n.a + n.b;
    r.quotient = n.a / n.b;
    r.root = sqrtf(n.a);
    r.least = fminf(n.a, n.b);
    r.most = fmaxf(n.a, n.b);
    r.nearest = rintf(n.a);
    r.lower = floorf(n.b);
    r.inverse = 1 / n.b;
    r.wide = double(n.a) * n.b / 3.0;
    r.product = static_cast<long long>(n.i) * n.j;
    const bool divides = n.j != 0 && n.j != -1;
    r.quotientInt = divides ? n.i / n.j : 0;
    r.rest = divides ? n.i % n.j : 0;
    r.shifted = n.i >> (n.j & 31);
    r.shiftedUnsigned = unsigned(n.i) << (n.j & 31);
    r.narrow = short(n.i);
    computeWhatCppLeavesOpen(n, r);
    return r;
}

__global__ void computeAll(const Numbers* from, Results* to, int count) {
    const int i = int(blockIdx.x * blockDim.x + threadIdx.x);
    if (i < count)
        to[i] = compute(from[i]);
}

bool same(double x, double y) {
    return x == y || (x != x && y != y);
}
bool same(const Results& x, const Results& y) {
    return same(x.sum, y.sum) && same(x.quotient, y.quotient) && same(x.root, y.root) && same(x.least, y.least) &&
           same(x.most, y.most) && same(x.nearest, y.nearest) && same(x.lower, y.lower) && same(x.inverse, y.inverse) &&
           same(x.wide, y.wide) && x.product == y.product && x.quotientInt == y.quotientInt && x.rest == y.rest &&
           x.shifted == y.shifted && x.shiftedUnsigned == y.shiftedUnsigned && x.narrow == y.narrow &&
           x.toInt == y.toInt && x.nearInt == y.nearInt && x.toUnsigned == y.toUnsigned && x.high == y.high &&
           x.permuted == y.permuted && x.bits == y.bits;
}

std::vector<Numbers> oddNumbers() {
    const float floats[] = {0.0f,  -0.0f,  1.0f,     -1.5f,     2.5f, 1e-40f, 3e38f,
                            1e10f, -1e10f, INFINITY, -INFINITY, NAN,  0.1f,   7.7e5f};
    const int ints[] = {0, 1, -1, 7, -1000, 2147483647, -2147483647 - 1, 0x12345678, 33};
    std::vector<Numbers> all;
    for (const float a : floats)
        for (const float b : floats)
            for (const int i : ints)
                for (const int j : ints)
                    all.push_back({a, b, i, j});
    return all;
}

}  // namespace

bool arithmeticDiffers() {
    const std::vector<Numbers> numbers = oddNumbers();
    std::vector<Results> results(numbers.size());
    const std::size_t bytes = numbers.size() * sizeof(Numbers), resultBytes = numbers.size() * sizeof(Results);
    const int count = int(numbers.size());
    void *from = nullptr, *to = nullptr;
    cudaStream_t stream;
    cudaMalloc(&from, bytes);
    cudaMalloc(&to, resultBytes);
    cudaStreamCreateWithFlags(&stream, cudaStreamNonBlocking);
    cudaMemcpyAsync(from, numbers.data(), bytes, cudaMemcpyHostToDevice, stream);
    computeAll<<<unsigned(count + 127) / 128, 128, 0, stream>>>(static_cast<const Numbers*>(from),
                                                                static_cast<Results*>(to), count);
    cudaMemcpyAsync(results.data(), to, resultBytes, cudaMemcpyDeviceToHost, stream);
    int wrong = 0;
    for (std::size_t n = 0; n < numbers.size(); ++n)
        wrong += int(!same(results[n], compute(numbers[n])));
    std::printf("%d of %d differ\n", wrong, count);
    return wrong > 0;
}

}  // namespace pdr::ptx
