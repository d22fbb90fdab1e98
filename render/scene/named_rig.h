#pragma once
/// Named arrangements of lights around a volume.

#include <optional>

#include "render/scene/light_rig.h"

namespace pdr {

enum class NamedRig {
    headlight,      ///< one small lamp beside the eye: few shadows, light reaches every recess
    threePoint,     ///< a small key light from the side, a dim fill light, a rim light
    operatingLamp,  ///< a ring of lamps above, whose shadows overlap softly
    rim,            ///< two panels behind the volume: outlines
    softBox,        ///< one large panel: soft shadows
    studio,         ///< key and fill, strips behind at both sides, and one from above: edges drawn by light
    sky             ///< light from all around, more from the head's side, and a sun
};

inline constexpr NamedRig kNamedRigs[] = {NamedRig::headlight, NamedRig::threePoint, NamedRig::operatingLamp,
                                          NamedRig::rim,       NamedRig::softBox,    NamedRig::studio,
                                          NamedRig::sky};

/// Everything that lights a volume.
struct Lighting {
    LightRig rig;
    Environment environment;
    bool operator==(const Lighting&) const = default;
};

/// Replaces the rig by the named one at about the same brightness: strengthOf() stays the same. What the rig follows
/// and what is seen behind the volume stay.
Lighting litBy(Lighting lighting, NamedRig name);

/// Rotates the lamps as turned(LightRig) does, and an environment image about the patient's axis, as far as this
/// rotation goes about it.
Lighting turned(Lighting lighting, dvec2 drag, const Camera& camera);

/// Returns `environment` with that radiance straight above (luminance, >= 0) in its own colour; white where it was
/// black.
Environment withRadiance(Environment environment, double radiance);

/// Returns the rig that these panels form, at any strength; none if a panel was moved or belongs to no named rig.
std::optional<NamedRig> nameOf(const LightRig& rig);

/// Returns the irradiance of the strongest lamp at the volume's centre, or the equivalent of the environment if that is
/// larger. An environment image is assumed to be scaled to mean one.
double strengthOf(const Lighting& lighting);

}  // namespace pdr
