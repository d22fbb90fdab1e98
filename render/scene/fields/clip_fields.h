#pragma once
/// What the fields of what is cut away are called, which range they have, and what they mean.

#include "render/scene/clip.h"
#include "render/scene/fields/ranges.h"

namespace pdr {

template <class Visit>
void describe(Visit& visit, ClipBox& box) {
    visit({"lowMm", "one corner [mm]", kPlaceMm, kRequired}, box.lowMm);
    visit({"highMm", "the corner across; above `lowMm` along every axis [mm]", kPlaceMm, kRequired}, box.highMm);
}

template <class Visit>
void describe(Visit& visit, ClipPlane& plane) {
    visit({"pointMm", "a point of the plane [mm]", kPlaceMm, kRequired}, plane.pointMm);
    visit.direction({"normal", "its normal", {}, kRequired}, plane.normal);
}

template <class Visit>
void describe(Visit& visit, Clip& clip) {
    visit.object({"box", "only what lies between these corners stays"}, clip.box);
    visit.list({"planes", "a list; all on the side of a plane's normal is cut away"}, clip.planes);
    visit({"shadows", "whether what is cut away still throws its shadow"}, clip.shadows);
}

}  // namespace pdr
