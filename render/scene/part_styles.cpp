#include "render/scene/part_styles.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "render/scene/range.h"
#include "render/scene/scene.h"

namespace pdr {
namespace {

constexpr std::size_t kMostStyles = LabelMap::kMostParts;

/// Returns a colour of the screen as linear Rec. 709.
vec3 linear(const LabelColour& colour) {
    const auto channel = [](std::uint8_t level) {
        const float c = float(level) / 255;
        return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
    };
    return {channel(colour[0]), channel(colour[1]), channel(colour[2])};
}

TransferFunction inState(TransferFunction curve, PartState state) {
    if (state == PartState::ghost)
        curve.extinctionPerMm = std::min(curve.extinctionPerMm, kGhostPerMm);
    if (state == PartState::hidden)
        curve.nodes = {{.opacity = 0}};
    return curve;
}

TransferFunction inColour(TransferFunction curve, const vec3& albedo) {
    for (TransferNode& node : curve.nodes)
        node.albedo = albedo;
    return curve;
}

TransferFunction curveOf(const MappedPart& part, const PartStyles& styles, const TransferFunction& common) {
    const PartStyle style = styleOf(styles, part.name);
    TransferFunction curve = style.transferFunction.value_or(common);
    if (style.colour)
        curve = inColour(std::move(curve), *style.colour);
    else if (styles.inColour && !style.transferFunction)
        curve = inColour(std::move(curve), linear(part.colour));
    return inState(std::move(curve), style.state);
}

}  // namespace

Result<void> check(const PartStyles& styles) {
    if (styles.styles.size() > kMostStyles)
        return Error{phrase("has more than %1 styles", kMostStyles), "parts.styles", ""};
    std::set<std::string> names;
    for (std::size_t i = 0; i < styles.styles.size(); ++i) {
        const PartStyle& style = styles.styles[i];
        const std::string where = "parts.styles[" + std::to_string(i) + "]";
        if (!names.insert(style.part).second)
            return Error{phrase("is the name of two styles"), where + ".part", ""};
        if (style.transferFunction)
            if (const Result<void> ok = style.transferFunction->check(); !ok)
                return below(where, ok.error());
    }
    return {};
}

PartStyle styleOf(const PartStyles& styles, const std::string& part) {
    const auto style = std::ranges::find(styles.styles, part, &PartStyle::part);
    return style != styles.styles.end() ? *style : PartStyle{.part = part};
}

PartStyles withStyle(PartStyles styles, PartStyle style) {
    const auto before = std::ranges::find(styles.styles, style.part, &PartStyle::part);
    const bool saysNothing = style == PartStyle{.part = style.part};
    if (before == styles.styles.end() && !saysNothing)
        styles.styles.push_back(std::move(style));
    else if (before != styles.styles.end() && saysNothing)
        styles.styles.erase(before);
    else if (before != styles.styles.end())
        *before = std::move(style);
    return styles;
}

bool showsParts(Model model) {
    return !isProjection(model) || model == Model::absorption;
}

Scene withParts(Scene scene, std::shared_ptr<const LabelMap> map, const PartStyles& styles) {
    if (!map || !showsParts(scene.model))
        return scene;
    const TransferFunction common = std::exchange(scene.transferFunction, inState(scene.transferFunction, styles.rest));
    Parts parts;
    for (std::size_t n = 0; n < map->parts.size(); ++n)
        if (TransferFunction curve = curveOf(map->parts[n], styles, common); curve != scene.transferFunction)
            parts.curves.push_back({std::uint8_t(n + 1), std::move(curve)});
    if (!parts.curves.empty())
        parts.map = std::move(map);
    scene.parts = std::move(parts);
    return scene;
}

}  // namespace pdr
