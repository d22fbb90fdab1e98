#pragma once
/// Names, ranges and meanings of the fields of the visible parts of a patient.

#include "render/scene/field.h"
#include "render/scene/visible.h"

namespace pdr {

template <class Visit>
void describe(Visit& visit, Visible& visible) {
    visit.labels(
        {"shown",
         "the parts that alone are shown: `lungs` without the outermost 5 mm, `bones` as far as they hold dense "
         "bone. Found by density and geometry, with smooth edges; no voxel is changed, and images say what is "
         "not shown"},
        visible.shown);
    visit.labels({"hidden", "the parts that are left out"}, visible.hidden);
    visit({"peelMm", "so much is taken off all around the body, such as skin [mm]", {0, 50}}, visible.peelMm);
}

}  // namespace pdr
