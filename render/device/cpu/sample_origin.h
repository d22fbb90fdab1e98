#pragma once
/// Which sample a path or a ray is, and where it goes.

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

    /// Adds what it brought, or counts why that is no radiance.
    PDR_HD_INLINE void add(vec3 radiance, Health& health) const {
        if (!addSample(*target, radiance, sample)) [[unlikely]]
            note(faultOf(radiance), health);
    }
    /// The same for a sample as the kernel returns it: PathSample or Projected.
    template <class Sample>
    PDR_HD_INLINE void add(const Sample& found, Health& health) const {
        add(found.radiance, health);
        see(found.tissue ? seenOfTissue(sample) : 0);
        noteFaults(found, [&](Fault fault) { note(fault, health); });
    }
    /// Tells its pixel what it has seen: kSeen...
    void see(std::uint32_t what) const { target->seen |= what; }
    void note(Fault fault, Health& health) const { health.add(fault, sample, pixel); }
};

}  // namespace pdr
