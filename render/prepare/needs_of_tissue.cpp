#include <algorithm>

#include "render/kernel/bounds/cell_bound.h"
#include "render/kernel/transport/event.h"
#include "render/prepare/need_subject.h"
#include "render/prepare/part_tables.h"
#include "render/scene/part_styles.h"

namespace pdr::need {
namespace {

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

/// Returns a bound on the gradient of the share of any labels [1/mm]: a step from one voxel to the next.
double steepestShare(const Scene& scene) {
    const dmat3 perMm = glm::transpose(glm::inverse(dmat3(scene.volume->geometry().patientFromIndex)));
    return glm::length(perMm[0]) + glm::length(perMm[1]) + glm::length(perMm[2]);
}

/// Returns a bound on the gradient at the edges of parts whose shape is that of their labels [HU/mm], see
/// labelGradient().
double steepestLabels(const Scene& scene) {
    const bool any = std::ranges::any_of(scene.parts.curves,
                                         [](const PartCurve& part) { return hasShapeOfLabels(part.transferFunction); });
    return scene.parts.map && any ? kLabelStepHu * steepestShare(scene) : 0;
}

/// Returns a bound on what parts add to the gradient where they end [HU/mm], see partGradient().
double steepestEnds(const Scene& scene) {
    return scene.parts.map ? kPartStepHu * steepestShare(scene) : 0;
}

/// Returns whether some random number makes an event a surface; see normalAt(). The smallest one is 2^-24.
bool surfacesCanShow(const Subject& subject) {
    constexpr double kRounding = 1 + 1e-5;
    const double highest =
        subject.tissue.highestOpacity() * double(surfaceFactorOf(highestGradientFactor(subject.scene))) *
        std::max({subject.tissue.steepest() + steepestMask(subject.scene) + steepestEnds(subject.scene),
                  steepestCut(subject.scene), steepestLabels(subject.scene)});
    return highest * kRounding > 0x1p-24;
}

}  // namespace

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
    if (!showsParts(scene.model))
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

}  // namespace pdr::need
