#pragma once
/// The letters of the patient's sides in a view, as in DICOM: L left, R right, P posterior, A anterior, H head, F feet.
/// Directions are in patient space (LPS).

#include <string>

#include "render/base/portable.h"
#include "render/scene/camera.h"

namespace pdr::ui {

/// Returns one to three letters, the largest component first: "L", "LP", "LPH". Components of less than 10 degrees are
/// left out. `direction` may have any length but 0.
std::string orientationLetters(dvec3 direction);

/// The letters at the edges of an image.
struct EdgeLetters {
    std::string left, right, top, bottom;
};

/// Returns the letters of `camera`'s view. Seen from the front, the patient's right (R) is at the left edge.
EdgeLetters edgeLetters(const Camera& camera);

}  // namespace pdr::ui
