#pragma once
/// What is rendered where no scene is named.

#include <string>

#include "render/film/display.h"
#include "render/scene/scene.h"
#include "render/volume/phantom.h"

namespace pdr::bench::paper {

struct ShownScene {
    Scene scene;
    Display display;
    std::string description;  ///< for the report
};

/// A head from the front, with the look "CT bone" of bone_look.json, single scattering. Of as many voxels as the
/// paper's (256 x 230 x 256; its own, Manix, is not free) where no other number is given.
Result<ShownScene> headScene(ivec3 voxels = kHeadPhantomSize, dvec3 spacingMm = kHeadPhantomSpacingMm);

}  // namespace pdr::bench::paper
