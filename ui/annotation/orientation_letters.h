#pragma once
/// The letters of the patient's sides at the edges of a view.

#include "render/scene/camera.h"
#include "render/slice/slice_letters.h"

namespace pdr::ui {

/// Returns the letters of `camera`'s view. Seen from the front, the patient's right (R) is at the left edge.
EdgeLetters edgeLetters(const Camera& camera);

}  // namespace pdr::ui
