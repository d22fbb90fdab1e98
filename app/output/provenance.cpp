#include "app/output/provenance.h"

#include <cmath>

#include "render/base/version.h"
#include "render/prepare/needs.h"
#include "render/prepare/warnings.h"
#include "render/scene/not_shown.h"
#include "render/scene/scene.h"
#include "render/scene/scene_file.h"
#include "render/session/known_bias.h"

namespace pdr::app {

std::string scheduleText(const Schedule& schedule) {
    if (schedule.kind == Schedule::Kind::pd)
        return {};
    return std::string("Exposure Render's ") + (schedule.redundant ? "K0" : "K1") +
           (schedule.filter ? ", blurred" : "");
}

BiasFacts biasFactsOf(const Scene& scene, const Rendered& rendered) {
    BiasFacts facts = biasFacts(scene, rendered.status, rendered.device);
    facts.measured = rendered.bias;
    return facts;
}

namespace {

std::string biasText(const Scene& scene, const Rendered& rendered) {
    std::string text;
    for (const Bias& bias : biases(biasFactsOf(scene, rendered)))
        text += (text.empty() ? "" : "; ") + bias.text;
    return text;
}

std::string effectsText(const Scene& scene) {
    std::string text;
    for (const Effect& effect : needs(scene))
        if (effect.needed)
            text += (text.empty() ? "" : ", ") + effect.name;
    return text;
}

std::string skyText(const Environment& environment) {
    if (!environment.image)
        return {};
    const ivec2 size = environment.image->size;
    return std::to_string(size.x) + " x " + std::to_string(size.y) + ", turned by " +
           std::to_string(std::lround(environment.rotationDegrees)) + " degrees";
}

}  // namespace

Provenance provenanceOf(const Scene& scene, const Rendered& rendered) {
    return {.status = rendered.status,
            .exposure = rendered.tone.exposure,
            .toneCurve = toneCurveName(rendered.tone.curve),
            .seconds = rendered.seconds,
            .seed = scene.seed,
            .model = modelName(scene.model),
            .extinctionPerMm = scene.transferFunction.extinctionPerMm,
            .program = "PD-Render " PDR_VERSION,
            .device = rendered.device,
            .nodes = checksText(rendered.checks),
            .effects = effectsText(scene),
            .look = scene.lookName,
            .sky = skyText(scene.environment),
            .camera = cameraText(scene.camera),
            .bias = biasText(scene, rendered),
            .estimator = scene.estimator == Estimator::unbiased ? "" : "kroesMarch (biased)",
            .schedule = scheduleText(scene.schedule),
            .warnings = warningNames(warnings(scene)),
            .hidden = scene.volume ? scene.volume->hidden() : std::string(),
            .cut = cutText(scene.clip),
            .notShown = notShown(scene),
            .remarks = scene.volume ? scene.volume->remarks() : std::string()};
}

}  // namespace pdr::app
