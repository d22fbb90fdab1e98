#pragma once
/// Names, ranges and meanings of the fields in files of looks.

#include "render/scene/fields/look_fields.h"
#include "render/scene/named_look.h"

namespace pdr {

inline constexpr Words<LookGroup, 11> kLookGroupWords{{{"head", LookGroup::head},
                                                       {"chest", LookGroup::chest},
                                                       {"abdomen", LookGroup::abdomen},
                                                       {"vessels", LookGroup::vessels},
                                                       {"bones", LookGroup::bones},
                                                       {"lungs", LookGroup::lungs},
                                                       {"skin", LookGroup::skin},
                                                       {"xray", LookGroup::xray},
                                                       {"mip", LookGroup::mip},
                                                       {"implants", LookGroup::implants},
                                                       {"own", LookGroup::own}}};

inline constexpr Words<CutHint::Plane, 3> kCutWords{
    {{"coronal", CutHint::Plane::coronal}, {"sagittal", CutHint::Plane::sagittal}, {"axial", CutHint::Plane::axial}}};

template <class Visit>
void describe(Visit& visit, CutHint& cut) {
    visit.word({"plane", "what goes: all in front of the plane, on the left of it, or above it", {}, kRequired},
               cut.plane, kCutWords);
    visit({"at", "how much of the body's box goes", kFraction, kRequired}, cut.at);
}

template <class Visit>
void describe(Visit& visit, Suits& suits) {
    visit({"trunk", "scans of a body wider than a head, 260 mm"}, suits.trunk);
    visit({"lungs", "scans with more than 500 ml of lungs"}, suits.lungs);
    visit({"contrast", "scans with contrast in the blood"}, suits.contrast);
    visit({"metal", "scans with more than 1 ml of metal"}, suits.metal);
}

template <class Visit>
void describe(Visit& visit, NamedLook& named) {
    visit({"name", "by which it is chosen; no other has it", {}, kRequired}, named.name);
    visit.word({"group", "where it is listed"}, named.group, kLookGroupWords);
    visit({"doesNotShow", "what must not be looked for in its images, in a sentence or two"}, named.doesNotShow);
    visit.object({"suits", "of which scans it makes sense: `true`, only of those; `false`, only of others"},
                 named.suits);
    visit({"bloodHu",
           "HU of the blood that the curve was drawn for. Of a scan with other contrast the curve and the window are "
           "stretched between 60 and 1500 HU, so that its blood looks the same",
           {100, 1000}},
          named.bloodHu);
    visit.word({"model", "optical model, as in scene files"}, named.model, kModelWords);
    visit.object({"cut", "a flat cut through the body that comes with it"}, named.cut);
    describe(visit, named.look);
}

}  // namespace pdr
