#pragma once
/// What ties a plan to its scan without saying whose it is: a salted hash of the voxels. With the scan at hand it is
/// proof; without it nothing can be looked up, and two plans of one patient do not resemble each other.

#include <string>
#include <vector>

#include "render/base/result.h"
#include "render/volume/holes.h"

namespace pdr::app {

/// The rule by which the importer turns pixels into voxels. Whoever changes the voxels of any scan increments it.
inline constexpr int kImportRule = 1;

struct ScanMark {
    std::string salt;         ///< 32 hexadecimal digits, random for each file
    std::string hash;         ///< 64 hexadecimal digits: BLAKE2b-256, keyed with the salt, over size, places and voxels
    std::string sliceHashes;  ///< 16 digits for the voxels of each slice, keyed likewise; may be empty in older files
    ivec3 size{0};
    dvec3 spacingMm{0};
    int importRule = kImportRule;
    std::vector<Hole> holes{};  ///< layers in which slices are interpolated: measurements there are marked
    bool operator==(const ScanMark&) const = default;
};

/// Returns a random salt.
std::string newSalt();

/// Returns the mark of a scan. Places count as equal if they agree to 1e-6 mm.
ScanMark markOf(const Volume& volume, const std::string& salt);

/// Returns an error of kind refused that says in what `volume` differs from the scan of `mark`, if it does: its size, a
/// few slices (counted from 1 in the order of the voxels), all of them, or its place in the patient.
Result<void> checkIsScanOf(const ScanMark& mark, const Volume& volume);

}  // namespace pdr::app
