#pragma once
/// Names, ranges and meanings of the fields of the visible part of a patient.

#include "render/scene/fields/ranges.h"
#include "render/scene/visible.h"

namespace pdr {

inline constexpr Words<BodyPart, 4> kBodyPartWords{{{"everything", BodyPart::everything},
                                                    {"lungs", BodyPart::lungs},
                                                    {"bones", BodyPart::bones},
                                                    {"withoutBones", BodyPart::withoutBones}}};

template <class Visit>
void describe(Visit& visit, Visible& visible) {
    visit.word({"part",
                "`lungs` without the outermost 5 mm, `bones` as far as they hold dense bone, `withoutBones`: all but "
                "those, or `everything`. Told apart by density and geometry, with smooth edges; no voxel is changed, "
                "and images say what is not shown"},
               visible.part, kBodyPartWords);
    visit({"peelMm", "so much is taken off all around the body, such as skin [mm]", {0, 50}}, visible.peelMm);
}

}  // namespace pdr
