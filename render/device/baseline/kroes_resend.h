#pragma once
/// Data that Exposure Render sends to the GPU for each iteration although nothing has changed; see kroes_accumulator.h.
/// PD-Render reads none of it: it is sent for the time that this takes.

#include <array>

#include "render/device/baseline/kroes_kernels.h"
#include "render/device/gpu/gpu_array.h"
#include "render/kernel/medium.h"

namespace pdr::kroes {

inline constexpr int kConstants = 34;  ///< number of copies of single parameters
inline constexpr int kTables = 5;      ///< opacity, diffuse, specular, roughness, emission
inline constexpr int kTableSamples = 128;

struct TableEntry {
    float value[4];
};
using Tables = std::array<std::array<TableEntry, kTableSamples>, kTables>;

/// Returns the transfer function sampled evenly over the HU of 12-bit CT.
inline Tables bakedTables(const FlatTransferFunction& function) {
    constexpr float kLowestHu = -1024, kHighestHu = 3071;
    const auto entry = [](vec3 colour) { return TableEntry{{colour.x, colour.y, colour.z, 0}}; };
    Tables tables;
    for (int i = 0; i < kTableSamples; ++i) {
        const float hu = kLowestHu + (kHighestHu - kLowestHu) * float(i) / float(kTableSamples - 1);
        const Material material = materialAt(function, hu);
        tables[0][i] = entry(vec3(opacity(function, hu)));
        tables[1][i] = entry(material.albedo);
        tables[2][i] = entry(material.specular);
        tables[3][i] = entry(vec3(material.roughness));
        tables[4][i] = entry(material.emission);
    }
    return tables;
}

/// Device memory that is kept from one iteration to the next.
template <Gpu G>
struct Constants {
    GpuArray<G, unsigned char> parameters;
    GpuArray<G, TableEntry> tables;

    explicit Constants(G& gpu)
        : parameters(gpu, sizeof(FlatScene)), tables(gpu, std::size_t(kTables) * kTableSamples) {}
};

/// Does 34 + 5 + 3 copies to the device, 3 allocations, and one program of one thread with its copy back. Its
/// destructor, at the iteration's end, releases the allocations.
template <Gpu G>
class Resend {
  public:
    Resend(G& gpu, const Constants<G>& constants, const FrameSampler& sampler)
        : host_(sampler.scene()->flat), scene_(gpu, 1), view_(gpu, 1) {
        sendConstants(gpu, constants);
        sendTables(gpu, constants);
        scene_.copyFrom(&host_);
        autofocus(gpu, sampler.sceneOnDevice());
        scene_.copyFrom(&host_);
        view_.copyFrom(&host_.camera);
    }

  private:
    void sendConstants(G& gpu, const Constants<G>& constants) {
        const auto* bytes = reinterpret_cast<const unsigned char*>(&host_);
        for (std::size_t i = 0; i < kConstants; ++i) {
            const std::size_t begin = i * sizeof(FlatScene) / kConstants,
                              end = (i + 1) * sizeof(FlatScene) / kConstants;
            gpu.copyToDevice(constants.parameters.data() + begin, bytes + begin, end - begin, GpuStream::compute);
        }
    }

    void sendTables(G& gpu, const Constants<G>& constants) {
        const Tables tables = bakedTables(host_.transferFunction);
        for (std::size_t i = 0; i < kTables; ++i)
            gpu.copyToDevice(constants.tables.data() + i * kTableSamples, tables[i].data(), sizeof tables[i],
                             GpuStream::compute);
    }

    void autofocus(G& gpu, const FlatScene& onDevice) {
        GpuArray<G, float> found(gpu, 1);
        gpu.launch(Autofocus{onDevice, found.data()}, 1, GpuStream::compute);
        gpu.awaitAll();
        float distance = 0;
        found.copyTo(&distance);
    }

    FlatScene host_;
    GpuArray<G, FlatScene> scene_;
    GpuArray<G, FlatCamera> view_;
};

}  // namespace pdr::kroes
