#pragma once
/// The effects that are compiled into a kernel, as bits. What a scene does not call for is not in the code that runs.

#include <cstdint>

namespace pdr {

enum Feature : std::uint32_t {
    kSurface = 1u << 0,       ///< events can be surface reflections (gradient, microfacets)
    kPlacedLights = 1u << 1,  ///< there are lights with a place: panels
    kEnvironment = 1u << 2,   ///< light from all around, or seen behind the volume
    kEmission = 1u << 3,      ///< tissue shines by itself
    kBounces = 1u << 4,       ///< light is scattered more than once
};
inline constexpr std::uint32_t kFeatureMasks = 1u << 5;

/// Whether any of `wanted` is among `features`.
constexpr bool has(std::uint32_t features, std::uint32_t wanted) {
    return (features & wanted) != 0;
}

}  // namespace pdr
