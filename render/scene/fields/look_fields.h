#pragma once
/// Names, ranges and meanings of the fields of looks and sessions.

#include "render/scene/fields/part_fields.h"
#include "render/scene/fields/rig_fields.h"
#include "render/scene/fields/scene_fields.h"
#include "render/scene/fields/volume_fields.h"
#include "render/scene/image_setup.h"

namespace pdr {

inline constexpr Words<ToneCurve, 2> kToneCurveWords{{{toneCurveName(ToneCurve::perChannel), ToneCurve::perChannel},
                                                      {toneCurveName(ToneCurve::keepsHue), ToneCurve::keepsHue}}};

template <class Visit>
void describe(Visit& visit, Look& look) {
    PhaseField phase{look.phaseG};
    SurfaceField surface{look.gradientFactor, look.rayOrigin};
    RigFields rig{look.rig, look.environment};
    visit.object({"transferFunction", "how Hounsfield units become optics", {}, kRequired}, look.transferFunction);
    visit.object({"window", "what `maximumIntensity` shows black and white"}, look.window);
    visit.object({"phase", "how tissue scatters"}, phase);
    visit.object({"surface", "how readily an edge reflects like a surface"}, surface);
    visit.object({"lights", "the rig of lights, and the environment"}, rig);
    visit({"exposure", "radiance that is shown as 1 - 1/e", {0, 1e30f, false}}, look.display.exposure);
    visit.word({"toneCurve",
                "how the channels of a colour become levels: `keepsHue`, the largest one by the curve, the others in "
                "proportion, then towards white; or `perChannel`, each alone, which turns bright ivory yellow"},
               look.display.curve, kToneCurveWords);
    visit.object({"visible", "which part of the patient is shown"}, look.visible);
    visit({"ctDenoised", "whether the CT is shown with less noise than it has; images say so"}, look.ctDenoised);
    std::optional<PartStyles> parts = look.parts.empty() ? std::nullopt : std::optional(look.parts);
    visit.object({"parts", "how the parts of a label map are shown, where the scan has them"}, parts);
    if constexpr (Visit::kReads)
        look.parts = parts.value_or(PartStyles{});
}

template <class Visit>
void describe(Visit& visit, ImageSetup& setup) {
    visit.object({"look", "how tissue looks", {}, kRequired}, setup.look);
    visit({"lookName", "what the user calls it"}, setup.lookName);
    visit({"lookChanged", "whether it was that look, and has been changed since"}, setup.lookChanged);
    visit({"stops", "brightness against the look's; one more is twice as bright", {-64, 64}}, setup.stops);
    visit.object({"camera", "from where it is seen", {}, kRequired}, setup.camera);
    visit({"background", "colour: radiance behind the volume instead of the environment; it lights nothing", kRadiance},
          setup.background);
    visit.object({"clip", "what is cut away"}, setup.clip);
    visit.word({"table", "whether the scanner's table and the head holder are seen"}, setup.table, kTableWords);
    visit.word({"model", "optical model"}, setup.model, kModelWords);
    visit.word({"estimator", "`unbiased`, or `kroesMarch`, as in scene files"}, setup.estimator, kEstimatorWords);
    visit.object({"schedule", "how iterations become displayed frames"}, setup.schedule);
}

}  // namespace pdr
