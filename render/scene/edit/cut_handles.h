#pragma once
/// What of a cut a hand can take hold of in the picture, and what a drag does to the cut: pure maths, no mouse.

#include <vector>

#include "render/scene/clip.h"
#include "render/scene/edit/view_geometry.h"

namespace pdr {

/// A part of a cut.
struct CutHandle {
    enum class Kind {
        face,    ///< of the box, in its middle: moves along its axis; `number`: 2 axis + 1 for the higher one
        box,     ///< all of it; `number`: 0
        offset,  ///< of a plane, in its middle: moves along the normal; `number`: which plane
        tilt     ///< a ring around that: turns the plane about its middle; likewise
    };
    Kind kind = Kind::face;
    int number = 0;
    bool operator==(const CutHandle&) const = default;
};

/// What there is to cut: the smallest box along the patient's axes around what is shown.
using Uncut = ClipBox;

/// The box that is cut to, or the one that a cut begins with.
ClipBox cropBox(const Clip& clip, const Uncut& uncut);
/// The same cut with this box; one that cuts nothing of `uncut` off is none.
Clip withBox(Clip clip, const ClipBox& box, const Uncut& uncut);

/// The way that a face of the box looks.
dvec3 outwardsOf(int face);
/// The middle of a box' face.
dvec3 faceMiddle(const ClipBox& box, int face);
/// How much a face of the box cuts off [mm].
double cutOffMm(const Clip& clip, const Uncut& uncut, int face);
/// The same cut with so much cut off there, but not all.
Clip withCutOff(const Clip& clip, const Uncut& uncut, int face, double mm);

/// The part of a plane that lies in `uncut`: a convex polygon; empty where it passes beside it.
std::vector<dvec3> planeOutline(const ClipPlane& plane, const Uncut& uncut);
/// Where a plane is held: the middle of that polygon, or where it passes beside, its point nearest to `uncut`'s middle.
dvec3 planeMiddle(const ClipPlane& plane, const Uncut& uncut);
/// The ring around it by which it is turned, closed: its last point is its first.
std::vector<dvec3> tiltRing(const ClipPlane& plane, const Uncut& uncut);
/// How far a plane is from the middle of `uncut` along its normal [mm].
double planeOffsetMm(const ClipPlane& plane, const Uncut& uncut);
ClipPlane withOffset(const ClipPlane& plane, const Uncut& uncut, double mm);

/// A plane through the middle of `uncut` that cuts off what is nearer to the viewer.
ClipPlane facingPlane(const Camera& camera, const Uncut& uncut);
/// The same across an axis of the patient: 0 sagittal, 1 coronal, 2 axial.
ClipPlane planeAcross(int axis, const Camera& camera, const Uncut& uncut);

/// A hand that has taken hold of something.
struct CutGrip {
    Clip before;
    Uncut uncut;
    CutHandle handle;
    ViewGeometry view;
    dvec2 from;  ///< where, in the picture: fractions of its width and height
};

/// The cut when the hand has come to `to`. Faces and planes follow it along their axis and stay in `uncut`; a ring
/// turns as a view is turned, 180 degrees for a picture's height.
Clip dragged(const CutGrip& grip, dvec2 to);

/// Without what the handle holds: a face back where it cuts nothing off, a plane gone, the whole box gone.
Clip withoutCut(const Clip& clip, const Uncut& uncut, CutHandle handle);

}  // namespace pdr
