#pragma once
/// The highest HU along a ray: exact, cell by cell, from the cubic polynomial that trilinear interpolation is along a
/// line. Cells that cannot beat what was found already are passed. Of a volume with a mask, what is seen by less than
/// half counts as not there; in a cell where that changes, five places along the way are looked at, so that what lies
/// within a quarter of a cell of the edge may be missed.

#include "render/kernel/bounds/mask_bound.h"
#include "render/kernel/quadrature/ray_integral.h"

namespace pdr {

/// What maximumIntensity adds to the HU in FlatMajorants, so that 0 stands for cells outside the volume.
inline constexpr int kMipBias = 32769;

/// Of weights, from where on something is seen.
inline constexpr float kSeenFrom = 0.5f;

/// What maximumIntensity keeps of a fine cell: its highest HU, lifted by kMipBias; 0 where nothing is seen.
PDR_HD inline float highestHuBound(HuRange range, const FlatMask& mask, ivec3 volume, ivec3 cell) {
    const bool seen = !range.empty() &&
                      (mask.voxels == nullptr || float(highestWeight(mask, volume, cell)) >= kSeenFrom * float(kSeen));
    return seen ? float(range.highest + kMipBias) : 0.0f;
}

/// Masked: see PieceWalk.
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

    /// One step of every lane that is going.
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
        walk_.stop(met & (highest_ >= scene.optics.windowHigh));  // white: nothing shows more
    }

    /// Where `mask` holds: lane l begins the ray of lane from[l] of `other`, which has been started only.
    void take(Mask mask, const RayMaximum& other, Int from) {
        walk_.take(mask, other.walk_, from);
        highest_ = mask ? Real{} - float(kMipBias) : highest_;
    }

  private:
    /// The highest HU that is seen on a way whose highest is `whole`.
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

    /// Voxels are whole numbers, so a cell can bring more only if its highest voxel is above this one.
    PDR_HD_INLINE Real bar() const {
        const Int towardsZero = toInt(highest_);
        const Int floor = toFloat(towardsZero) > highest_ ? towardsZero - 1 : towardsZero;
        return toFloat(floor + kMipBias);
    }

    CellWalk<Real> walk_;
    Real highest_ = Real{} - float(kMipBias);
};

}  // namespace pdr
