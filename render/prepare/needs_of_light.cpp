#include <algorithm>
#include <cmath>

#include "render/kernel/features.h"
#include "render/prepare/need_subject.h"

namespace pdr::need {
namespace {

constexpr float kSharpPhase = 0.5f;  ///< |g| from which scattering counts as sharper than lights are large

bool cameraSees(const Light& light) {
    return std::visit(
        [](const auto& one) {
            if constexpr (requires { one.visible; })
                return one.visible;
            return false;
        },
        light);
}

void hide(Light& light) {
    std::visit(
        [](auto& one) {
            if constexpr (requires { one.visible; })
                one.visible = false;
        },
        light);
}

bool isPlaced(const Light& light) {
    return !std::holds_alternative<DirectionalLight>(light);
}

}  // namespace

Effect shadows(const Subject& subject) {
    if (isProjection(subject.scene.model))
        return off(phrase("shadows"), phrase("the model has none"));
    if (const Text why = whyNothingScatters(subject, false); !why.empty())
        return off(phrase("shadows"), why);
    return effect(phrase("shadows"), !subject.scene.unshadowed, phrase("light crosses tissue on its way"),
                  phrase("light is let through everything, to see what shadows do"), 0,
                  [](Scene& s) { s.unshadowed = true; });
}

Effect placedLights(const Subject& subject) {
    const Text name = phrase("lights with a place");
    const Scene& scene = subject.scene;
    if (isProjection(scene.model))
        return off(name, phrase("the model asks for no light"));
    if (std::ranges::none_of(scene.lights, isPlaced))
        return off(name, phrase("no light is a rectangle or a sphere"));
    if (const Text why = whyNothingScatters(subject, false); !why.empty())
        return off(name, why);
    return effect(
        name, std::ranges::any_of(scene.lights, [](const Light& light) { return isPlaced(light) && shines(light); }),
        phrase("a light is a rectangle or a sphere"), phrase("no rectangle and no sphere shines"), kPlacedLights,
        [](Scene& s) { std::erase_if(s.lights, isPlaced); });
}

Effect lightsInView(const Scene& scene) {
    const Text name = phrase("lights in view");
    if (isProjection(scene.model))
        return off(name, phrase("the model asks for no light"));
    if (std::ranges::none_of(scene.lights, isPlaced))
        return off(name, phrase("no light is a rectangle or a sphere"));
    return effect(name, std::ranges::any_of(scene.lights, cameraSees), phrase("the camera sees a light"),
                  phrase("all lights are hidden from the camera"), 0,
                  [](Scene& s) { std::ranges::for_each(s.lights, hide); });
}

Effect surroundings(const Subject& subject) {
    const Text name = phrase("light from all around");
    if (isProjection(subject.scene.model))
        return off(name, phrase("the model asks for no light"));
    if (subject.scene.environment.isBlack())
        return off(name, phrase("the environment is black"));
    const Text why = whyNothingScatters(subject, false);
    return effect(name, why.empty(), phrase("the environment shines"), why, kEnvironment,
                  [](Scene& s) { s.environment = {}; });
}

Effect alongScatter(const Subject& subject) {
    const Text name = phrase("search along scattering");
    const Scene& scene = subject.scene;
    if (isProjection(scene.model))
        return off(name, phrase("the model asks for no light"));
    if (const Text why = whyNothingScatters(subject, false); !why.empty())
        return off(name, why);
    if (!searchesAlongScatter(scene) || !(placedLights(subject).needed || surroundings(subject).needed))
        return off(name, phrase("every light is best found by aiming at it"));
    if (!scene.environment.isBlack())
        return effect(name, true, phrase("light comes from all around"), {});
    Effect search = effect(name, true, phrase("highlights or directed scattering are sharper than the lights"), {});
    search.couldBeLeftOut = std::fabs(scene.phaseG) < kSharpPhase && !highlights(subject).needed;
    if (search.couldBeLeftOut)
        search.reason = phrase("for highlights, which cannot show: could be left out");
    return search;
}

Effect background(const Scene& scene) {
    if (scene.model == Model::maximumIntensity)
        return off(phrase("visible background"), phrase("the model shows values, not light"));
    const auto hideIt = [](Scene& s) { s.environment.visible = false; };
    if (scene.model == Model::absorption && showsEnvironment(scene) && !scene.environment.isBlack())
        return effect(phrase("visible background"), true,
                      phrase("tissue is seen against the environment, else against white"), {}, 0, hideIt);
    if (scene.model == Model::absorption)
        return effect(phrase("visible background"), true,
                      phrase("tissue is seen against white: without it there is no image"), {});
    if (scene.environment.isBlack())
        return effect(phrase("visible background"), false, {}, phrase("the environment is black"));
    return effect(phrase("visible background"), showsEnvironment(scene), phrase("the camera sees the environment"),
                  phrase("the environment is hidden from the camera"), 0, hideIt);
}

}  // namespace pdr::need

namespace pdr {

bool searchesAlongScatter(const Scene& scene) {
    if (isProjection(scene.model))
        return false;
    if (!scene.environment.isBlack())
        return true;
    return std::ranges::any_of(scene.lights, need::isPlaced) &&
           (need::speaksOfHighlights(scene) || std::fabs(scene.phaseG) >= need::kSharpPhase);
}

}  // namespace pdr
