#include "render/scene/needs.h"

#include <algorithm>
#include <cmath>

#include "render/kernel/features.h"

namespace pdr {
namespace {

bool isBlack(vec3 colour) {
    return colour == vec3(0);
}

/// Whether a property is anything but black where tissue can be met: at or beside an opacity above 0.
template <class Property>
bool anywhere(const TransferFunction& function, Property property) {
    const std::vector<TransferNode>& nodes = function.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const bool met = nodes[i].opacity > 0 || (i > 0 && nodes[i - 1].opacity > 0) ||
                         (i + 1 < nodes.size() && nodes[i + 1].opacity > 0);
        if (met && !isBlack(property(nodes[i])))
            return true;
    }
    return false;
}

bool hasTissue(const Scene& scene) {
    return scene.transferFunction.extinctionPerMm > 0 &&
           std::ranges::any_of(scene.transferFunction.nodes, [](const TransferNode& node) { return node.opacity > 0; });
}

bool hasPlacedLight(const Scene& scene) {
    return std::ranges::any_of(scene.lights,
                               [](const Light& light) { return !std::holds_alternative<DirectionalLight>(light); });
}

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

bool isLit(const Scene& scene) {
    return !scene.lights.empty() || !scene.environment.isBlack();
}

/// "needed: YES" or "off: NO".
Effect effect(std::string name, bool needed, std::string yes, std::string no, std::uint32_t features = 0,
              void (*leaveOut)(Scene&) = nullptr) {
    return {std::move(name), needed, needed ? std::move(yes) : std::move(no), features, leaveOut};
}

/// Of the models that are sums along straight rays.
Effect off(std::string name, std::string reason) {
    return effect(std::move(name), false, "", std::move(reason));
}

Effect shadows(const Scene& scene) {
    if (isProjection(scene.model))
        return off("shadows", "the model has none");
    if (!hasTissue(scene))
        return effect("shadows", false, "", "no tissue is opaque");
    return effect("shadows", isLit(scene), "light crosses tissue on its way", "there is no light");
}

Effect surfaces(const Scene& scene) {
    if (isProjection(scene.model))
        return off("surface reflection", "the model has none");
    if (!hasTissue(scene))
        return effect("surface reflection", false, "", "no tissue is opaque");
    return effect("surface reflection", scene.gradientFactor > 0, "the gradient factor is above 0",
                  "the gradient factor is 0", kSurface, [](Scene& s) { s.gradientFactor = 0; });
}

Effect highlights(const Scene& scene) {
    if (!surfaces(scene).needed)
        return effect("highlights", false, "", "there are no surfaces");
    const bool shiny = anywhere(scene.transferFunction, [](const TransferNode& node) { return node.specular; });
    return effect("highlights", shiny, "a node is specular", "no node is specular", 0, [](Scene& s) {
        for (TransferNode& node : s.transferFunction.nodes)
            node.specular = vec3(0);
    });
}

Effect directedScattering(const Scene& scene) {
    if (isProjection(scene.model))
        return off("directed scattering", "the model does not scatter");
    return effect("directed scattering", scene.phaseG != 0, "phase g is not 0", "phase g is 0: the same to all sides",
                  0, [](Scene& s) { s.phaseG = 0; });
}

Effect emission(const Scene& scene) {
    if (scene.model == Model::absorption || scene.model == Model::maximumIntensity)
        return off("emission", "the model shows no light from within");
    const bool shines =
        hasTissue(scene) && anywhere(scene.transferFunction, [](const TransferNode& node) { return node.emission; });
    const std::uint32_t features = isProjection(scene.model) ? 0u : std::uint32_t(kEmission);
    return effect("emission", shines, "a node emits light", "no node emits light", features, [](Scene& s) {
        for (TransferNode& node : s.transferFunction.nodes)
            node.emission = vec3(0);
    });
}

Effect placedLights(const Scene& scene) {
    constexpr const char* kName = "lights with a place";
    if (isProjection(scene.model))
        return off(kName, "the model asks for no light");
    return effect(kName, hasPlacedLight(scene), "a light is a panel or a ball", "no light is a panel or a ball",
                  kPlacedLights, [](Scene& s) {
                      std::erase_if(s.lights,
                                    [](const Light& l) { return !std::holds_alternative<DirectionalLight>(l); });
                  });
}

Effect lightsInView(const Scene& scene) {
    constexpr const char* kName = "lights in view";
    if (isProjection(scene.model))
        return off(kName, "the model asks for no light");
    if (!hasPlacedLight(scene))
        return off(kName, "no light is a panel or a ball");
    return effect(kName, std::ranges::any_of(scene.lights, cameraSees), "the camera sees a light",
                  "all lights are hidden from the camera", 0, [](Scene& s) { std::ranges::for_each(s.lights, hide); });
}

Effect surroundings(const Scene& scene) {
    if (isProjection(scene.model))
        return off("light from all around", "the model asks for no light");
    return effect("light from all around", !scene.environment.isBlack(), "the environment shines",
                  "the environment is black", kEnvironment, [](Scene& s) { s.environment = {}; });
}

Effect alongScatter(const Scene& scene) {
    constexpr const char* kName = "search along scattering";
    if (isProjection(scene.model))
        return off(kName, "the model asks for no light");
    return effect(kName, searchesAlongScatter(scene),
                  scene.environment.isBlack() ? "highlights or directed scattering are sharper than the lights"
                                              : "light comes from all around",
                  "every light is best found by aiming at it");
}

Effect background(const Scene& scene) {
    if (scene.model == Model::maximumIntensity)
        return off("visible background", "the model shows HU, not light");
    if (scene.model == Model::absorption)
        return effect("visible background", true,
                      scene.environment.visible && !scene.environment.isBlack()
                          ? "tissue is seen against the environment"
                          : "tissue is seen against white",
                      "");
    if (scene.environment.isBlack())
        return effect("visible background", false, "", "the environment is black");
    return effect("visible background", scene.environment.visible, "the camera sees the environment",
                  "the environment is hidden from the camera", 0, [](Scene& s) { s.environment.visible = false; });
}

Effect depthOfField(const Scene& scene) {
    return effect("depth of field", scene.camera.apertureMm > 0, "the lens is open", "the aperture is 0", 0,
                  [](Scene& s) { s.camera.apertureMm = 0; });
}

Effect clipping(const Scene& scene) {
    return effect("clipping", !scene.clip.empty(), "a box or a plane cuts tissue away", "nothing is cut away", 0,
                  [](Scene& s) { s.clip = {}; });
}

Effect bounces(const Scene& scene) {
    constexpr const char* kName = "multiple scattering";
    if (isProjection(scene.model))
        return off(kName, "the model does not scatter");
    if (scene.model == Model::singleScattering)
        return off(kName, "the model has one event on a path");
    if (scene.maxBounces == 1)
        return off(kName, "a path may have one event only");
    const bool scatters = hasTissue(scene) && anywhere(scene.transferFunction, [](const TransferNode& node) {
                              return node.albedo + node.specular;
                          });
    return effect(kName, scatters, "light is scattered on from event to event", "no tissue scatters light", kBounces,
                  [](Scene& s) { s.model = Model::singleScattering; });
}

}  // namespace

std::vector<Effect> needs(const Scene& scene) {
    return {
        shadows(scene),      surfaces(scene),     highlights(scene),   directedScattering(scene), placedLights(scene),
        lightsInView(scene), surroundings(scene), alongScatter(scene), background(scene),         emission(scene),
        depthOfField(scene), clipping(scene),     bounces(scene),
    };
}

bool searchesAlongScatter(const Scene& scene) {
    constexpr float kSharpPhase = 0.5f;
    if (isProjection(scene.model))
        return false;
    if (!scene.environment.isBlack())
        return true;
    return hasPlacedLight(scene) && (highlights(scene).needed || std::fabs(scene.phaseG) >= kSharpPhase);
}

std::uint32_t neededFeatures(const std::vector<Effect>& effects) {
    std::uint32_t features = 0;
    for (const Effect& effect : effects)
        if (effect.needed)
            features |= effect.features;
    return features;
}

}  // namespace pdr
