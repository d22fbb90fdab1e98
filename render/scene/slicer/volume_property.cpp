#include "render/scene/slicer/volume_property.h"

#include <algorithm>
#include <cmath>

#include "render/base/srgb.h"
#include "render/scene/range.h"

namespace pdr::slicer {
namespace {

constexpr double kOpaque = 0.995;      ///< opacity that counts as 1, whose extinction would be infinite
constexpr float kLongestStep = 0.25f;  ///< largest step of opacity between two points of extinction
constexpr float kShadedEdges = 3;      ///< gradient factor of shaded volumes
constexpr double kDielectric = 0.2;    ///< reflectance of Slicer's specular 1: its 0.2 then is that of tissue, 0.04

Result<void> checkAscending(const auto& points, const char* what) {
    const std::string where(what);
    if (points.empty())
        return Error{phrase("has no points"), where, ""};
    if (points.size() > 1000)
        return Error{phrase("has more than 1000 points"), where, ""};
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (auto ok = checkRange(double(points[i].hu), {kLowestHu, kHighestHu}, where); !ok)
            return ok;
        if (i > 0 && points[i].hu < points[i - 1].hu)
            return Error{phrase("has points that do not ascend"), where, ""};
    }
    return {};
}

Result<void> check(const VolumeProperty& property) {
    if (auto ok = checkAscending(property.opacity, "opacity"); !ok)
        return ok;
    if (auto ok = checkAscending(property.colours, "colour"); !ok)
        return ok;
    for (const CurvePoint& point : property.opacity)
        if (auto ok = checkRange(double(point.value), {0, 1}, "opacity"); !ok)
            return ok;
    for (const ColourStop& stop : property.colours)
        if (auto ok = checkRange(dvec3(stop.albedo), {0, 1}, "colour"); !ok)
            return ok;
    if (auto ok = checkRange(property.unitDistanceMm, {1e-6, 1e6}, "unit distance"); !ok)
        return ok;
    if (auto ok = checkRange(property.anisotropy, {-1, 1}, "anisotropy"); !ok)
        return ok;
    if (auto ok = checkRange(property.specular, {0, 1}, "specular"); !ok)
        return ok;
    return checkRange(property.specularPower, {0, 1e6}, "specular power");
}

/// Returns the curve with points added between those that lie far apart in value.
Curve finer(const Curve& opacity) {
    Curve curve;
    for (const CurvePoint& point : opacity) {
        if (!curve.empty() && point.hu > curve.back().hu) {
            const CurvePoint from = curve.back();
            const int steps = int(std::ceil(std::abs(point.value - from.value) / kLongestStep));
            for (int i = 1; i < steps; ++i) {
                const float share = float(i) / float(steps);
                curve.push_back({glm::mix(from.hu, point.hu, share), glm::mix(from.value, point.value, share)});
            }
        }
        curve.push_back(point);
    }
    return curve;
}

/// Returns the roughness whose highlight is about as wide as that of Phong's cosine to that power.
float roughnessOf(double power) {
    return float(std::clamp(std::pow(2 / (power + 2), 0.25), 0.0, 1.0));
}
double powerOf(double roughness) {
    return std::clamp(2 / std::pow(std::max(roughness, 0.05), 4) - 2, 0.0, 1e5);
}

}  // namespace

Result<NamedLook> lookOf(const VolumeProperty& property, const std::string& name, const NamedLook& base) {
    if (auto ok = check(property); !ok)
        return ok.error();
    NamedLook named;
    named.name = name;
    named.look = base.look;
    if (property.simplified)
        named.doesNotShow = "Made from a file of 3D Slicer that says more: opacity by gradient, or bent curves.";
    // Map the shading to a surface
    TransferNode tissue;
    tissue.roughness = roughnessOf(property.specularPower);
    tissue.specular = vec3(property.shade ? float(kDielectric * property.specular) : 0);
    // Convert opacity of a unit distance to extinction
    Curve extinction = finer(property.opacity);
    for (CurvePoint& point : extinction)
        point.value = float(-std::log1p(-std::min(double(point.value), kOpaque)) / property.unitDistanceMm);
    const float top = std::max(heightOf(extinction), 1e-6f);
    TransferFunction function{top, {}};
    for (const CurvePoint& point : extinction) {
        tissue.hu = point.hu;
        tissue.opacity = std::min(point.value / top, 1.0f);
        function.nodes.push_back(tissue);
    }
    // Convert the colours of a screen to linear ones
    std::vector<ColourStop> colours = property.colours;
    for (ColourStop& stop : colours)
        for (int channel = 0; channel < 3; ++channel)
            stop.albedo[channel] = float(linearFromSrgb(double(stop.albedo[channel])));
    named.look.transferFunction = withColours(function, colours);
    named.look.gradientFactor = property.shade ? kShadedEdges : 0;
    named.look.phaseG = float(std::clamp(property.anisotropy, -0.99, 0.99));
    return named;
}

VolumeProperty propertyOf(const NamedLook& look) {
    const TransferFunction& function = look.look.transferFunction;
    VolumeProperty property;
    property.shade = look.look.gradientFactor > 0;
    property.anisotropy = double(look.look.phaseG);
    double specular = 0, roughness = 1;
    for (const TransferNode& node : function.nodes) {
        const double extinction = double(function.extinctionPerMm) * double(node.opacity);
        property.opacity.push_back({node.hu, float(-std::expm1(-extinction))});
        vec3 colour;
        for (int channel = 0; channel < 3; ++channel)
            colour[channel] = float(std::clamp(srgbFromLinear(double(node.albedo[channel])), 0.0, 1.0));
        property.colours.push_back({node.hu, colour});
        if (double(node.specular.y) > specular) {
            specular = double(node.specular.y);
            roughness = double(node.roughness);
        }
    }
    property.specular = std::min(specular / kDielectric, 1.0);
    property.specularPower = powerOf(roughness);
    return property;
}

}  // namespace pdr::slicer
