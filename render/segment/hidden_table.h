#pragma once
/// Hides the table and other objects around the patient in a scan.

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/base/text.h"
#include "render/volume/volume.h"

namespace pdr::segment {

struct HiddenTable {
    std::shared_ptr<const Volume> body;  ///< voxels with air outside the body; null where nothing is hidden
    VolumeGeometry bodyBox;              ///< part of the scan's grid that holds the body; undecided: all of it
    std::shared_ptr<const std::vector<dvec3>> outlineMm;  ///< points whose convex hull holds the body; null: the box
    Text undecided;       ///< why the table cannot be identified, after "because"; empty: it can
    double hiddenMl = 0;  ///< hidden volume that is denser than -300 HU
    double cutMl = 0;     ///< volume that was cut off, since it touched the body
    double bodyMl = 0;    ///< volume of the body, with lungs and bowel
    /// Volume of metal outside the body, and of what it touches: it stays, since it may be a frame.
    double metalMl = 0;
    int parts = 0;  ///< bodies that do not touch

    /// Returns whether there is anything to hide: 1 ml or more.
    bool hidesAnything() const;
};

/// Finds what hideTable() would hide, and hides nothing: the result has no body. Error: cancelled().
Result<HiddenTable> findTable(const Volume& volume, const Progress& progress);

/// Finds the body in `volume` by the rule of body_mask.h and copies the voxels with air in place of all else. In the
/// scan itself the body is surrounded by a cell of air, which stays, so that its surface does not change; metal stays
/// too, see outside_metal.h. Less than 1 ml is not hidden. The result is undecided where bodyMask() refuses, and
/// without enough memory. Error: cancelled().
Result<HiddenTable> hideTable(const Volume& volume, const Progress& progress);

/// Takes a slice that loses voxels to the table: its number, its voxels before that, and after it. Called from several
/// threads, once for each slice.
using SliceLoss =
    std::function<void(int slice, std::span<const std::int16_t> scan, std::span<const std::int16_t> seen)>;

/// A scan whose table is hidden.
struct ScanWithoutTable {
    std::shared_ptr<const Volume> volume;  ///< the scan, with air outside the body where anything is hidden
    HiddenTable table;                     ///< its body is `volume`, or null where nothing is hidden
};

/// Does the same in the memory of the scan, which large scans fill. `lost` gets what it takes to restore the scan.
/// What `lost` throws is thrown. Error: cancelled(); the scan is lost then.
Result<ScanWithoutTable> hideTableIn(Volume scan, const SliceLoss& lost, const Progress& progress);

/// Returns a sentence or two for the user: "Table and holder hidden: 884 ml outside the body. 34 ml of it touched the
/// skin: check the edge.", or why nothing is hidden. Empty: there was nothing to hide.
Text tableText(const HiddenTable& table);

}  // namespace pdr::segment
