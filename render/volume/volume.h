#pragma once
/// A CT scan as a regular grid.
///   voxels   x fastest, then y, then z; voxel (i,j,k) is centred at patientFromIndex * (i,j,k,1)
///   values   Hounsfield units, int16        lengths  millimetres, patient space LPS (+x left, +y posterior, +z head)
/// Immutable once built. Independent of DICOM, transfer functions and GPUs.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "render/base/cells.h"
#include "render/base/huge_pages.h"
#include "render/base/portable.h"
#include "render/base/result.h"

namespace pdr {

/// Smallest and largest distance between voxel centres that is accepted from a file [mm]. No scanner comes near the
/// smallest; below it, steps through the grid are lost in the last place of a float.
inline constexpr double kLowestSpacingMm = 1e-6;
inline constexpr double kHighestSpacingMm = 1e6;

/// Hounsfield units of a grid, x fastest, then y, then z. Those of Voxels(count) have no value yet.
using Voxels = HugePageVector<std::int16_t>;

/// The size of a grid and its place in the patient.
struct VolumeGeometry {
    ivec3 size{0};  ///< voxels along i, j, k; each >= 1
    dmat4 patientFromIndex{
        1.0};  ///< affine, mm; columns 0..2 are one step along i, j, k; column 3 is the centre of voxel (0,0,0)

    /// Returns the distance between voxel centres along i, j, k [mm]; each in [kLowestSpacingMm, kHighestSpacingMm].
    dvec3 spacingMm() const;
    /// Returns the number of voxels, i x j x k, as a 64-bit count.
    std::size_t voxelCount() const;
    /// Returns the centre of the box of all voxels (voxel extents included), patient space [mm].
    dvec3 centreMm() const;
    /// Returns half the longest diagonal of that box [mm].
    double radiusMm() const;

    /// Returns the grid of `size` voxels of this one, from voxel `first` on.
    VolumeGeometry part(ivec3 first, ivec3 size) const;

    /// Returns a grid whose axes are the patient's, for phantoms and raw files. `originMm` is the centre of voxel
    /// (0,0,0).
    static VolumeGeometry aligned(ivec3 size, dvec3 spacingMm, dvec3 originMm);
};

/// Checks that voxels may lie that far apart along i, j, k [mm].
Result<void> checkSpacing(dvec3 spacingMm);

/// The ranges of some voxels' values, put together part by part while the voxels are written.
struct ValueRanges {
    static constexpr HuRange kNone{INT16_MAX, INT16_MIN};

    HuRange stored = kNone, measured = kNone;  ///< those of all voxels; those without padding
    std::size_t padding = 0;                   ///< number of voxels that are padding

    void include(const ValueRanges& other) {
        stored.include(other.stored);
        measured.include(other.measured);
        padding += other.padding;
    }
};

class Volume {
  public:
    /// HU of the air that stands for padding, where the scanner measured nothing.
    static constexpr std::int16_t kAirHu = -1024;

    /// Makes a volume. `voxels` holds geometry.voxelCount() values. `padding` is empty or has one flag per voxel: true
    /// = the scanner measured nothing there. Such voxels should hold kAirHu; statistics leave them out. `remarks`,
    /// `hidden`: see remarks(), hidden().
    Volume(VolumeGeometry geometry, Voxels voxels, std::vector<bool> padding = {}, std::string remarks = {},
           std::string hidden = {});
    /// Makes the same volume without looking at all voxels: `ranges` are theirs.
    Volume(VolumeGeometry geometry, Voxels voxels, std::vector<bool> padding, std::string remarks,
           const ValueRanges& ranges);

    /// Returns the volume with every voxel clamped to [lowest, highest] HU, padding included; padding stays marked as
    /// padding. It uses the same memory: *this is empty afterwards. Needs lowest <= highest.
    Volume clamped(std::int16_t lowest, std::int16_t highest) &&;
    /// Returns the same scan with other voxels in place of these; `hidden` describes what they hide.
    Volume withVoxels(Voxels voxels, std::string hidden) const;
    /// Returns the same volume with `remark` behind its remarks. It uses the same memory: *this is empty afterwards.
    Volume remarked(const std::string& remark) &&;
    /// Returns the same scan after `change` has written other values to its voxels, in the same memory: *this is empty
    /// afterwards. `hidden` describes what they hide. What `change` throws is thrown; the scan is lost then.
    Volume changed(const std::function<void(std::span<std::int16_t>)>& change, std::string hidden) &&;

    const VolumeGeometry& geometry() const { return geometry_; }
    ivec3 size() const { return geometry_.size; }
    std::span<const std::int16_t> voxels() const { return voxels_; }
    bool isPadding(std::size_t index) const { return !padding_.empty() && padding_[index]; }
    std::size_t paddingCount() const { return paddingCount_; }

    /// Return the smallest and largest HU of measured voxels (padding left out; {kAirHu, kAirHu} if all is padding).
    std::int16_t lowestHu() const { return lowestHu_; }
    std::int16_t highestHu() const { return highestHu_; }
    /// Returns the smallest and largest HU of all voxels, padding included: the values that interpolation can meet.
    HuRange storedRange() const { return storedRange_; }
    /// Returns remarks from the reading of the voxels, in words that images of them carry ("lossy clipped"). Empty:
    /// none. They never contain patient data.
    const std::string& remarks() const { return remarks_; }
    /// Returns what was scanned and is not in these voxels, in words that images of them carry ("884 ml of 17.7 l").
    /// Empty: nothing.
    const std::string& hidden() const { return hidden_; }

  private:
    void findRanges();
    void takeRanges(const ValueRanges& ranges);

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
