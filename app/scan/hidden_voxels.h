#pragma once
/// The voxels of a scan where its copy without a table has air, packed to about a fifth of the scan's size. With them
/// the table can be shown again without keeping the scan in memory twice. Immutable.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/base/progress.h"
#include "render/base/result.h"
#include "render/volume/volume.h"

namespace pdr::app {

class HiddenVoxels {
  public:
    /// Holds nothing yet of a scan of `slices` slices.
    explicit HiddenVoxels(int slices) : slices_(std::size_t(slices)) {}
    /// Packs the voxels in which `scan` and `seen`, of the same size, differ. Error: cancelled().
    static Result<HiddenVoxels> of(const Volume& scan, const Volume& seen, const Progress& progress);

    /// Packs the voxels in which a slice of the scan and what is seen of it differ. Thread-safe for different slices.
    void keep(int slice, std::span<const std::int16_t> scan, std::span<const std::int16_t> seen);

    /// Restores the scan, to the bit, from the same `seen`.
    Volume scanOf(const Volume& seen) const;
    /// Memory that the packed voxels take [bytes].
    std::size_t bytes() const;

  private:
    /// One zstd frame per slice, of scan xor seen; empty if the slices are equal.
    std::vector<std::vector<std::byte>> slices_;
};

}  // namespace pdr::app
