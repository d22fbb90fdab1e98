#pragma once
/// Scene that is rendered if none is named.

#include <string>

#include "render/film/display.h"
#include "render/scene/scene.h"
#include "render/volume/phantom.h"

namespace pdr::bench::paper {

struct ShownScene {
    Scene scene;
    Display display;
    std::string description;  ///< description for the report
};

/// Returns a head from the front, with the look "CT bone" of bone_look.json and single scattering. By default it has as
/// many voxels as the paper's (256 x 230 x 256; the paper's own head, Manix, is not free).
Result<ShownScene> headScene(ivec3 voxels = kHeadPhantomSize, dvec3 spacingMm = kHeadPhantomSpacingMm);

}  // namespace pdr::bench::paper
