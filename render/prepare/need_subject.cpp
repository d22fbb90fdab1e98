#include "render/prepare/need_subject.h"

#include <algorithm>

namespace pdr::need {
namespace {

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

}  // namespace

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

bool speaksOfHighlights(const Scene& scene) {
    bool speaks = false;
    forEachFunction(scene, [&](const TransferFunction& function) { speaks = speaks || allowsHighlights(function); });
    return speaks && highestGradientFactor(scene) > 0;
}

Subject::Subject(const Scene& s)
    : scene(s),
      tissue(s),
      lit(std::ranges::any_of(s.lights, shines) || !s.environment.isBlack()),
      glows(tissue.anywhere([](const Material& m) { return m.emission; })) {}

Text whyNothingScatters(const Subject& subject, bool fromWithin) {
    if (!subject.tissue.any())
        return phrase("no tissue is opaque at the values that the volume holds");
    if (!subject.tissue.anywhere([](const Material& m) { return m.albedo + m.specular; }))
        return phrase("no tissue scatters light");
    if (!subject.lit && !(fromWithin && subject.glows && subject.scattersOften()))
        return subject.scene.lights.empty() ? phrase("there is no light") : phrase("no light shines");
    return {};
}

Effect effect(Text name, bool needed, Text yes, Text no, std::uint32_t features, void (*leaveOut)(Scene&)) {
    return {std::move(name), needed, needed ? std::move(yes) : std::move(no), features, leaveOut};
}

Effect off(Text name, Text reason) {
    return effect(std::move(name), false, {}, std::move(reason));
}

}  // namespace pdr::need
