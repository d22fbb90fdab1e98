#pragma once
/// The highest HU along a ray: exact, cell by cell, from the cubic polynomial that trilinear interpolation is along a
/// line. Cells that cannot exceed the highest HU so far are skipped. In a volume with a mask, tissue with a weight
/// below one half counts as hidden. In a cell where the weight crosses one half, five positions along the segment are
/// evaluated, so that tissue within a quarter of the cell from the edge may be missed.

#include "render/kernel/bounds/mask_bound.h"
#include "render/kernel/quadrature/ray_integral.h"

namespace pdr {

/// Offset that maximumIntensity adds to the HU in FlatMajorants, so that 0 stands for cells outside the volume.
inline constexpr int kMipBias = 32769;

/// Lowest visibility weight at which tissue counts as visible.
inline constexpr float kSeenFrom = 0.5f;

/// Returns the bound that maximumIntensity stores for a fine cell: its highest HU plus kMipBias; 0 if nothing is
/// visible.
PDR_HD inline float highestHuBound(HuRange range, const FlatMask& mask, ivec3 volume, ivec3 cell) {
    const bool seen = !range.empty() &&
                      (mask.voxels == nullptr || float(highestWeight(mask, volume, cell)) >= kSeenFrom * float(kSeen));
    return seen ? float(range.highest + kMipBias) : 0.0f;
}

/// Finds the highest HU along one ray, or along several in lanes. Masked: for scenes with a mask.
template <class Real, bool Masked = false>
class RayMaximum {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    PDR_HD_INLINE void start(const FlatScene& scene, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real length) {
        walk_.start(scene.majorants, origin, direction, length);
    }

    PDR_HD Mask going() const { return walk_.walking(); }

    PDR_HD RayResult<Real> result() const {
        RayResult<Real> result;
        result.value[0] = highest_;
        return result;
    }

    /// Makes one step in every lane that is going.
    PDR_HD_INLINE void step(const FlatScene& scene) {
        std::conditional_t<Masked, MaskedHuAlong<Real>, HuAlong<Real>> way{};
        Mask met = walk_.step(scene, going(), bar(), way);
        met = met & (way.hu.highest() > highest_);
        if (!any(met))
            return;
        Real found = way.hu.maximum();
        if constexpr (Masked)
            found = seenMaximum(way, found);
        highest_ = met ? max(highest_, found) : highest_;
        walk_.stop(met & (highest_ >= scene.optics.windowHigh));  // already white: a higher value would look the same
    }

    /// Starts lane l, where `mask` holds, on the ray of lane from[l] of `other`, which has been started but not
    /// stepped.
    void take(Mask mask, const RayMaximum& other, Int from) {
        walk_.take(mask, other.walk_, from);
        highest_ = mask ? Real{} - float(kMipBias) : highest_;
    }

  private:
    /// Returns the highest visible HU on a segment whose highest HU is `whole`, or highest_ if that is higher.
    PDR_HD_INLINE Real seenMaximum(const MaskedHuAlong<Real>& way, Real whole) const {
        constexpr int kPlaces = 5;
        const Mask partly = way.weight.lowest() < kSeenFrom;
        if (!any(partly))
            return whole;
        Real seen = highest_;
        for (int i = 0; i < kPlaces; ++i) {
            const Real s = Real{} + float(i) / (kPlaces - 1);
            const Mask counts = way.weight.at(s) >= kSeenFrom;
            seen = counts ? max(seen, way.hu.at(s)) : seen;
        }
        return partly ? seen : whole;
    }

    /// Returns the threshold below which cells are skipped. Voxels are whole numbers, so a cell can raise the maximum
    /// only if its highest voxel is above this threshold.
    PDR_HD_INLINE Real bar() const {
        const Int towardsZero = toInt(highest_);
        const Int floor = toFloat(towardsZero) > highest_ ? towardsZero - 1 : towardsZero;
        return toFloat(floor + kMipBias);
    }

    CellWalk<Real> walk_;
    Real highest_ = Real{} - float(kMipBias);
};

}  // namespace pdr
