#pragma once
/// The letters of the patient's sides, as in DICOM: L left, R right, P posterior, A anterior, H head, F feet.
/// Directions are in patient space (LPS).

#include <string>

#include "render/slice/slice_plane.h"

namespace pdr {

/// Returns one to three letters, the largest component first: "L", "LP", "LPH". Components of less than 10 degrees are
/// left out. `direction` may have any length but 0.
std::string orientationLetters(dvec3 direction);

/// The letters at the edges of an image.
struct EdgeLetters {
    std::string left, right, top, bottom;
    bool operator==(const EdgeLetters&) const = default;
};

/// Returns the letters of an image whose rows lead to `right` and whose columns lead `down`.
EdgeLetters edgeLetters(dvec3 right, dvec3 down);

inline EdgeLetters edgeLetters(const SlicePlane& plane) {
    return edgeLetters(plane.right, plane.down);
}

}  // namespace pdr
