#pragma once
/// Counts the voxels of a volume by their Hounsfield units.

#include <cstdint>
#include <vector>

namespace pdr {

class Volume;

/// A histogram of HU. A voxel of h HU counts as spread evenly over [h - 0.5, h + 0.5), so that ranges may begin and end
/// anywhere.
class Histogram {
  public:
    /// Makes an empty histogram.
    Histogram() = default;
    /// Counts the measured voxels of `volume`: padding is left out. The counts do not depend on the number of threads.
    explicit Histogram(const Volume& volume);

    /// Returns the number of voxels that were counted.
    double total() const { return below_.empty() ? 0 : double(below_.back()); }
    /// Returns the number of voxels in [lowHu, highHu); 0 if the range is empty.
    double count(double lowHu, double highHu) const;
    /// Returns the HU below which `fraction` of the voxels lie; `fraction` in [0, 1], 0: the lowest that there is. 0
    /// for an empty histogram.
    double percentile(double fraction) const;

  private:
    double below(double hu) const;

    int lowest_ = 0;                    ///< lowest HU that was counted
    std::vector<std::uint64_t> below_;  ///< [i]: voxels below lowest_ + i - 0.5; the last one is all
};

}  // namespace pdr
