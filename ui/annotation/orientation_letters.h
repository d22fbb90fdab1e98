#pragma once
/// Which side of the patient lies where in a view, in DICOM's letters: L left, R right, P posterior, A anterior,
/// H head, F feet. Directions in patient space LPS.

#include <string>

#include "render/base/portable.h"
#include "render/scene/camera.h"

namespace pdr::ui {

/// One to three letters, the strongest part first: "L", "LP", "LPH". Parts within 10 degrees of nothing are left out.
/// `direction` may have any length but 0.
std::string orientationLetters(dvec3 direction);

/// What to write at the edges of a picture.
struct EdgeLetters {
    std::string left, right, top, bottom;
};

/// The letters of `camera`'s view; seen from the front, the patient's right (R) is at the left edge.
EdgeLetters edgeLetters(const Camera& camera);

}  // namespace pdr::ui
