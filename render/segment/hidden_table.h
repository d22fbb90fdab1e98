#pragma once
/// A scan without what the patient lies on.

#include <memory>
#include <string>
#include <vector>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/base/text.h"
#include "render/volume/volume.h"

namespace pdr::segment {

struct HiddenTable {
    std::shared_ptr<const Volume> body;  ///< air outside the body; null where nothing is hidden
    VolumeGeometry bodyBox;              ///< the part of the scan's grid that holds the body; undecided: all of it
    std::shared_ptr<const std::vector<dvec3>> outlineMm;  ///< places whose convex hull holds the body; null: the box
    Text undecided;       ///< why it is not known what is table, after "because"; empty: it is
    double hiddenMl = 0;  ///< of what is denser than -300 HU
    double cutMl = 0;     ///< of that, what touched the body
    double bodyMl = 0;    ///< with lungs and bowel
    double metalMl = 0;   ///< of metal outside the body, and of what it touches: it stays, since it may be a frame
    int parts = 0;        ///< bodies that do not touch
};

/// The body in `volume` by the rule of body_mask.h, and a copy of the voxels in which all else is air. A cell of air
/// lies around the body in the scan already, so that nothing of its surface changes; so does metal, see
/// outside_metal.h. Less than 1 ml is nothing to hide. Undecided are what bodyMask() refuses, and what memory has no
/// room for. Error: cancelled().
Result<HiddenTable> hideTable(const Volume& volume, const Progress& progress);

/// A sentence or two for the user: "Table and holder hidden: 884 ml outside the body. 34 ml of it touched the skin:
/// check the edge.", or why nothing is hidden. Empty: there was nothing to hide.
Text tableText(const HiddenTable& table);

}  // namespace pdr::segment
