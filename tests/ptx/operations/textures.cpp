/// tex.3d: a filtered value of a volume.

#include <array>

#include "tests/ptx/machine/texture.h"
#include "tests/ptx/operations/operations.h"
#include "tests/ptx/operations/places.h"

namespace pdr::ptx {

namespace {

void fetch(Warp& w, const Instruction& i) {
    forLanes(w, [&](int lane) {
        const u64 handle = w.at<u64>(i.from[0])[lane];
        const Texture* texture = w.launch->textures.find(handle);
        if (texture == nullptr)
            w.fault(i, lane, kIllegalAddress, "there is no texture " + std::to_string(handle));
        const f32 value =
            texture->linear(w.at<f32>(i.from[1])[lane], w.at<f32>(i.from[2])[lane], w.at<f32>(i.from[3])[lane]);
        const std::array<f32, 4> channels{value, 0, 0, 1};  // those that a texture has not are 0, 0, 1
        for (std::size_t n = 0; n < channels.size(); ++n)
            if (i.to[n] != kNone)
                w.at<f32>(i.to[n])[lane] = channels[n];
    });
}

}  // namespace

Operation textureFetch() {
    return &fetch;
}

}  // namespace pdr::ptx
