#pragma once
/// Names, ranges and meanings of the fields of cuts.

#include "render/scene/clip.h"
#include "render/scene/fields/camera_fields.h"
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
void describe(Visit& visit, ImagePoint& point) {
    constexpr Range kHeights{-1000, 1000};
    visit({"x", "to the right of the image's middle [image heights]", kHeights, kRequired}, point.x);
    visit({"y", "below it [image heights]", kHeights, kRequired}, point.y);
}

template <class Visit>
void describe(Visit& visit, FreehandCut& cut) {
    visit.object({"camera", "of the image that it was drawn on; its lens does not count", {}, kRequired}, cut.camera);
    visit.list({"outline", "the corners of a closed line, three at least", {}, kRequired}, cut.outline);
    visit({"keepInside", "whether what lies behind the inside of the line stays, and all else is cut away"},
          cut.keepInside);
}

template <class Visit>
void describe(Visit& visit, Clip& clip) {
    visit.object({"box", "only what lies between these corners stays"}, clip.box);
    visit.list({"planes", "a list; all on the side of a plane's normal is cut away"}, clip.planes);
    visit.list({"freehand", "a list of lines drawn on an image; all that lies behind the inside of one is cut away"},
               clip.freehand);
    visit({"shadows", "whether what box and planes cut away still throws its shadow"}, clip.shadows);
}

}  // namespace pdr
