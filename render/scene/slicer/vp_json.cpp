#include "render/scene/slicer/vp_json.h"

#include <nlohmann/json.hpp>

#include "render/scene/json_fields.h"

namespace pdr::slicer {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kSchema =
    "https://raw.githubusercontent.com/Slicer/Slicer/main/Modules/Loadable/VolumeRendering/Resources/Schema/"
    "volume-property-schema-v1.0.0.json#";

void readIfThere(JsonFields& fields, std::string_view name, auto& value) {
    if (fields.has(name))
        fields.required(name, value);
}

/// Returns whether a curve is straight from this point to the next.
bool isStraight(JsonFields& point) {
    double middle = 0.5, sharpness = 0;
    readIfThere(point, "midpoint", middle);
    readIfThere(point, "sharpness", sharpness);
    return middle == 0.5 && sharpness == 0;
}

void readCurves(JsonFields component, VolumeProperty& property) {
    JsonFields opacity = component.object("scalarOpacity");
    for (JsonFields point : opacity.objects("points")) {
        CurvePoint& read = property.opacity.emplace_back();
        point.required("x", read.hu);
        point.required("y", read.value);
        property.simplified |= !isStraight(point);
    }
    JsonFields colour = component.object("rgbTransferFunction");
    for (JsonFields point : colour.objects("points")) {
        ColourStop& read = property.colours.emplace_back();
        point.required("x", read.hu);
        point.required("color", read.albedo);
        property.simplified |= !isStraight(point);
    }
    bool ignored = false;
    readIfThere(component, "disableGradientOpacity", ignored);
    if (ignored || !component.has("gradientOpacity"))
        return;
    JsonFields gradient = component.object("gradientOpacity");
    for (JsonFields point : gradient.objects("points")) {
        double factor = 1;
        point.required("y", factor);
        property.simplified |= factor != 1;
    }
}

void readComponent(JsonFields component, VolumeProperty& property) {
    property.shade = false;
    readIfThere(component, "shade", property.shade);
    readIfThere(component, "scalarOpacityUnitDistance", property.unitDistanceMm);
    if (component.has("lighting")) {
        JsonFields lighting = component.object("lighting");
        lighting.required("ambient", property.ambient);
        lighting.required("diffuse", property.diffuse);
        lighting.required("specular", property.specular);
        lighting.required("specularPower", property.specularPower);
    }
    readCurves(component, property);
}

JsonFields firstOf(JsonFields& fields, std::string_view name) {
    const std::vector<JsonFields> list = fields.objects(name);
    if (list.empty())
        fields.fail(name, phrase("is empty"));
    return list.front();
}

}  // namespace

Result<VolumeProperty> propertyFromJson(std::string_view text, std::string_view where) {
    VolumeProperty property;
    const auto read = [&](JsonFields& file) {
        JsonFields first = firstOf(file, "volumeProperties");
        readIfThere(first, "scatteringAnisotropy", property.anisotropy);
        readComponent(firstOf(first, "components"), property);
    };
    if (auto ok = readForeignJson(text, where, read); !ok)
        return ok.error();
    return property;
}

std::string jsonOf(const VolumeProperty& property) {
    Json opacity = Json::array(), colours = Json::array();
    for (const CurvePoint& point : property.opacity)
        opacity.push_back({{"x", point.hu}, {"y", point.value}, {"midpoint", 0.5}, {"sharpness", 0}});
    for (const ColourStop& stop : property.colours)
        colours.push_back({{"x", stop.hu},
                           {"color", {stop.albedo.x, stop.albedo.y, stop.albedo.z}},
                           {"midpoint", 0.5},
                           {"sharpness", 0}});
    const Json component = {{"shade", property.shade},
                            {"lighting",
                             {{"diffuse", property.diffuse},
                              {"ambient", property.ambient},
                              {"specular", property.specular},
                              {"specularPower", property.specularPower}}},
                            {"disableGradientOpacity", true},
                            {"scalarOpacityUnitDistance", property.unitDistanceMm},
                            {"scalarOpacity", {{"type", "piecewiseLinearFunction"}, {"points", opacity}}},
                            {"rgbTransferFunction", {{"type", "colorTransferFunction"}, {"points", colours}}}};
    const Json whole = {{"effectiveRange", {property.opacity.front().hu, property.opacity.back().hu}},
                        {"interpolationType", "linear"},
                        {"scatteringAnisotropy", property.anisotropy},
                        {"components", Json::array({component})}};
    return Json{{"@schema", kSchema}, {"volumeProperties", Json::array({whole})}}.dump(2) + "\n";
}

}  // namespace pdr::slicer
