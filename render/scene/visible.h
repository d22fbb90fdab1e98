#pragma once
/// What of a patient a picture shows. The choice is stored; the mask that it makes of a scan is not
/// (scene/visible_mask.h).

namespace pdr {

/// Told apart by rules of geometry and density, so that nothing has to be drawn.
enum class BodyPart {
    everything,
    lungs,        ///< with their vessels, without the outermost millimetres
    bones,        ///< crudely: what hangs together with dense bone
    withoutBones  ///< all but those
};
inline constexpr BodyPart kBodyParts[] = {BodyPart::everything, BodyPart::lungs, BodyPart::bones,
                                          BodyPart::withoutBones};

/// As files and options write it: "withoutBones".
const char* bodyPartName(BodyPart part);

struct Visible {
    BodyPart part = BodyPart::everything;
    double peelMm = 0;  ///< so much is taken off all around the body; [0, 50]

    bool all() const { return *this == Visible{}; }
    bool operator==(const Visible&) const = default;
};

}  // namespace pdr
