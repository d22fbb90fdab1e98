#include "render/prepare/needs.h"

#include <algorithm>
#include <cmath>

#include "render/kernel/bounds/cell_bound.h"
#include "render/kernel/transport/event.h"
#include "render/prepare/met_tissue.h"
#include "render/scene/scene.h"

namespace pdr {
namespace {

constexpr float kSharpPhase = 0.5f;  ///< |g| from which scattering counts as sharper than lights are large
constexpr int kManyEvents = 64;      ///< number of events after which the next one changes nothing visible

bool isBlack(vec3 colour) {
    return colour == vec3(0);
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

bool shines(const Light& light) {
    return std::visit(
        [](const auto& one) {
            if constexpr (requires { one.irradiance; })
                return !isBlack(one.irradiance);
            else
                return !isBlack(one.radiance);
        },
        light);
}

bool isPlaced(const Light& light) {
    return !std::holds_alternative<DirectionalLight>(light);
}

/// Calls visit(function) for the scene's own transfer function and for those of its parts.
template <class AnyScene, class Visit>
void forEachFunction(AnyScene& scene, Visit&& visit) {
    visit(scene.transferFunction);
    for (auto& part : scene.parts.curves)
        visit(part.transferFunction);
}

/// Returns whether a transfer function allows shiny surfaces, whatever the volume holds: whether a specular node is
/// opaque or next to an opaque one.
bool allowsHighlights(const TransferFunction& function) {
    const std::vector<TransferNode>& nodes = function.nodes;
    const auto opaque = [&](std::size_t i) { return i < nodes.size() && nodes[i].opacity > 0; };
    bool shiny = false;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        shiny = shiny || (!isBlack(nodes[i].specular) && (opaque(i) || opaque(i + 1) || (i > 0 && opaque(i - 1))));
    return shiny && function.extinctionPerMm > 0;
}

bool speaksOfHighlights(const Scene& scene) {
    bool speaks = false;
    forEachFunction(scene, [&](const TransferFunction& function) { speaks = speaks || allowsHighlights(function); });
    return speaks && highestGradientFactor(scene) > 0;
}

/// A scene and its visible tissue.
struct Subject {
    const Scene& scene;
    MetTissue tissue;
    bool lit;    ///< a light or the environment shines
    bool glows;  ///< visible tissue emits light

    explicit Subject(const Scene& s)
        : scene(s),
          tissue(s),
          lit(std::ranges::any_of(s.lights, shines) || !s.environment.isBlack()),
          glows(tissue.anywhere([](const Material& m) { return m.emission; })) {}

    bool scattersOften() const { return scene.model == Model::multipleScattering && scene.maxBounces > 1; }
};

/// Returns why scattering at events cannot affect the image; empty if it can. `fromWithin`: light that tissue emits
/// counts, since paths collect it from event to event.
Text whyNothingScatters(const Subject& subject, bool fromWithin = true) {
    if (!subject.tissue.any())
        return phrase("no tissue is opaque at the values that the volume holds");
    if (!subject.tissue.anywhere([](const Material& m) { return m.albedo + m.specular; }))
        return phrase("no tissue scatters light");
    if (!subject.lit && !(fromWithin && subject.glows && subject.scattersOften()))
        return subject.scene.lights.empty() ? phrase("there is no light") : phrase("no light shines");
    return {};
}

/// Returns an effect with the reason `yes` or `no`, shown as "needed: YES" or "off: NO".
Effect effect(Text name, bool needed, Text yes, Text no, std::uint32_t features = 0,
              void (*leaveOut)(Scene&) = nullptr) {
    return {std::move(name), needed, needed ? std::move(yes) : std::move(no), features, leaveOut};
}

/// Returns an effect that is off for `reason`.
Effect off(Text name, Text reason) {
    return effect(std::move(name), false, {}, std::move(reason));
}

Effect shadows(const Subject& subject) {
    if (isProjection(subject.scene.model))
        return off(phrase("shadows"), phrase("the model has none"));
    if (const Text why = whyNothingScatters(subject, false); !why.empty())
        return off(phrase("shadows"), why);
    return effect(phrase("shadows"), !subject.scene.unshadowed, phrase("light crosses tissue on its way"),
                  phrase("light is let through everything, to see what shadows do"), 0,
                  [](Scene& s) { s.unshadowed = true; });
}

/// Returns a bound on the gradient of the cut faces [HU/mm], see cutSteepness(); 0 if nothing is cut.
double steepestCut(const Scene& scene) {
    double steepest = 0;
    for (const ClipPlane& plane : scene.clip.planesThrough(scene.volume->geometry())) {
        const glm::dmat3 axes(scene.volume->geometry().patientFromIndex);
        const double voxelMm = glm::length(glm::transpose(axes) * glm::normalize(plane.normal));
        const float highest = float(scene.volume->storedRange().highest) + kHuSlack;
        steepest = std::max(steepest, double(cutSteepness(highest, float(voxelMm))));
    }
    return steepest;
}

/// Returns a bound on the gradient at the edges of the mask [HU/mm], see seenGradient(); 0 if everything is visible.
double steepestMask(const Scene& scene) {
    if (!scene.mask)
        return 0;
    const dmat3 perMm = glm::transpose(glm::inverse(dmat3(scene.volume->geometry().patientFromIndex)));
    double nodesPerMm = 0;  // across the layers of nodes along i, j and k: on a sheared grid, slopes may add up
    for (int axis = 0; axis < 3; ++axis)
        nodesPerMm += glm::length(perMm[axis]) / double(1 << scene.mask->grid().shift[axis]);
    const float highest = float(scene.volume->storedRange().highest) + kHuSlack;
    return double(cutSteepness(highest, 1)) * nodesPerMm;
}

/// Returns whether some random number makes an event a surface; see normalAt(). The smallest one is 2^-24.
bool surfacesCanShow(const Subject& subject) {
    constexpr double kRounding = 1 + 1e-5;
    const double highest =
        subject.tissue.highestOpacity() * double(surfaceFactorOf(highestGradientFactor(subject.scene))) *
        std::max(subject.tissue.steepest() + steepestMask(subject.scene), steepestCut(subject.scene));
    return highest * kRounding > 0x1p-24;
}

Effect surfaces(const Subject& subject) {
    const Text name = phrase("surface reflection");
    if (isProjection(subject.scene.model))
        return off(name, phrase("the model has none"));
    if (highestGradientFactor(subject.scene) == 0)
        return off(name, phrase("the gradient factor is 0"));
    if (const Text why = whyNothingScatters(subject); !why.empty())
        return off(name, why);
    return effect(name, surfacesCanShow(subject), phrase("the gradient factor is above 0"),
                  phrase("at this gradient factor no edge is ever steep enough"), kSurface, [](Scene& s) {
                      s.gradientFactor = 0;
                      for (PartCurve& part : s.parts.curves)
                          part.gradientFactor = {};
                  });
}

Effect softEdges(const Subject& subject) {
    const Text name = phrase("rays outside soft edges");
    if (!surfaces(subject).needed)
        return off(name, phrase("there are no surfaces"));
    const bool outside = subject.scene.rayOrigin == RayOrigin::outsideEdge;
    return effect(name, outside && subject.scene.estimator != Estimator::kroesMarch,
                  phrase("rays to the light leave surfaces one voxel out"),
                  phrase("rays to the light start at their event"), 0,
                  [](Scene& s) { s.rayOrigin = RayOrigin::event; });
}

Effect highlights(const Subject& subject) {
    if (!surfaces(subject).needed)
        return off(phrase("highlights"), phrase("there are no surfaces"));
    const bool shiny = subject.tissue.anywhere([](const Material& m) { return m.specular; });
    return effect(phrase("highlights"), shiny, phrase("a point of the curve is specular"),
                  speaksOfHighlights(subject.scene) ? phrase("the volume holds no values that are specular")
                                                    : phrase("no point of the curve is specular"),
                  0, [](Scene& s) {
                      forEachFunction(s, [](TransferFunction& function) {
                          for (TransferNode& node : function.nodes)
                              node.specular = vec3(0);
                      });
                  });
}

Effect directedScattering(const Subject& subject) {
    const Text name = phrase("directed scattering");
    if (isProjection(subject.scene.model))
        return off(name, phrase("the model does not scatter"));
    if (subject.scene.phaseG == 0)
        return off(name, phrase("phase g is 0: the same to all sides"));
    const Text why = whyNothingScatters(subject);
    return effect(name, why.empty(), phrase("phase g is not 0"), why, 0, [](Scene& s) { s.phaseG = 0; });
}

Effect emission(const Subject& subject) {
    const Model model = subject.scene.model;
    if (model == Model::absorption || model == Model::maximumIntensity)
        return off(phrase("emission"), phrase("the model shows no light from within"));
    bool emits = false;
    forEachFunction(subject.scene, [&](const TransferFunction& function) {
        for (const TransferNode& node : function.nodes)
            emits = emits || !isBlack(node.emission);
    });
    const std::uint32_t features = isProjection(model) ? 0u : std::uint32_t(kEmission);
    return effect(phrase("emission"), subject.glows, phrase("a point of the curve emits light"),
                  emits ? phrase("no opaque tissue that the volume holds emits light")
                        : phrase("no point of the curve emits light"),
                  features, [](Scene& s) {
                      forEachFunction(s, [](TransferFunction& function) {
                          for (TransferNode& node : function.nodes)
                              node.emission = vec3(0);
                      });
                  });
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

Effect depthOfField(const Scene& scene) {
    return effect(phrase("depth of field"), scene.camera.apertureMm > 0, phrase("the lens is open"),
                  phrase("the aperture is 0"), 0, [](Scene& s) { s.camera.apertureMm = 0; });
}

Effect clipping(const Scene& scene) {
    const bool cuts = !scene.clip.planesThrough(scene.volume->geometry()).empty() || !scene.clip.freehand.empty();
    return effect(
        phrase("clipping"), cuts, phrase("a box, a plane or a drawn line cuts into the volume"),
        scene.clip.empty() ? phrase("nothing is cut away") : phrase("what is cut away lies outside the volume"), 0,
        [](Scene& s) { s.clip = {}; });
}

Effect hiding(const Scene& scene) {
    return effect(phrase("hidden parts"), scene.mask != nullptr, phrase("a part of the body is not shown"),
                  phrase("everything is shown"), 0, [](Scene& s) {
                      s.mask = nullptr;
                      s.visible = {};
                  });
}

Effect materialsOfParts(const Scene& scene) {
    const Text name = phrase("materials of parts");
    if (scene.model == Model::maximumIntensity)
        return off(name, phrase("the model shows values, not light"));
    if (!scene.parts.map)
        return off(name, phrase("no part of the body has a material of its own"));
    const bool differ = std::ranges::any_of(scene.parts.curves, [&](const PartCurve& part) {
        return part.transferFunction != scene.transferFunction ||
               part.gradientFactor.value_or(scene.gradientFactor) != scene.gradientFactor;
    });
    return effect(name, differ, phrase("a part of the body has a material of its own"),
                  phrase("all parts are of the same material"), 0, [](Scene& s) { s.parts = {}; });
}

Effect bounces(const Subject& subject) {
    const Text name = phrase("multiple scattering");
    const Scene& scene = subject.scene;
    if (isProjection(scene.model))
        return off(name, phrase("the model does not scatter"));
    if (scene.model == Model::singleScattering)
        return off(name, phrase("the model has one event on a path"));
    if (scene.maxBounces == 1)
        return off(name, phrase("a path may have one event only"));
    const Text why = whyNothingScatters(subject);
    return effect(name, why.empty(), phrase("light is scattered on from event to event"), why, kBounces,
                  [](Scene& s) { s.model = Model::singleScattering; });
}

/// The first event that paths do not have: later ones are cut off at maxBounces, or are not part of the model.
Effect oneMoreEvent(const Subject& subject) {
    const Text name = phrase("one more event");
    const Scene& scene = subject.scene;
    const int events = scene.model == Model::singleScattering ? 1 : scene.maxBounces;
    if (isProjection(scene.model))
        return off(name, phrase("the model does not scatter"));
    if (scene.estimator == Estimator::kroesMarch)
        return off(name, phrase("the march has one event on a path"));
    if (events >= kManyEvents)
        return off(name, phrase("paths have as many events as they need"));
    if (const Text why = whyNothingScatters(subject); !why.empty())
        return off(name, why);
    Effect more = off(name, events == 1 ? phrase("paths have one event") : phrase("paths have %1 events", events));
    more.bringIn = [](Scene& s) {
        s.maxBounces = s.model == Model::singleScattering ? 2 : s.maxBounces + 1;
        s.model = Model::multipleScattering;
    };
    return more;
}

}  // namespace

std::vector<Effect> needs(const Scene& scene) {
    const Subject subject(scene);
    return {
        shadows(subject),
        surfaces(subject),
        softEdges(subject),
        highlights(subject),
        directedScattering(subject),
        placedLights(subject),
        lightsInView(scene),
        surroundings(subject),
        alongScatter(subject),
        background(scene),
        emission(subject),
        depthOfField(scene),
        clipping(scene),
        hiding(scene),
        materialsOfParts(scene),
        bounces(subject),
        oneMoreEvent(subject),
    };
}

bool searchesAlongScatter(const Scene& scene) {
    if (isProjection(scene.model))
        return false;
    if (!scene.environment.isBlack())
        return true;
    return std::ranges::any_of(scene.lights, isPlaced) &&
           (speaksOfHighlights(scene) || std::fabs(scene.phaseG) >= kSharpPhase);
}

std::uint32_t neededFeatures(const std::vector<Effect>& effects) {
    std::uint32_t features = 0;
    for (const Effect& effect : effects)
        if (effect.needed)
            features |= effect.features;
    return features;
}

}  // namespace pdr
