#include "app/bench/prediction/scenes.h"

#include <utility>

#include "app/bench/paper/head_scene.h"
#include "app/bench/trackers/scenes.h"

namespace pdr::bench {
namespace {

/// Returns a head that is lit from above, in a dim environment.
Scene litHead() {
    Scene scene = headScenes()[1].scene;
    scene.environment.radiance = vec3(0.2f, 0.25f, 0.3f);
    scene.lights = {DirectionalLight{{0, 0.6f, -0.8f}, vec3(2)}};
    return scene;
}

void makeFog(Scene& scene) {
    scene.model = Model::multipleScattering;
    scene.phaseG = 0.9f;
    scene.transferFunction = {
        0.1f,
        {{.hu = -600, .opacity = 0.05f, .albedo = vec3(0.95f)}, {.hu = 600, .opacity = 1, .albedo = vec3(0.95f)}}};
}

void makeLamp(Scene& scene) {
    const dvec3 place = scene.volume->geometry().centreMm() + dvec3(15, -180, 120);
    scene.environment = {};
    scene.lights = {SphereLight{place, 3, vec3(3000)}};
}

}  // namespace

Result<std::vector<PredictionScene>> predictionScenes() {
    const auto bone = paper::headScene();
    if (!bone)
        return bone.error();
    std::vector<PredictionScene> scenes;
    const auto add = [&, head = litHead()](const char* name, auto change) {
        Scene scene = head;
        change(scene);
        scenes.push_back({name, std::move(scene)});
    };
    add("head", [](Scene&) {});
    scenes.push_back({"bone look", bone->scene, bone->display.exposure});
    add("lens", [](Scene& scene) { scene.camera.apertureMm = 30; });
    add("forward fog", makeFog);
    add("small bright lamp", makeLamp);
    add("many bounces", [](Scene& scene) { scene.model = Model::multipleScattering; });
    return scenes;
}

}  // namespace pdr::bench
