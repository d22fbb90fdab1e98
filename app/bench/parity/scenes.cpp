#include "app/bench/parity/scenes.h"

#include <cmath>

#include "render/scene/fit_view.h"
#include "render/volume/phantom.h"

namespace pdr::bench {

namespace {

/// Returns a head with skin over bone, lit from one side and dimly from everywhere, with surfaces where the gradient is
/// steep.
Scene head() {
    Scene scene;
    scene.volume = std::make_shared<Volume>(headPhantom(ivec3(96), dvec3(2.5)));
    scene.transferFunction = {2,
                              {{.hu = -600, .opacity = 0, .albedo = vec3(0.9f, 0.7f, 0.6f)},
                               {.hu = -300, .opacity = 0.3f, .albedo = vec3(0.9f, 0.7f, 0.6f)},
                               {.hu = 0, .opacity = 0.1f, .albedo = vec3(0.8f, 0.5f, 0.5f)},
                               {.hu = 300, .opacity = 0.8f, .specular = vec3(0.04f), .roughness = 0.3f},
                               {.hu = 900, .opacity = 1, .specular = vec3(0.05f), .roughness = 0.2f}}};
    scene.lights = {DirectionalLight{{0.4, 1, -0.5}, vec3(2)}};
    scene.environment.radiance = vec3(0.2f, 0.25f, 0.3f);
    scene.gradientFactor = 2;
    scene.film = {160, 120};
    const VolumeGeometry& geometry = scene.volume->geometry();
    const double aspect = 160.0 / 120;
    scene.camera = fittedView(standardView(StandardView::anterior, geometry.centreMm(), geometry.radiusMm(), aspect),
                              geometry, aspect, 0.9);
    return scene;
}

}  // namespace

std::vector<ParityScene> parityScenes() {
    const Scene base = head();
    const dvec3 centre = base.volume->geometry().centreMm();
    std::vector<ParityScene> scenes;
    const auto add = [&](const std::string& name, auto&& edit) {
        scenes.push_back({name, base});
        edit(scenes.back().scene);
    };
    for (const Model model : kModels)
        add(modelName(model), [&](Scene& scene) { scene.model = model; });
    add("no effect but scattering", [](Scene& scene) {
        scene.gradientFactor = 0;
        scene.environment.radiance = vec3(0);
    });
    add("emission and panels", [&](Scene& scene) {
        scene.transferFunction.nodes[1].emission = vec3(0.2f, 0.1f, 0);
        scene.lights = {RectangleLight{.centreMm = centre + dvec3(0, -400, 300),
                                       .normal = {0, 0.8, -0.6},
                                       .radiance = vec3(40),
                                       .visible = true},
                        SphereLight{.centreMm = centre + dvec3(300, -300, 0), .radiance = vec3(30)}};
    });
    add("a hundred lights", [&](Scene& scene) {
        scene.model = Model::multipleScattering;
        scene.lights.clear();
        for (int i = 0; i < 100; ++i) {
            const vec3 radiance(float(1 + i % 7));
            const dvec3 to(std::cos(i), std::sin(i), i % 10 / 10.0);
            if (i % 3 == 0)
                scene.lights.emplace_back(DirectionalLight{-to, 0.02f * radiance});
            else if (i % 3 == 1)
                scene.lights.emplace_back(SphereLight{centre + 300.0 * to, 20, 3.0f * radiance});
            else
                scene.lights.emplace_back(RectangleLight{centre + 300.0 * to, -to, {0, 0, 1}, 50, 50, radiance});
        }
    });
    add("multiple scattering, forward", [](Scene& scene) {
        scene.model = Model::multipleScattering;
        scene.phaseG = 0.8f;
    });
    add("lens and clipping", [&](Scene& scene) {
        scene.camera.apertureMm = 6;
        scene.clip.planes = {{centre, dvec3(1, 0.2, 0.1)}};
        scene.clip.shadows = true;
    });
    add("plain background", [](Scene& scene) { scene.background = vec3(0.3f, 0.5f, 0.7f); });
    add("orthographic", [](Scene& scene) { scene.camera.type = Camera::Type::orthographic; });
    add("very dense", [](Scene& scene) { scene.transferFunction.extinctionPerMm = 2000; });
    add("the eye inside, thin", [&](Scene& scene) {
        scene.camera.eyeMm = centre + dvec3(0, 5, 0);
        scene.transferFunction.extinctionPerMm = 0.02f;
    });
    add("Exposure Render's march", [](Scene& scene) { scene.estimator = Estimator::kroesMarch; });
    return scenes;
}

}  // namespace pdr::bench
