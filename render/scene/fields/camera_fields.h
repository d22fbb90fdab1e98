#pragma once
/// Names, ranges and meanings of the fields of camera and film.

#include "render/base/image_size.h"
#include "render/scene/camera.h"
#include "render/scene/fields/ranges.h"

namespace pdr {

inline constexpr Words<Camera::Type, 2> kCameraWords{
    {{"perspective", Camera::Type::perspective}, {"orthographic", Camera::Type::orthographic}}};

template <class Visit>
void describe(Visit& visit, Camera& camera) {
    constexpr Range kEyeMm{-1e15, 1e15};
    visit.word({"type", ""}, camera.type, kCameraWords);
    visit({"eyeMm", "where it is [mm]", kEyeMm, kRequired}, camera.eyeMm);
    visit({"targetMm", "the point in the middle of the image, at least 1e-12 from the eye [mm]", kEyeMm, kRequired},
          camera.targetMm);
    visit.direction({"up", "what is up in the image; not along the view"}, camera.up);
    if (Visit::kBranches || camera.type == Camera::Type::perspective)
        visit({"fovDegrees", "perspective only: vertical field of view [degrees]", {kLeastMm, 180, true, false}},
              camera.fovDegrees);
    if (Visit::kBranches || camera.type == Camera::Type::orthographic)
        visit({"heightMm", "orthographic only: height of what is seen [mm]", {kLeastMm, 1e9}, kRequired},
              camera.heightMm);
    visit({"apertureMm", "diameter of the lens; 0 = a pinhole, all is sharp [mm]", {0, 200}}, camera.apertureMm);
    visit({"focusMm",
           "distance of the sharp plane from the eye, at least 1e-12; 0 = the target's [mm]",
           {camera.focusMm == 0 || Visit::kBranches ? 0 : kLeastMm, 1e9}},
          camera.focusMm);
}

struct FilmField {
    ivec2& size;
};
template <class Visit>
void describe(Visit& visit, FilmField& film) {
    visit({"width", "[pixels]", {1, kLongestSide}, kRequired}, film.size.x);
    visit({"height", "[pixels]", {1, kLongestSide}, kRequired}, film.size.y);
}

}  // namespace pdr
