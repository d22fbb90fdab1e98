#pragma once
/// A look with its name, the settings that come with it, and its files.

#include <optional>
#include <string>
#include <string_view>

#include "render/base/result.h"
#include "render/scene/image_setup.h"
#include "render/scene/look.h"
#include "render/segment/findings.h"

namespace pdr {

enum class LookGroup { head, chest, abdomen, vessels, bones, lungs, skin, xray, mip, implants, own };

/// A planar cut that shows what a look is about. It removes everything in front of a coronal plane, on the left of a
/// sagittal one, or above an axial one.
struct CutHint {
    enum class Plane { coronal, sagittal, axial };
    Plane plane = Plane::coronal;
    float at = 0.5f;  ///< fraction of the body's box that is cut away; [0, 1]
    bool operator==(const CutHint&) const = default;
};

/// The scans that a look suits. True: only scans that have the feature; false: only scans that lack it; none: both.
struct Suits {
    std::optional<bool> trunk;     ///< a body wider than a head
    std::optional<bool> lungs;     ///< more than 500 ml of lungs
    std::optional<bool> contrast;  ///< contrast agent in the blood
    std::optional<bool> metal;     ///< more than 1 ml
    bool operator==(const Suits&) const = default;
};

struct NamedLook {
    std::string name;  ///< "Bone"; unique among all looks
    LookGroup group = LookGroup::own;
    std::string doesNotShow;  ///< what its images do not show, in a sentence or two; empty: nothing worth mentioning
    Suits suits;
    std::optional<float> bloodHu;  ///< HU of the blood that the curve was drawn for; [100, 1000]; none: any blood
    Model model = Model::singleScattering;
    std::optional<CutHint> cut;
    Look look;
    bool operator==(const NamedLook&) const = default;
};

/// Reads one look from JSON text ("format": "pdrender-look"). `where` is used in error texts.
Result<NamedLook> lookFromJson(std::string_view json, std::string_view where);
/// Returns the text that lookFromJson() reads as an equal look, to the bit. Environment images are not written.
std::string lookText(NamedLook look);

/// Returns why a look does not suit a scan, in a clause: "no lungs are in this scan"; empty if it does.
std::string whyUnsuited(const NamedLook& look, const segment::Findings& findings);

/// Returns `look` adapted to blood of `bloodHu`, which is clamped to [100, 1000]. Nodes and window limits below 60 HU
/// and above 1500 HU stay; between them they are stretched so that the blood looks as it was drawn. A look without
/// NamedLook::bloodHu is returned unchanged.
NamedLook fittedTo(NamedLook look, float bloodHu);

/// Returns the plane of `cut` through a body whose box is `bodyBox`.
ClipPlane planeOf(const CutHint& cut, const VolumeGeometry& bodyBox);

/// Returns `setup` with everything that the look sets, at the brightness of `setup`. The look's cut is used only if
/// nothing else is cut away.
ImageSetup withNamedLook(ImageSetup setup, const NamedLook& look, const VolumeGeometry& bodyBox);

/// Returns `scene` with everything that the look sets; volume, camera, film, seed and revision stay.
Scene withNamedLook(Scene scene, const NamedLook& look, const VolumeGeometry& bodyBox);

}  // namespace pdr
