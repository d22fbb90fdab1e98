#pragma once
/// A picture of surroundings that is chosen as light, like a rig. How bright its file says it is depends on who made
/// it, so the one that is chosen is scaled first: `radiance` of its Environment says then how bright it is on average.

#include <memory>

#include "render/base/result.h"
#include "render/scene/named_rig.h"

namespace pdr {

/// Its luminance, the mean of all directions. `picture` has passed its check().
double meanLuminance(const EnvironmentImage& picture);

/// `picture` with a mean luminance of 1. Error: it is black.
Result<EnvironmentImage> scaledToMeanOne(EnvironmentImage picture);

/// The light of `picture`, scaled to mean one, instead of the rig, about as bright; a lamp beside it is there, but off.
/// What the rig follows and what is seen behind the volume stays.
Lighting litBy(Lighting lighting, std::shared_ptr<const EnvironmentImage> picture);

/// The same light from everywhere instead of a picture, as bright on average.
Environment withoutPicture(Environment environment);

}  // namespace pdr
