#pragma once
/// Places of the patient in words, and the Hounsfield units there.

#include <QString>

#include "app/scan/sliced_scan.h"

namespace pdr::app {

/// Returns a place in the patient (LPS) [mm] by the letters of its sides, "L 12.5  P 30.0  H 4.0 mm".
QString placeText(dvec3 placeMm);

/// Returns the HU at a place, as the renderer meets it; NaN outside of the volume, and kNotArrived where it has not
/// arrived yet.
double huAt(const SlicedScan& scan, dvec3 placeMm);

}  // namespace pdr::app
