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
    /// Of a `scan`. `seen`: the same with other voxels in some places. Error: cancelled().
    static Result<HiddenVoxels> of(const Volume& scan, const Volume& seen, const Progress& progress);

    /// The scan, to the bit. `seen`: as it was.
    Volume scanOf(const Volume& seen) const;
    /// That it takes.
    std::size_t bytes() const;

  private:
    HiddenVoxels() = default;

    std::vector<std::vector<std::byte>> slices_;  ///< both combined by xor, as one frame; empty: they are alike
};

}  // namespace pdr::app
