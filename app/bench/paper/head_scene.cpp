#include "app/bench/paper/head_scene.h"

#include "app/bench/paper/plan.h"
#include "render/scene/fit_view.h"
#include "render/scene/preset.h"

namespace pdr::bench::paper {

extern const char* const kBonePreset;  ///< resources/presets/ct_bone.json, compiled in

namespace {

constexpr double kFraction = 0.95;  ///< of the picture's height that the head's box takes

}  // namespace

Result<ShownScene> headScene(ivec3 voxels, dvec3 spacingMm) {
    const Result<Preset> preset = presetFromJson(kBonePreset, "the preset of the benchmark");
    if (!preset)
        return preset.error();
    Scene scene;
    scene.volume = std::make_shared<Volume>(headPhantom(voxels, spacingMm));
    const VolumeGeometry& geometry = scene.volume->geometry();
    const double aspect = double(kSizes.front().x) / kSizes.front().y;
    const Camera front = standardView(StandardView::anterior, geometry.centreMm(), geometry.radiusMm(), aspect);
    scene.camera = fittedView(front, geometry, aspect, kFraction);
    scene = withPreset(scene, *preset);
    return ShownScene{scene, preset->look.display,
                      "head phantom of " + std::to_string(voxels.x) + "x" + std::to_string(voxels.y) + "x" +
                          std::to_string(voxels.z) + " voxels, preset \"" + preset->name + "\", single scattering"};
}

}  // namespace pdr::bench::paper
