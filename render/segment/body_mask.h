#pragma once
/// Which part of a scan is the patient, and which is table, head holder, clothes or blanket. One rule of geometry, no
/// learning, no posture: what is thick is a patient, what is a thin shell is not.
///   1. a cell is solid whose mean lies above -250 HU
///   2. bodies are the connected solids that hold a ball of 10 mm radius
///   3. what touches them and is long, thin and outside is cut off (contact.h)
///   4. what they enclose in a slice belongs to them; so does a cell around, for the skin's partial volume, unless
///      another solid is there
/// Where it fails it errs to the safe side: something foreign stays (a sheet of 8 mm in full contact, a calibration
/// phantom on its table), and of the body at most some vessels at the border of a small field of view are lost. What
/// was measured: tests/render/segment.

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/segment/outline.h"

namespace pdr::segment {

struct BodyMask {
    CellGrid grid;
    Cells shown;                 ///< 0: outside the body, and nobody would miss it
    Cells body;                  ///< itself, with all that it encloses
    Cells cut;                   ///< solids that touched it
    CellBox box;                 ///< of the body itself
    std::vector<dvec3> rowEnds;  ///< of the body itself (outline.h)
    int parts = 0;               ///< bodies that do not touch
    double bodyMl = 0;           ///< with all that it encloses
};

/// Errors of kind refused say, as a reason that follows "because", why it cannot be known what is table: nothing is as
/// thick as a body, more than half is not, voxels lie too far apart. Else cancelled().
Result<BodyMask> bodyMask(const Volume& volume, const Progress& progress);

}  // namespace pdr::segment
