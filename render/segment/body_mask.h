#pragma once
/// Separates the patient in a scan from table, head holder, clothes and blanket. The rule is geometric, without
/// learning or posture: what is thick is a patient, what is a thin shell is not.
///   1. a cell is solid if its mean lies above -250 HU
///   2. bodies are the connected solids that hold a ball of 10 mm radius
///   3. what touches them and is long, thin and outside is cut off (contact.h)
///   4. what they enclose in a slice belongs to them; so do the cells around, for the skin's partial volume, unless
///      another solid is there
/// The rule errs on the safe side: something foreign stays (a sheet of 8 mm in full contact, a calibration phantom on
/// its table), and of the body at most some vessels at the border of a small field of view are lost. Measurements:
/// tests/render/segment.

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/segment/outline.h"

namespace pdr::segment {

struct BodyMask {
    CellGrid grid;
    Cells shown;                 ///< 0: hidden, outside the body
    Cells body;                  ///< the body with all that it encloses
    Cells cut;                   ///< solids that touched the body and were cut off
    CellBox box;                 ///< bounding box of the body
    std::vector<dvec3> rowEnds;  ///< ends of the body's rows (outline.h)
    int parts = 0;               ///< bodies that do not touch
    double bodyMl = 0;           ///< volume of the body with all that it encloses
};

/// Finds the body in `volume`. Errors: of kind refused, with a reason that follows "because", where the table cannot be
/// identified: the values are no HU, nothing is as thick as a body, more than half is not, voxels lie too far apart;
/// else cancelled().
Result<BodyMask> bodyMask(const Volume& volume, const Progress& progress);

}  // namespace pdr::segment
