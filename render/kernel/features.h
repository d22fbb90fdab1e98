#pragma once
/// The effects that are compiled into a kernel, as bits. Effects that a scene does not need are not in the code that
/// runs.

#include <cstdint>

namespace pdr {

enum Feature : std::uint32_t {
    kSurface = 1u << 0,       ///< events can be surface reflections (gradient, microfacets)
    kPlacedLights = 1u << 1,  ///< there are lights with a position: rectangles, spheres
    kEnvironment = 1u << 2,   ///< the environment lights the volume or is seen behind it
    kEmission = 1u << 3,      ///< tissue emits light
    kBounces = 1u << 4,       ///< light is scattered more than once
};
inline constexpr std::uint32_t kFeatureMasks = 1u << 5;

/// Returns whether `features` contains any bit of `wanted`.
constexpr bool has(std::uint32_t features, std::uint32_t wanted) {
    return (features & wanted) != 0;
}

}  // namespace pdr
