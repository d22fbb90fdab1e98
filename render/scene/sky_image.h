#pragma once
/// Environment images that are chosen as light, like a rig. The brightness in a file depends on its author, so a chosen
/// image is scaled first; `radiance` of its Environment is then its mean brightness.

#include <memory>

#include "render/base/result.h"
#include "render/scene/named_rig.h"

namespace pdr {

/// Returns the mean luminance of all directions. `image` has passed its check().
double meanLuminance(const EnvironmentImage& image);

/// Scales `image` to a mean luminance of 1. Error: it is black.
Result<EnvironmentImage> scaledToMeanOne(EnvironmentImage image);

/// Replaces the rig by the light of `image`, which is scaled to mean one, at about the same brightness; the rig
/// becomes one lamp, switched off. What the rig follows and what is seen behind the volume stay.
Lighting litBy(Lighting lighting, std::shared_ptr<const EnvironmentImage> image);

/// Removes the image of `environment`; light of the same mean brightness then comes from everywhere.
Environment withoutImage(Environment environment);

}  // namespace pdr
