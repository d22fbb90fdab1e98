#pragma once
/// A ray on its way through the nested grids of extinction bounds: its three axes, and which cells it is in.

#include "render/kernel/flat_scene.h"
#include "render/kernel/grid_axis.h"

namespace pdr {

/// Finest: see GridAxis.
template <class Real, int Finest>
struct GridRay {
    using Axis = GridAxis<Real, Finest>;
    using Int = typename Axis::Int;
    using Mask = typename Axis::Mask;

    Axis x, y, z;

    /// The part of the ray at t in [enter, leave] that lies in the occupied box is kept: `enter` grows, `leave`
    /// shrinks.
    PDR_HD_INLINE void start(const FlatMajorants& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real& enter, Real& leave) {
        x.start(origin.x, direction.x, grid.occupiedLow.x, grid.occupiedHigh.x, enter, leave);
        y.start(origin.y, direction.y, grid.occupiedLow.y, grid.occupiedHigh.y, enter, leave);
        z.start(origin.z, direction.z, grid.occupiedLow.z, grid.occupiedHigh.z, enter, leave);
        x.enter(enter, 4 / Finest * grid.fineSize.x);
        y.enter(enter, 4 / Finest * grid.fineSize.y);
        z.enter(enter, 4 / Finest * grid.fineSize.z);
    }

    PDR_HD_INLINE Vec3<Real> at(Real t) const { return {x.at(t), y.at(t), z.at(t)}; }

    /// Distances at which the ray reaches the border of its cell of Edge voxels along each axis.
    template <int Edge>
    PDR_HD_INLINE Vec3<Real> borders() const {
        return {x.template leave<Edge>(), y.template leave<Edge>(), z.template leave<Edge>()};
    }
    /// The same for a cell of `within` + 1 finest cells along an edge.
    PDR_HD_INLINE Vec3<Real> borders(Int within) const { return {x.leave(within), y.leave(within), z.leave(within)}; }

    /// Into the cell beyond `leaveAt`, where `onward` holds; see GridAxis.
    PDR_HD_INLINE void advance(Mask onward, Int within, const Vec3<Real>& borders, Real leaveAt) {
        x.advance(onward, within, borders.x, leaveAt);
        y.advance(onward, within, borders.y, leaveAt);
        z.advance(onward, within, borders.z, leaveAt);
    }

    /// Index of the ray's cell of Edge voxels in a grid of `size`. Lanes outside the mask may stand outside the grid:
    /// they get cell 0.
    template <int Edge>
    PDR_HD_INLINE Int cellIndex(ivec3 size, Mask mask) const {
        constexpr int kShift = Axis::shiftOf(Edge);
        const Int index = ((z.cell >> kShift) * size.y + (y.cell >> kShift)) * size.x + (x.cell >> kShift);
        return mask ? index : Int{};
    }

    /// The voxel at the lowest corner of the cell between voxel centres that the ray is in.
    PDR_HD_INLINE Vec3<Int> voxel() const {
        static_assert(Finest == 1);
        return {x.cell - 4, y.cell - 4, z.cell - 4};
    }

    /// Where `mask` holds: lane l goes on where lane from[l] of `other` is.
    void take(Mask mask, const GridRay& other, Int from) {
        x.take(mask, other.x, from);
        y.take(mask, other.y, from);
        z.take(mask, other.z, from);
    }
};

/// The nearest of the borders along the three axes.
template <class Real>
PDR_HD_INLINE Real nearest(const Vec3<Real>& borders) {
    return min(borders.x, min(borders.y, borders.z));
}

}  // namespace pdr
