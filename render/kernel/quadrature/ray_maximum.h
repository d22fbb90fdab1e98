#pragma once
/// The highest HU along a ray: exact, cell by cell, from the cubic polynomial that trilinear interpolation is along a
/// line. Cells that cannot beat what was found already are passed.

#include "render/kernel/quadrature/ray_integral.h"

namespace pdr {

/// What maximumIntensity adds to the HU in FlatMajorants, so that 0 stands for cells outside the volume.
inline constexpr int kMipBias = 32769;

template <class Real>
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
        HuAlong<Real> way{};
        Mask met = walk_.step(scene, going(), bar(), way);
        met = met & (way.hu.highest() > highest_);
        if (!any(met))
            return;
        highest_ = met ? max(highest_, way.hu.maximum()) : highest_;
        walk_.stop(met & (highest_ >= scene.optics.windowHigh));  // white: nothing shows more
    }

    /// Where `mask` holds: lane l begins the ray of lane from[l] of `other`, which has been started only.
    void take(Mask mask, const RayMaximum& other, Int from) {
        walk_.take(mask, other.walk_, from);
        highest_ = mask ? Real{} - float(kMipBias) : highest_;
    }

  private:
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
