#pragma once
/// A CT scan as a regular grid.
///   voxels   x fastest, then y, then z; voxel (i,j,k) is centred at patientFromIndex * (i,j,k,1)
///   values   Hounsfield units, int16        lengths  millimetres, patient space LPS (+x left, +y posterior, +z head)
/// Immutable once built. Knows no DICOM, no transfer function, no GPU.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "render/base/cells.h"
#include "render/base/huge_pages.h"
#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr {

/// The least and the largest distance between voxel centres that is taken from a file [mm]. No scanner comes near the
/// least; below it, steps through the grid are lost in the last place of a float.
inline constexpr double kLowestSpacingMm = 1e-6;
inline constexpr double kHighestSpacingMm = 1e6;

/// Hounsfield units of a grid, x fastest, then y, then z.
using Voxels = HugePageVector<std::int16_t>;

/// Where a grid lies in the patient.
struct VolumeGeometry {
    ivec3 size{0};  ///< voxels along i, j, k; each >= 1
    dmat4 patientFromIndex{
        1.0};  ///< affine, mm; columns 0..2 are one step along i, j, k; column 3 is the centre of voxel (0,0,0)

    /// Distance between voxel centres along i, j, k [mm]; each in [kLowestSpacingMm, kHighestSpacingMm].
    dvec3 spacingMm() const;
    /// i x j x k as a 64-bit count.
    std::size_t voxelCount() const;
    /// Centre of the box of all voxels (voxel extents included), patient space [mm].
    dvec3 centreMm() const;
    /// Half the diagonal of that box [mm].
    double radiusMm() const;

    /// The grid of `size` voxels of this one, from voxel `first` on.
    VolumeGeometry part(ivec3 first, ivec3 size) const;

    /// A grid whose axes are the patient's, for phantoms and raw files. `originMm` is the centre of voxel (0,0,0).
    static VolumeGeometry aligned(ivec3 size, dvec3 spacingMm, dvec3 originMm);
};

/// Whether voxels may lie so far apart along i, j, k [mm].
Result<void> checkSpacing(dvec3 spacingMm);

class Volume {
  public:
    /// HU of the air that stands where the scanner had nothing to say (padding).
    static constexpr std::int16_t kAirHu = -1024;

    /// `voxels` holds geometry.voxelCount() values. `padding` is empty or has one flag per voxel: true = the scanner
    /// measured nothing there. Such voxels should hold kAirHu; statistics leave them out.
    /// `remarks`, `hidden`: see remarks(), hidden().
    Volume(VolumeGeometry geometry, Voxels voxels, std::vector<bool> padding = {}, std::string remarks = {},
           std::string hidden = {});

    /// The same volume with every voxel clamped to [lowest, highest] HU, padding included; what is padding stays so. In
    /// the same memory: *this is then empty. Needs lowest <= highest.
    Volume clamped(std::int16_t lowest, std::int16_t highest) &&;
    /// The same scan with other voxels in the places of these, and what is hidden by that.
    Volume withVoxels(Voxels voxels, std::string hidden) const;

    const VolumeGeometry& geometry() const { return geometry_; }
    ivec3 size() const { return geometry_.size; }
    std::span<const std::int16_t> voxels() const { return voxels_; }
    bool isPadding(std::size_t index) const { return !padding_.empty() && padding_[index]; }
    std::size_t paddingCount() const { return paddingCount_; }

    /// Smallest and largest HU of what was measured (padding left out; {kAirHu, kAirHu} if all is padding).
    std::int16_t lowestHu() const { return lowestHu_; }
    std::int16_t highestHu() const { return highestHu_; }
    /// The same of all voxels, padding included: what interpolation can meet.
    HuRange storedRange() const { return storedRange_; }
    /// What was remarked when the voxels were read, in words that pictures made of them carry ("lossy clipped").
    /// Empty: nothing. Never anything of a patient.
    const std::string& remarks() const { return remarks_; }
    /// What was scanned and is not in these voxels, in words that pictures made of them carry ("884 ml of 17.7 l").
    /// Empty: nothing.
    const std::string& hidden() const { return hidden_; }

  private:
    void findRanges();

    VolumeGeometry geometry_;
    Voxels voxels_;
    std::vector<bool> padding_;
    std::size_t paddingCount_ = 0;
    std::int16_t lowestHu_ = kAirHu;
    std::int16_t highestHu_ = kAirHu;
    HuRange storedRange_{};
    std::string remarks_;
    std::string hidden_;
};

}  // namespace pdr
