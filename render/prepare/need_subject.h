#pragma once
/// What the effects of a scene are judged by, and the effects, for needs().

#include "render/prepare/met_tissue.h"
#include "render/prepare/needs.h"
#include "render/scene/scene.h"

namespace pdr::need {

inline bool isBlack(vec3 colour) {
    return colour == vec3(0);
}

bool shines(const Light& light);

/// Calls visit(function) for the scene's own transfer function and for those of its parts.
template <class AnyScene, class Visit>
void forEachFunction(AnyScene& scene, Visit&& visit) {
    visit(scene.transferFunction);
    for (auto& part : scene.parts.curves)
        visit(part.transferFunction);
}

/// Returns whether a curve of the scene allows highlights, whatever the volume holds.
bool speaksOfHighlights(const Scene& scene);

/// A scene and its visible tissue.
struct Subject {
    const Scene& scene;
    MetTissue tissue;
    bool lit;    ///< a light or the environment shines
    bool glows;  ///< visible tissue emits light

    explicit Subject(const Scene& scene);

    bool scattersOften() const { return scene.model == Model::multipleScattering && scene.maxBounces > 1; }
};

/// Returns why scattering at events cannot affect the image; empty if it can. `fromWithin`: light that tissue emits
/// counts, since paths collect it from event to event.
Text whyNothingScatters(const Subject& subject, bool fromWithin = true);

/// Returns an effect with the reason `yes` or `no`, shown as "needed: YES" or "off: NO".
Effect effect(Text name, bool needed, Text yes, Text no, std::uint32_t features = 0,
              void (*leaveOut)(Scene&) = nullptr);

/// Returns an effect that is off for `reason`.
Effect off(Text name, Text reason);

// Effects of tissue and its surfaces (needs_of_tissue.cpp)
Effect surfaces(const Subject& subject);
Effect softEdges(const Subject& subject);
Effect highlights(const Subject& subject);
Effect directedScattering(const Subject& subject);
Effect emission(const Subject& subject);
Effect clipping(const Scene& scene);
Effect hiding(const Scene& scene);
Effect materialsOfParts(const Scene& scene);

// Effects of light and of what lies behind (needs_of_light.cpp)
Effect shadows(const Subject& subject);
Effect placedLights(const Subject& subject);
Effect lightsInView(const Scene& scene);
Effect surroundings(const Subject& subject);
Effect alongScatter(const Subject& subject);
Effect background(const Scene& scene);

}  // namespace pdr::need
