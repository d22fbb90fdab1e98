#pragma once
/// Ways to light a volume that have a name.

#include <optional>

#include "render/scene/light_rig.h"

namespace pdr {

enum class NamedRig {
    headlight,      ///< one small lamp beside the eye: few shadows, each recess is seen into
    threePoint,     ///< a small key from the side, a dark fill, a rim
    operatingLamp,  ///< a ring of lamps from above, whose shadows overlap softly
    rim,            ///< two panels behind: outlines
    softBox,        ///< one large panel: soft shadows
    sky             ///< light from all around, more from the head's side, and a sun
};

inline constexpr NamedRig kNamedRigs[] = {NamedRig::headlight, NamedRig::threePoint, NamedRig::operatingLamp,
                                          NamedRig::rim,       NamedRig::softBox,    NamedRig::sky};

/// All that lights a volume.
struct Lighting {
    LightRig rig;
    Environment environment;
    bool operator==(const Lighting&) const = default;
};

/// That rig instead of the one there, about as bright: its lights are as strong as strengthOf() said. What the rig
/// follows and what is seen behind the volume stays.
Lighting litBy(Lighting lighting, NamedRig name);

/// Its lamps as turned(LightRig) turns them, and a picture of surroundings about the patient's axis as far as that hand
/// takes it along.
Lighting turned(Lighting lighting, dvec2 drag, const Camera& camera);

/// `environment` with that radiance straight above (luminance, >= 0) and of its colour; white where it was black.
Environment withRadiance(Environment environment, double radiance);

/// The rig whose panels these are, however strong; none where one has been moved, or another stands there.
std::optional<NamedRig> nameOf(const LightRig& rig);

/// The irradiance that the strongest lamp brings to the volume's centre, or what light from all around is worth beside
/// it; that of a picture is taken to be scaled to mean one.
double strengthOf(const Lighting& lighting);

}  // namespace pdr
