#include "render/prepare/needs.h"

#include "render/kernel/features.h"
#include "render/prepare/need_subject.h"

namespace pdr {
namespace need {
namespace {

constexpr int kManyEvents = 64;  ///< number of events after which the next one changes nothing visible

Effect depthOfField(const Scene& scene) {
    return effect(phrase("depth of field"), scene.camera.apertureMm > 0, phrase("the lens is open"),
                  phrase("the aperture is 0"), 0, [](Scene& s) { s.camera.apertureMm = 0; });
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
}  // namespace need

std::vector<Effect> needs(const Scene& scene) {
    using namespace need;
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

std::uint32_t neededFeatures(const std::vector<Effect>& effects) {
    std::uint32_t features = 0;
    for (const Effect& effect : effects)
        if (effect.needed)
            features |= effect.features;
    return features;
}

}  // namespace pdr
