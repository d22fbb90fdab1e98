#pragma once
/// Ways to light a volume that have a name.

#include <optional>

#include "render/scene/look.h"

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

/// `look` with that rig, about as bright as before: its lights are as strong as strengthOf() said. What the rig follows
/// and what is seen behind the volume stays.
Look litBy(Look look, NamedRig name);

/// The rig whose panels these are, how strong they may be; none where one has been moved, or another stands there.
std::optional<NamedRig> rigOf(const Look& look);

/// How bright a look's lights are: the irradiance that its strongest lamp brings to the volume's centre, or what light
/// from all around is worth beside it.
double strengthOf(const Look& look);

}  // namespace pdr
