#pragma once
/// Traversal of the nested grids of extinction bounds by a ray: its three axes, and which cells it is in.

#include "render/base/extremes.h"
#include "render/kernel/flat_scene.h"
#include "render/kernel/grid_axis.h"

namespace pdr {

/// State of the traversal along all three axes. Finest: see GridAxis.
template <class Real, int Finest>
struct GridRay {
    using Axis = GridAxis<Real, Finest>;
    using Int = typename Axis::Int;
    using Mask = typename Axis::Mask;

    Axis x, y, z;

    /// Clips the ray's interval [enter, leave] to the occupied box: raises `enter` and lowers `leave`. Starts in the
    /// cell at `enter`.
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

    /// Returns the distances at which the ray reaches the border of its cell of Edge voxels along each axis.
    template <int Edge>
    PDR_HD_INLINE Vec3<Real> borders() const {
        return {x.template leave<Edge>(), y.template leave<Edge>(), z.template leave<Edge>()};
    }
    /// Returns the distances to the borders of the ray's cell that is `within` + 1 finest cells wide.
    PDR_HD_INLINE Vec3<Real> borders(Int within) const { return {x.leave(within), y.leave(within), z.leave(within)}; }

    /// Moves into the cell beyond `leaveAt`, where `onward` holds; see GridAxis.
    PDR_HD_INLINE void advance(Mask onward, Int within, const Vec3<Real>& borders, Real leaveAt) {
        x.advance(onward, within, borders.x, leaveAt);
        y.advance(onward, within, borders.y, leaveAt);
        z.advance(onward, within, borders.z, leaveAt);
    }

    /// Returns the index of the ray's cell of Edge voxels in a grid of `size`. Lanes outside `mask` may be outside the
    /// grid and get cell 0.
    template <int Edge>
    PDR_HD_INLINE Int cellIndex(ivec3 size, Mask mask) const {
        constexpr int kShift = Axis::shiftOf(Edge);
        const Int index = ((z.cell >> kShift) * size.y + (y.cell >> kShift)) * size.x + (x.cell >> kShift);
        return mask ? index : Int{};
    }

    /// Returns the voxel at the lowest corner of the ray's cell between voxel centres.
    PDR_HD_INLINE Vec3<Int> voxel() const {
        static_assert(Finest == 1);
        return {x.cell - 4, y.cell - 4, z.cell - 4};
    }

    /// Copies the state of lane from[l] of `other` into lane l, where `mask` holds.
    void take(Mask mask, const GridRay& other, Int from) {
        x.take(mask, other.x, from);
        y.take(mask, other.y, from);
        z.take(mask, other.z, from);
    }
};

/// Returns the nearest of the borders along the three axes.
template <class Real>
PDR_HD_INLINE Real nearest(const Vec3<Real>& borders) {
    return lesser(borders.x, lesser(borders.y, borders.z));
}

}  // namespace pdr
