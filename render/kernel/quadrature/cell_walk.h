#pragma once
/// A ray on its way through the cells between voxel centres. Cells that cannot matter are passed many at a time: a
/// coarse cell (16 voxels) or a fine one (4 voxels) whose bound does not exceed a bar. See FlatMajorants and GridAxis.

#include "render/kernel/grid_axis.h"
#include "render/kernel/quadrature/hounsfield_along.h"

namespace pdr {

/// The HU along a piece of a ray.
template <class Real>
struct HuAlong {
    Cubic<Real> hu;
    Real length;  ///< mm
};

template <class Real>
class CellWalk {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    /// The part of a ray that can matter. Nothing is left to walk where there is none.
    PDR_HD_INLINE void start(const FlatMajorants& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real length) {
        t_ = Real{};
        end_ = length;
        x_.start(origin.x, direction.x, grid.occupiedLow.x, grid.occupiedHigh.x, t_, end_);
        y_.start(origin.y, direction.y, grid.occupiedLow.y, grid.occupiedHigh.y, t_, end_);
        z_.start(origin.z, direction.z, grid.occupiedLow.z, grid.occupiedHigh.z, t_, end_);
        x_.enter(t_, 4 * grid.fineSize.x);
        y_.enter(t_, 4 * grid.fineSize.y);
        z_.enter(t_, 4 * grid.fineSize.z);
    }

    PDR_HD Mask walking() const { return t_ < end_; }
    PDR_HD void stop(Mask mask) { end_ = mask ? Real{} - 1.0f : end_; }

    /// Where `mask` holds: lane l goes on where lane from[l] of `other` is.
    void take(Mask mask, const CellWalk& other, Int from) {
        t_ = mask ? permuted(other.t_, from) : t_;
        end_ = mask ? permuted(other.end_, from) : end_;
        x_.take(mask, other.x_, from);
        y_.take(mask, other.y_, from);
        z_.take(mask, other.z_, from);
    }

    /// Takes the lanes of `mask`, all walking, through one cell of the largest size whose bound is at most `bar`, or
    /// through one cell between voxels. Result: where it was the latter; `way` is then what was passed.
    PDR_HD_INLINE Mask step(const FlatScene& scene, Mask mask, Real bar, HuAlong<Real>& way) {
        const FlatMajorants& grid = scene.majorants;
        Mask met = mask & (gather(grid.coarse, index<4>(grid.coarseSize, mask)) > bar);
        Int within = met ? Int{} + 3 : Int{} + 15;
        if (any(met)) {
            met = met & (gather(grid.fine, index<2>(grid.fineSize, met)) > bar);
            within = met ? Int{} : within;
        }
        const Real x = x_.leave(within), y = y_.leave(within), z = z_.leave(within);
        const Real leave = max(min(min(x, min(y, z)), end_), t_);
        if (any(met))
            read(scene.volume, met, leave, way);
        x_.advance(mask, within, x, leave);
        y_.advance(mask, within, y, leave);
        z_.advance(mask, within, z, leave);
        t_ = mask ? leave : t_;
        return met;
    }

  private:
    /// Lanes outside the mask may stand outside the grid: they read cell 0.
    template <int Shift>
    PDR_HD_INLINE Int index(ivec3 size, Mask mask) const {
        const Int found = ((z_.cell >> Shift) * size.y + (y_.cell >> Shift)) * size.x + (x_.cell >> Shift);
        return mask ? found : Int{};
    }

    PDR_HD_INLINE void read(const FlatVolume& volume, Mask mask, Real leave, HuAlong<Real>& way) const {
        // In the half cells outside the first and last centres the fractions stay at 0 or 1: constant, as clamped.
        const auto corner = [mask](const GridAxis<Real, 1>& axis, float last) {
            const Int cell = axis.cell - 4;
            const Int most = Int{} + int(last);
            const Int inside = cell < 0 ? Int{} : (cell > most ? most : cell);
            return mask ? inside : Int{};
        };
        const Int i = corner(x_, volume.lastCorner.x), j = corner(y_, volume.lastCorner.y),
                  k = corner(z_, volume.lastCorner.z);
        const auto fraction = [](Real position, Int cell) {
            return max(min(position - toFloat(cell), Real{} + 1.0f), Real{});
        };
        const auto place = [&](Real t) {
            return Vec3<Real>{fraction(x_.at(t), i), fraction(y_.at(t), j), fraction(z_.at(t), k)};
        };
        const Cubic<Real> hu = hounsfieldAlong(cornersOf(volume, i, j, k), place(t_), place(leave));
        way.hu.b0 = mask ? hu.b0 : way.hu.b0;
        way.hu.b1 = mask ? hu.b1 : way.hu.b1;
        way.hu.b2 = mask ? hu.b2 : way.hu.b2;
        way.hu.b3 = mask ? hu.b3 : way.hu.b3;
        way.length = mask ? leave - t_ : way.length;
    }

    GridAxis<Real, 1> x_{}, y_{}, z_{};
    Real t_{}, end_{};  ///< mm from the origin
};

}  // namespace pdr
