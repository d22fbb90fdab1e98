// How texture units filter: what NVIDIA's guide leaves open, and render/kernel/texture.h assumes.
#include <cuda_runtime.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

constexpr int kPlaces = 1 << 13;  // between two voxels
constexpr int kEdge = 2;
constexpr float kFull = 32767;

__global__ void readBetween(cudaTextureObject_t texture, float* values) {
    const int i = int(blockIdx.x * blockDim.x + threadIdx.x);
    if (i < kPlaces)
        values[i] = tex3D<float>(texture, 0.5f + float(i) / kPlaces, 0.5f, 0.5f);
}

/// Texture of 2 x 2 x 2 voxels: 0 and, one step along x, `high`. Read as the renderer does: [-1, 1], filtered.
cudaTextureObject_t textureUpTo(std::int16_t high) {
    const std::int16_t voxels[] = {0, high, 0, high, 0, high, 0, high};
    const cudaChannelFormatDesc format = cudaCreateChannelDesc<short>();
    cudaResourceDesc resource{};
    resource.resType = cudaResourceTypeArray;
    cudaMalloc3DArray(&resource.res.array.array, &format, make_cudaExtent(kEdge, kEdge, kEdge));
    cudaMemcpy3DParms copy{};
    copy.srcPtr = make_cudaPitchedPtr(const_cast<std::int16_t*>(voxels), kEdge * sizeof *voxels, kEdge, kEdge);
    copy.dstArray = resource.res.array.array;
    copy.extent = make_cudaExtent(kEdge, kEdge, kEdge);
    copy.kind = cudaMemcpyHostToDevice;
    cudaMemcpy3DAsync(&copy, nullptr);
    cudaTextureDesc reading{};
    for (cudaTextureAddressMode& mode : reading.addressMode)
        mode = cudaAddressModeClamp;
    reading.filterMode = cudaFilterModeLinear;
    reading.readMode = cudaReadModeNormalizedFloat;
    cudaTextureObject_t texture = 0;
    cudaCreateTextureObject(&texture, &resource, &reading, nullptr);
    return texture;
}

/// Filtered values at all places, in units of `high`.
std::vector<double> fractionsOf(std::int16_t high) {
    constexpr int kThreads = 128;
    float* there = nullptr;
    cudaMalloc(reinterpret_cast<void**>(&there), kPlaces * sizeof *there);
    readBetween<<<kPlaces / kThreads, kThreads>>>(textureUpTo(high), there);
    std::vector<float> values(kPlaces);
    cudaMemcpyAsync(values.data(), there, kPlaces * sizeof *there, cudaMemcpyDeviceToHost, nullptr);
    cudaDeviceSynchronize();
    std::vector<double> fractions;
    for (const float value : values)
        fractions.push_back(double(value) * kFull / high);
    return fractions;
}

/// The largest difference from the fractions that `rule` makes of each place in 256ths. Ties are left out.
template <class Rule>
double differenceFrom(const std::vector<double>& fractions, const Rule& rule) {
    double largest = 0;
    for (int i = 0; i < kPlaces; ++i) {
        const double place = 256.0 * i / kPlaces;
        if (place - std::floor(place) != 0.5)
            largest = std::fmax(largest, std::fabs(fractions[std::size_t(i)] - rule(place) / 256));
    }
    return largest;
}

}  // namespace

int main() {
    constexpr double kSame = 1.0 / 4096;
    const std::vector<double> wide = fractionsOf(std::int16_t(kFull)), narrow = fractionsOf(1);
    if (const cudaError_t status = cudaGetLastError(); status != cudaSuccess) {
        std::printf("%s\n", cudaGetErrorString(status));
        return 1;
    }
    const double nearest = differenceFrom(wide, [](double place) { return std::rint(place); });
    const double cut = differenceFrom(wide, [](double place) { return std::floor(place); });
    std::printf("texture fractions: %s; from the nearest 256th %.5f at most, from the 256th below %.5f\n",
                nearest < kSame ? "rounded to the nearest 256th, as assumed"
                : cut < kSame   ? "CUT to 256ths, not as assumed"
                                : "NEITHER rounded to the nearest 256th nor cut",
                nearest, cut);
    std::printf("texture fractions between: %.5f of a 256th at 128.5\n", wide[kPlaces / 2 + kPlaces / 512] * 256);
    double most = 0;
    for (std::size_t i = 0; i < narrow.size(); ++i)
        most = std::fmax(most, std::fabs(narrow[i] - wide[i]));
    std::printf("texture results: %s; 0 and 1 of 32767 differ by %.5f from 0 and 32767\n",
                most < kSame ? "not rounded to 16 bits, as assumed" : "ROUNDED, not as assumed", most);
}
