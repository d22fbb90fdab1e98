#include "app/presenters/mark_drawing.h"

#include <cmath>

#include "app/presenters/mark_places.h"
#include "app/presenters/slice_framing.h"
#include "ui/measure/mark_painter.h"

namespace pdr::app {
namespace {

/// Returns where a figure lies whose first place is `placeMm`: in the slice of that number, as the views count.
Text liesIn(AnatomicalPlane axis, int number) {
    switch (axis) {
        case AnatomicalPlane::axial:
            return phrase("the figure lies in axial slice %1", number);
        case AnatomicalPlane::coronal:
            return phrase("the figure lies in coronal slice %1", number);
        case AnatomicalPlane::sagittal:
            break;
    }
    return phrase("the figure lies in sagittal slice %1", number);
}

}  // namespace

bool MarkDrawing::goesOnIn(const ViewedSlice& slice, const VolumeGeometry& geometry) const {
    if (!isFlat(kind_) || places_.empty() || !begun_)
        return true;
    const SliceStack stack(geometry, begun_->axis);
    const dvec3 first = places_.front().mm;
    const bool hasItsNumber = nearestSlice(stack, slice.plane.middleMm()) == nearestSlice(stack, first);
    return slice.axis == begun_->axis && (hasItsNumber || std::abs(slice.plane.depthMm(first)) <= ui::kInSliceMm);
}

bool MarkDrawing::liesAcross(AnatomicalPlane axis) const {
    return isFlat(kind_) && !places_.empty() && begun_ && begun_->axis != axis;
}

Error MarkDrawing::isElsewhere(const VolumeGeometry& geometry) const {
    const Text hint = phrase("Click there, or press Esc to give it up.");
    if (places_.empty() || !begun_)
        return {phrase("this figure is drawn on a slice"), "", hint, ErrorKind::refused};
    const int index = nearestSlice(SliceStack(geometry, begun_->axis), places_.front().mm);
    return {liesIn(begun_->axis, index + 1), "", hint, ErrorKind::refused};
}

/// What is flat stays in the plane of its first place, also where the slice is scrolled by a part of its thickness.
void MarkDrawing::add(const Volume& volume, const ViewedSlice& slice, dvec3 placeMm, bool free) {
    if (places_.empty())
        begun_ = slice;
    const bool toEdge = isBetweenEdges(kind_) && !free;
    if (isFlat(kind_) && !places_.empty())
        add(placeInPlane(volume, slice.plane, placeMm, toEdge, places_[0].mm, begun_->plane.normal()));
    else
        add(placeOnSlice(volume, slice.plane, placeMm, toEdge));
}

void MarkDrawing::takeBack() {
    if (!places_.empty())
        places_.pop_back();
}

}  // namespace pdr::app
