#include "render/device/baseline/cpu_frame_sampler.h"

namespace pdr {

namespace {

/// Converts a sum of one sample to that sample: single-precision values are restored to the bit.
struct TakeSample {
    PixelSums* sums;
    SampledPixel* frame;

    void operator()(std::int64_t i) const {
        frame[i] = {vec3(sums[i].sum), std::uint16_t(sums[i].count), std::uint16_t(sums[i].seen)};
        sums[i] = {};
    }
};

}  // namespace

void CpuFrameSampler::restart(const Tile& area) {
    area_ = area;
    sums_.assign(pixelCount(area), {});
    health_ = {};
}

Result<void> CpuFrameSampler::sample(std::uint64_t number, SampledPixel* frame, std::stop_token stop) {
    tracer_.trace(scene_->flat, area_, {number, 1}, {sums_.data(), area_.width, &health_}, stop);
    gpu_.launch(TakeSample{sums_.data(), frame}, std::int64_t(sums_.size()), GpuStream::compute);
    return {};
}

}  // namespace pdr
