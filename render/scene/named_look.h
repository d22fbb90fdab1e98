#pragma once
/// A look with its name and all that comes with it, and its files.

#include <optional>
#include <string>
#include <string_view>

#include "render/base/result.h"
#include "render/scene/look.h"
#include "render/scene/picture_setup.h"
#include "render/segment/findings.h"

namespace pdr {

enum class LookGroup { head, chest, abdomen, vessels, bones, lungs, skin, xray, mip, implants, own };

/// A flat cut that shows what a look is about. What lies before it is cut away: in front of a coronal plane, on the
/// left of a sagittal one, above an axial one.
struct CutHint {
    enum class Plane { coronal, sagittal, axial };
    Plane plane = Plane::coronal;
    float at = 0.5f;  ///< how much of the body's box is cut away; [0, 1]
    bool operator==(const CutHint&) const = default;
};

/// Of which scans a look makes sense: only of those that have something, or only of those that have not.
struct Suits {
    std::optional<bool> trunk;     ///< a body wider than a head
    std::optional<bool> lungs;     ///< more than 500 ml of them
    std::optional<bool> contrast;  ///< in the blood
    std::optional<bool> metal;     ///< more than 1 ml
    bool operator==(const Suits&) const = default;
};

struct NamedLook {
    std::string name;  ///< "Bone"; of all looks another
    LookGroup group = LookGroup::own;
    std::string doesNotShow;  ///< a sentence or two; empty: nothing worth a word
    Suits suits;
    std::optional<float> bloodHu;  ///< of the blood that the curve was drawn for; [100, 1000]; none: it goes with any
    Model model = Model::singleScattering;
    std::optional<CutHint> cut;
    Look look;
    bool operator==(const NamedLook&) const = default;
};

/// Reads one look from JSON text ("format": "pdrender-look"). `where` is used in error texts.
Result<NamedLook> lookFromJson(std::string_view json, std::string_view where);
/// The text that lookFromJson() reads as an equal look, to the bit. Pictures of surroundings are not written.
std::string lookText(NamedLook look);

/// Why it makes no sense of a scan, in a clause: "no lungs are in this scan". Empty: it does.
std::string whyUnsuited(const NamedLook& look, const segment::Findings& findings);

/// `look` for blood of `bloodHu`, which is kept in [100, 1000]: nodes and window below 60 HU and above 1500 stay,
/// between them they are stretched so that blood looks as it was drawn. The look as it is where that does not matter.
NamedLook fittedTo(NamedLook look, float bloodHu);

/// The plane of `cut` through a body in `bodyBox`.
ClipPlane planeOf(const CutHint& cut, const VolumeGeometry& bodyBox);

/// `setup` with all that the look says, at the brightness that it has. It is cut as the look says only where nothing
/// else is cut away.
PictureSetup withNamedLook(PictureSetup setup, const NamedLook& look, const VolumeGeometry& bodyBox);

/// `scene` likewise; volume, camera, film, seed and revision stay.
Scene withNamedLook(Scene scene, const NamedLook& look, const VolumeGeometry& bodyBox);

}  // namespace pdr
