#pragma once
/// Handles with which a cut is dragged in the image, and the effect of a drag on the cut, as pure functions.

#include <vector>

#include "render/scene/clip.h"
#include "render/scene/edit/view_geometry.h"

namespace pdr {

/// A part of a cut that can be dragged.
struct CutHandle {
    enum class Kind {
        face,    ///< middle of a face of the box: moves along its axis; `number`: 2 axis, + 1 for the higher face
        box,     ///< the whole box; `number`: 0
        offset,  ///< middle of a plane: moves along the normal; `number`: the plane's index
        tilt     ///< ring around that middle: rotates the plane about it; `number`: the plane's index
    };
    Kind kind = Kind::face;
    int number = 0;
    bool operator==(const CutHandle&) const = default;
};

/// The extent before any cut: the smallest box along the patient's axes around what is shown.
using Uncut = ClipBox;

/// Returns the box of `clip`, or the box that a cut begins with if there is none.
ClipBox cropBox(const Clip& clip, const Uncut& uncut);
/// Returns `clip` with this box; without a box if this one cuts nothing off `uncut`.
Clip withBox(Clip clip, const ClipBox& box, const Uncut& uncut);

/// Returns the outward normal of a face of the box (unit).
dvec3 outwardsOf(int face);
/// Returns the middle of a face of the box.
dvec3 faceMiddle(const ClipBox& box, int face);
/// Returns how much a face of the box cuts off [mm].
double cutOffMm(const Clip& clip, const Uncut& uncut, int face);
/// Returns `clip` with `mm` cut off at that face; limited so that some of `uncut` remains.
Clip withCutOff(const Clip& clip, const Uncut& uncut, int face, double mm);

/// Returns the part of a plane that lies in `uncut`: a convex polygon; empty if the plane passes beside it.
std::vector<dvec3> planeOutline(const ClipPlane& plane, const Uncut& uncut);
/// Returns the place of a plane's handle: the middle of that polygon, or if the plane passes beside `uncut`, its point
/// nearest to the middle of `uncut`.
dvec3 planeMiddle(const ClipPlane& plane, const Uncut& uncut);
/// Returns the ring around the handle by which a plane is rotated, closed: its last point is its first.
std::vector<dvec3> tiltRing(const ClipPlane& plane, const Uncut& uncut);
/// Returns the distance of a plane from the middle of `uncut` along its normal [mm].
double planeOffsetMm(const ClipPlane& plane, const Uncut& uncut);
ClipPlane withOffset(const ClipPlane& plane, const Uncut& uncut, double mm);

/// Returns a plane through the middle of `uncut` that cuts off what is nearer to the viewer.
ClipPlane facingPlane(const Camera& camera, const Uncut& uncut);
/// Returns such a plane across an axis of the patient: 0 sagittal, 1 coronal, 2 axial.
ClipPlane planeAcross(int axis, const Camera& camera, const Uncut& uncut);

/// A drag that has begun at a handle.
struct CutGrip {
    Clip before;
    Uncut uncut;
    CutHandle handle;
    ViewGeometry view;
    dvec2 from;  ///< start of the drag in the image: fractions of its width and height
};

/// Returns the cut after the pointer has moved to `to`. Faces and planes follow it along their axis and stay in
/// `uncut`; a ring rotates as a view does, 180 degrees for an image's height.
Clip dragged(const CutGrip& grip, dvec2 to);

/// Removes what the handle belongs to: moves a face back to where it cuts nothing off, deletes a plane, or deletes the
/// whole box.
Clip withoutCut(const Clip& clip, const Uncut& uncut, CutHandle handle);

}  // namespace pdr
