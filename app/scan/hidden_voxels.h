#pragma once
/// What a scan held where its copy without a table has air, packed to about a fifth of a scan: so that the table can be
/// shown again, and a scan does not lie in memory twice. Immutable.

#include <cstddef>
#include <vector>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr::app {

class HiddenVoxels {
  public:
    /// The voxels in which `scan` and `seen`, of one size, differ. Error: cancelled().
    static Result<HiddenVoxels> of(const Volume& scan, const Volume& seen, const Progress& progress);

    /// The scan again, to the bit, from the same `seen`.
    Volume scanOf(const Volume& seen) const;
    /// Memory that the packed voxels take.
    std::size_t bytes() const;

  private:
    HiddenVoxels() = default;

    std::vector<std::vector<std::byte>> slices_;  ///< scan xor seen, as one zstd frame each; empty: they are alike
};

}  // namespace pdr::app
