#pragma once
/// The origin of a sample, and the sums that it is added to.

#include <cstdint>

#include "render/kernel/pixel.h"

namespace pdr {

struct SampleOrigin {
    PixelSums* target;
    std::uint64_t sample;
    std::uint32_t pixel;  ///< y * width + x

    SampleOrigin(PixelSums& sums, const FlatScene& scene, ivec2 at, std::uint64_t number)
        : target(&sums), sample(number), pixel(std::uint32_t(at.y * scene.camera.film.x + at.x)) {}
    SampleOrigin() = default;

    /// Adds the radiance of the sample, or counts the fault that makes it invalid.
    PDR_HD_INLINE void add(vec3 radiance, Health& health) const {
        if (!addSample(*target, radiance, sample)) [[unlikely]]
            note(faultOf(radiance), health);
    }
    /// Adds a sample as the kernel returns it: a PathSample or a Projected.
    template <class Sample>
    PDR_HD_INLINE void add(const Sample& found, Health& health) const {
        add(found.radiance, health);
        see(found.tissue ? seenOfTissue(sample) : 0);
        noteFaults(found, [&](Fault fault) { note(fault, health); });
    }
    /// Records in the pixel what the sample has seen: kSeen...
    void see(std::uint32_t what) const { target->seen |= what; }
    void note(Fault fault, Health& health) const { health.add(fault, sample, pixel); }
};

}  // namespace pdr
