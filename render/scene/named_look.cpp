#include "render/scene/named_look.h"

#include <algorithm>
#include <utility>

#include "render/scene/field_check.h"
#include "render/scene/field_reader.h"
#include "render/scene/field_writer.h"
#include "render/scene/fields/named_look_fields.h"

namespace pdr {
namespace {

constexpr std::string_view kFormat = "pdrender-look";
constexpr double kTrunkMm = 260, kLungMl = 500, kMetalMl = 1;
constexpr float kSoftHu = 60, kDenseHu = 1500;  ///< contrast agent moves only values between these

Result<void> check(const NamedLook& named) {
    if (auto ok = FieldCheck::check(named); !ok)
        return ok;
    if (named.name.empty())
        return Error{phrase("must not be empty"), "name", ""};
    return check(named.look);
}

/// Returns the new place of `hu` if blood lies at `wanted` instead of `drawn`: piecewise linear and ascending.
float moved(float hu, float drawn, float wanted) {
    if (hu <= kSoftHu || hu >= kDenseHu)
        return hu;
    if (hu <= drawn)
        return kSoftHu + (hu - kSoftHu) * (wanted - kSoftHu) / (drawn - kSoftHu);
    return kDenseHu - (kDenseHu - hu) * (kDenseHu - wanted) / (kDenseHu - drawn);
}

/// Returns the direction from the patient's middle towards what is cut away: front, left or head.
dvec3 directionOf(CutHint::Plane plane) {
    switch (plane) {
        case CutHint::Plane::coronal:
            return {0, -1, 0};
        case CutHint::Plane::sagittal:
            return {1, 0, 0};
        case CutHint::Plane::axial:
            break;
    }
    return {0, 0, 1};
}

/// Sets model, estimator and cut of `image`, an ImageSetup or a Scene.
template <typename Image>
void takeModelAndCut(Image& image, const NamedLook& look, const VolumeGeometry& bodyBox) {
    image.model = look.model;
    if (image.model != Model::singleScattering)
        image.estimator = Estimator::unbiased;  // kroesMarch supports no other model
    if (look.cut && image.clip.empty())
        image.clip.planes = {planeOf(*look.cut, bodyBox)};
}

}  // namespace

Result<NamedLook> lookFromJson(std::string_view json, std::string_view where) {
    NamedLook named;
    const auto read = [&](JsonFields& fields) {
        FieldReader reader(fields);
        describe(reader, named);
        if (auto ok = check(named); !ok)
            throw FieldError{ok.error()};
    };
    if (auto ok = readJson(json, where, kFormat, read); !ok)
        return ok.error();
    return named;
}

std::string lookText(NamedLook look) {
    return jsonText(kFormat, FieldWriter::written(look));
}

std::string whyUnsuited(const NamedLook& look, const segment::Findings& findings) {
    const auto wants = [](std::optional<bool> wanted, bool there) { return wanted && *wanted != there; };
    const Suits& suits = look.suits;
    if (wants(suits.trunk, findings.widthMm > kTrunkMm))
        return *suits.trunk ? "this body is no wider than a head" : "this body is wider than a head";
    if (wants(suits.lungs, findings.lungMl > kLungMl))
        return *suits.lungs ? "no lungs are in this scan" : "lungs are in this scan";
    if (wants(suits.contrast, findings.blood.has_value()))
        return *suits.contrast ? "no contrast was found in the blood" : "there is contrast in the blood";
    if (wants(suits.metal, findings.metalMl > kMetalMl))
        return *suits.metal ? "no metal is in this body" : "metal is in this body";
    return "";
}

NamedLook fittedTo(NamedLook look, float bloodHu) {
    if (!look.bloodHu)
        return look;
    const float drawn = *look.bloodHu, wanted = std::clamp(bloodHu, 100.0f, 1000.0f);
    for (TransferNode& node : look.look.transferFunction.nodes)
        node.hu = moved(node.hu, drawn, wanted);
    for (PartStyle& style : look.look.parts.styles)
        if (style.transferFunction)
            for (TransferNode& node : style.transferFunction->nodes)
                node.hu = moved(node.hu, drawn, wanted);
    look.look.window.lowHu = moved(look.look.window.lowHu, drawn, wanted);
    look.look.window.highHu = moved(look.look.window.highHu, drawn, wanted);
    look.bloodHu = wanted;
    return look;
}

ClipPlane planeOf(const CutHint& cut, const VolumeGeometry& bodyBox) {
    const dvec3 away = directionOf(cut.plane);
    double reach = 0;  // half the extent of the box along `away` [mm]
    for (int axis = 0; axis < 3; ++axis)
        reach += 0.5 * bodyBox.size[axis] * std::abs(glm::dot(away, dvec3(bodyBox.patientFromIndex[axis])));
    return {bodyBox.centreMm() + away * (reach * (1 - 2 * double(cut.at))), away};
}

ImageSetup withNamedLook(ImageSetup setup, const NamedLook& look, const VolumeGeometry& bodyBox) {
    setup.look = look.look;
    setup.lookName = look.name;
    setup.lookChanged = false;
    takeModelAndCut(setup, look, bodyBox);
    return setup;
}

Scene withNamedLook(Scene scene, const NamedLook& look, const VolumeGeometry& bodyBox) {
    scene = withLook(std::move(scene), look.look);
    scene.lookName = look.name;
    takeModelAndCut(scene, look, bodyBox);
    return scene;
}

}  // namespace pdr
