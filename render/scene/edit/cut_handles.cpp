#include "render/scene/edit/cut_handles.h"

#include <algorithm>
#include <cmath>

#include "render/scene/orbit.h"

namespace pdr {
namespace {

constexpr double kThinnestMm = 1;  ///< smallest thickness of a box

dvec3 middleOf(const ClipBox& box) {
    return (box.lowMm + box.highMm) * 0.5;
}

/// Returns the place along `axis` (unit, from `middle`) that is nearest to a line of sight [mm]; none if the view is
/// along the axis.
std::optional<double> along(dvec3 middle, dvec3 axis, const SightLine& sight) {
    constexpr double kTooSteep = 0.2;  // sine of the angle between them; below, places run away from the pointer
    const double cosine = glm::dot(axis, sight.direction), across = 1 - cosine * cosine;
    if (across < kTooSteep * kTooSteep)
        return std::nullopt;
    const dvec3 offset = sight.originMm - middle;
    return (glm::dot(offset, axis) - glm::dot(offset, sight.direction) * cosine) / across;
}

/// Returns how far the pointer has pulled along an axis [mm]. If the view is along the axis, up means away from the
/// viewer.
double pulled(const CutGrip& grip, dvec3 middle, dvec3 axis, dvec2 to) {
    const auto from = along(middle, axis, grip.view.under(grip.from)), now = along(middle, axis, grip.view.under(to));
    if (from && now)
        return *now - *from;
    const double away = glm::dot(axis, grip.view.camera().forward()) > 0 ? 1 : -1;
    return away * (grip.from.y - to.y) * grip.view.heightMm(middle);
}

/// Returns how far the pointer has moved in the image plane at a place's depth [mm].
dvec3 carried(const CutGrip& grip, dvec3 place, dvec2 to) {
    const dvec2 drag = (to - grip.from) * dvec2(grip.view.aspect(), 1) * grip.view.heightMm(place);
    return grip.view.camera().right() * drag.x - grip.view.camera().imageUp() * drag.y;
}

Clip faceDragged(const CutGrip& grip, dvec2 to) {
    const int face = grip.handle.number;
    const dvec3 middle = faceMiddle(cropBox(grip.before, grip.uncut), face);
    const double cutOff = cutOffMm(grip.before, grip.uncut, face) - pulled(grip, middle, outwardsOf(face), to);
    return withCutOff(grip.before, grip.uncut, face, cutOff);
}

Clip boxDragged(const CutGrip& grip, dvec2 to) {
    const ClipBox box = cropBox(grip.before, grip.uncut);
    const dvec3 shift = glm::clamp(carried(grip, middleOf(box), to), grip.uncut.lowMm - box.highMm + kThinnestMm,
                                   grip.uncut.highMm - box.lowMm - kThinnestMm);
    return withBox(grip.before, {box.lowMm + shift, box.highMm + shift}, grip.uncut);
}

Clip offsetDragged(const CutGrip& grip, dvec2 to) {
    Clip clip = grip.before;
    ClipPlane& plane = clip.planes[std::size_t(grip.handle.number)];
    const dvec3 middle = planeMiddle(plane, grip.uncut);
    const double pull = pulled(grip, middle, glm::normalize(plane.normal), to);
    plane = withOffset(plane, grip.uncut, planeOffsetMm(plane, grip.uncut) + pull);
    return clip;
}

/// Rotates the plane as orbited() rotates a view, but in the opposite sense: the plane is in front of the viewer.
Clip tiltDragged(const CutGrip& grip, dvec2 to) {
    const dvec2 drag = (to - grip.from) * dvec2(grip.view.aspect(), 1);
    Clip clip = grip.before;
    if (glm::length(drag) == 0)
        return clip;
    ClipPlane& plane = clip.planes[std::size_t(grip.handle.number)];
    const Camera& camera = grip.view.camera();
    const dvec3 axis = glm::normalize(camera.imageUp() * drag.x + camera.right() * drag.y);
    plane = {planeMiddle(plane, grip.uncut), turned(glm::normalize(plane.normal), axis, glm::length(drag) * kHalfTurn)};
    return clip;
}

/// Adds the place where the plane cuts the edge between two corners, if it does.
void addCrossing(std::vector<dvec3>& places, const ClipPlane& plane, dvec3 a, dvec3 b) {
    const double from = glm::dot(plane.normal, a - plane.pointMm), to = glm::dot(plane.normal, b - plane.pointMm);
    if ((from < 0) != (to < 0))
        places.push_back(glm::mix(a, b, from / (from - to)));
}

/// Computes two unit vectors that span the plane.
void span(const ClipPlane& plane, dvec3& s, dvec3& t) {
    const dvec3 normal = glm::normalize(plane.normal);
    s = glm::normalize(glm::cross(normal, std::fabs(normal.z) < 0.9 ? dvec3(0, 0, 1) : dvec3(0, 1, 0)));
    t = glm::cross(normal, s);
}

}  // namespace

ClipBox cropBox(const Clip& clip, const Uncut& uncut) {
    return clip.box ? *clip.box : uncut;
}

Clip withBox(Clip clip, const ClipBox& box, const Uncut& uncut) {
    const bool cuts =
        glm::any(glm::greaterThan(box.lowMm, uncut.lowMm)) || glm::any(glm::lessThan(box.highMm, uncut.highMm));
    clip.box = cuts ? std::optional(box) : std::nullopt;
    return clip;
}

dvec3 outwardsOf(int face) {
    dvec3 outwards(0);
    outwards[face / 2] = face % 2 ? 1 : -1;
    return outwards;
}

dvec3 faceMiddle(const ClipBox& box, int face) {
    dvec3 middle = middleOf(box);
    middle[face / 2] = face % 2 ? box.highMm[face / 2] : box.lowMm[face / 2];
    return middle;
}

double cutOffMm(const Clip& clip, const Uncut& uncut, int face) {
    const ClipBox box = cropBox(clip, uncut);
    const int axis = face / 2;
    return face % 2 ? uncut.highMm[axis] - box.highMm[axis] : box.lowMm[axis] - uncut.lowMm[axis];
}

Clip withCutOff(const Clip& clip, const Uncut& uncut, int face, double mm) {
    ClipBox box = cropBox(clip, uncut);
    const int axis = face / 2;
    const double most = uncut.highMm[axis] - uncut.lowMm[axis] - kThinnestMm - cutOffMm(clip, uncut, face ^ 1);
    const double cutOff = std::clamp(mm, 0.0, std::max(most, 0.0));
    if (face % 2)
        box.highMm[axis] = uncut.highMm[axis] - cutOff;
    else
        box.lowMm[axis] = uncut.lowMm[axis] + cutOff;
    return withBox(clip, box, uncut);
}

/// Sorts the crossings by their angle in the plane: with a convex body, this order is the polygon's.
std::vector<dvec3> planeOutline(const ClipPlane& plane, const Uncut& uncut) {
    const auto corner = [&](int i) { return glm::mix(uncut.lowMm, uncut.highMm, dvec3(i & 1, (i >> 1) & 1, i >> 2)); };
    std::vector<dvec3> places;
    for (int i = 0; i < 8; ++i)
        for (const int bit : {1, 2, 4})
            if (!(i & bit))
                addCrossing(places, plane, corner(i), corner(i | bit));
    dvec3 middle(0), s, t;
    for (const dvec3 place : places)
        middle += place / double(places.size());
    span(plane, s, t);
    std::ranges::sort(
        places, {}, [&](dvec3 place) { return std::atan2(glm::dot(place - middle, t), glm::dot(place - middle, s)); });
    return places;
}

dvec3 planeMiddle(const ClipPlane& plane, const Uncut& uncut) {
    const std::vector<dvec3> outline = planeOutline(plane, uncut);
    if (outline.empty())
        return middleOf(uncut) + glm::normalize(plane.normal) * planeOffsetMm(plane, uncut);
    dvec3 low = outline.front(), high = low;
    for (const dvec3 place : outline) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    const dvec3 middle = (low + high) * 0.5, normal = glm::normalize(plane.normal);
    return middle + normal * glm::dot(normal, plane.pointMm - middle);
}

std::vector<dvec3> tiltRing(const ClipPlane& plane, const Uncut& uncut) {
    constexpr int kParts = 48;
    constexpr double kRadius = 0.16;  // relative to the box' diagonal
    const double radius = kRadius * glm::distance(uncut.lowMm, uncut.highMm);
    const dvec3 middle = planeMiddle(plane, uncut);
    dvec3 s, t;
    span(plane, s, t);
    std::vector<dvec3> ring;
    for (int i = 0; i <= kParts; ++i) {
        const double angle = 2 * kHalfTurn * (i % kParts) / kParts;
        ring.push_back(middle + (s * std::cos(angle) + t * std::sin(angle)) * radius);
    }
    return ring;
}

double planeOffsetMm(const ClipPlane& plane, const Uncut& uncut) {
    return glm::dot(glm::normalize(plane.normal), plane.pointMm - middleOf(uncut));
}

/// Limits the offset so that the plane still cuts the box: otherwise it would cut everything off, or be lost.
ClipPlane withOffset(const ClipPlane& plane, const Uncut& uncut, double mm) {
    const dvec3 normal = glm::normalize(plane.normal);
    const double farthest = glm::dot(glm::abs(normal), uncut.highMm - uncut.lowMm) / 2 - kThinnestMm;
    const double most = std::max(farthest, 0.0);
    return {middleOf(uncut) + normal * std::clamp(mm, -most, most), plane.normal};
}

ClipPlane facingPlane(const Camera& camera, const Uncut& uncut) {
    return {middleOf(uncut), -camera.forward()};
}

ClipPlane planeAcross(int axis, const Camera& camera, const Uncut& uncut) {
    dvec3 normal(0);
    normal[axis] = camera.forward()[axis] > 0 ? -1 : 1;
    return {middleOf(uncut), normal};
}

Clip dragged(const CutGrip& grip, dvec2 to) {
    switch (grip.handle.kind) {
        case CutHandle::Kind::face:
            return faceDragged(grip, to);
        case CutHandle::Kind::box:
            return boxDragged(grip, to);
        case CutHandle::Kind::offset:
            return offsetDragged(grip, to);
        case CutHandle::Kind::tilt:
            return tiltDragged(grip, to);
    }
    return grip.before;
}

Clip withoutCut(const Clip& clip, const Uncut& uncut, CutHandle handle) {
    switch (handle.kind) {
        case CutHandle::Kind::face:
            return withCutOff(clip, uncut, handle.number, 0);
        case CutHandle::Kind::box:
            return withBox(clip, uncut, uncut);
        case CutHandle::Kind::offset:
        case CutHandle::Kind::tilt:
            break;
    }
    Clip result = clip;
    result.planes.erase(result.planes.begin() + handle.number);
    return result;
}

}  // namespace pdr
