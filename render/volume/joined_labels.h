#pragma once
/// Label maps of one scan joined to one: programs that write a mask for each part fill a folder with them.

#include <cstdint>
#include <vector>

#include "render/base/result.h"
#include "render/volume/label_map.h"

namespace pdr {

/// Joins maps on one grid. What it returns does not depend on the order in which they come, but for that of the parts.
class JoinedLabels {
  public:
    /// Adds the parts of `map`, which get the next labels. A voxel that lies in several parts belongs to the smallest
    /// of them. Errors, of kind refused, which leave all as it was: its grid is another than that of the maps before;
    /// more than 255 parts.
    Result<void> add(LabelMap map);
    /// Returns the map of all parts, in the order in which they came; a note says how many voxels lie in several of
    /// them. No part and no voxels if nothing was added.
    LabelMap take();

  private:
    void lay(const LabelMap& map, std::size_t partsBefore);

    LabelMap joined_;
    std::vector<std::size_t> voxels_;  ///< number of voxels that each part has in its own map
    std::vector<bool> isShared_;       ///< whether a voxel lies in several parts; empty: none does
};

}  // namespace pdr
