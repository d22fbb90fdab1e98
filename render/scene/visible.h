#pragma once
/// The part of a patient that an image shows. The choice is stored; the mask that it yields for a scan is not
/// (scene/visible_mask.h).

namespace pdr {

/// Parts of the body that rules of geometry and density tell apart, so that nothing has to be drawn.
enum class BodyPart {
    everything,
    lungs,        ///< lungs with their vessels, without the outermost millimetres
    bones,        ///< roughly: everything connected to dense bone
    withoutBones  ///< everything but `bones`
};
inline constexpr BodyPart kBodyParts[] = {BodyPart::everything, BodyPart::lungs, BodyPart::bones,
                                          BodyPart::withoutBones};

/// Returns the part's word in files and options: "withoutBones".
const char* bodyPartName(BodyPart part);

struct Visible {
    BodyPart part = BodyPart::everything;
    double peelMm = 0;  ///< thickness that is removed all around the body; [0, 50]

    bool all() const { return *this == Visible{}; }
    bool operator==(const Visible&) const = default;
};

}  // namespace pdr
