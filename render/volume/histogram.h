#pragma once
/// How many voxels of a volume have which Hounsfield units.

#include <cstdint>
#include <vector>

namespace pdr {

class Volume;

/// A voxel of h HU counts as spread evenly over [h - 0.5, h + 0.5), so that ranges may begin and end anywhere.
class Histogram {
  public:
    /// Of nothing.
    Histogram() = default;
    /// Of what was measured: padding is left out. The counts do not depend on the number of threads.
    explicit Histogram(const Volume& volume);

    /// Voxels that were counted.
    double total() const { return below_.empty() ? 0 : double(below_.back()); }
    /// Those in [lowHu, highHu); 0 where the range is empty.
    double count(double lowHu, double highHu) const;
    /// The HU below which `fraction` of the voxels lie; `fraction` in [0, 1], 0: the lowest that there is. 0 of
    /// nothing.
    double percentile(double fraction) const;

  private:
    double below(double hu) const;

    int lowest_ = 0;                    ///< [HU], of the first voxel
    std::vector<std::uint64_t> below_;  ///< [i]: voxels below lowest_ + i - 0.5; the last one is all
};

}  // namespace pdr
