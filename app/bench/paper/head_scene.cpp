#include "app/bench/paper/head_scene.h"

#include "app/bench/paper/plan.h"
#include "render/scene/fit_view.h"
#include "render/scene/named_look.h"

namespace pdr::bench::paper {

extern const char* const kBoneLook;  ///< bone_look.json, compiled in

namespace {

constexpr double kFraction = 0.95;  ///< share of the image's height that the head's box takes

}  // namespace

Result<ShownScene> headScene(ivec3 voxels, dvec3 spacingMm) {
    const Result<NamedLook> look = lookFromJson(kBoneLook, "the look of the benchmark");
    if (!look)
        return look.error();
    Scene scene;
    scene.volume = std::make_shared<Volume>(headPhantom(voxels, spacingMm));
    const VolumeGeometry& geometry = scene.volume->geometry();
    const double aspect = double(kSizes.front().x) / kSizes.front().y;
    const Camera front = standardView(StandardView::anterior, geometry.centreMm(), geometry.radiusMm(), aspect);
    scene.camera = fittedView(front, geometry, aspect, kFraction);
    scene = withNamedLook(scene, *look, scene.volume->geometry());
    return ShownScene{scene, look->look.display,
                      "head phantom of " + std::to_string(voxels.x) + "x" + std::to_string(voxels.y) + "x" +
                          std::to_string(voxels.z) + " voxels, look \"" + look->name + "\", single scattering"};
}

}  // namespace pdr::bench::paper
