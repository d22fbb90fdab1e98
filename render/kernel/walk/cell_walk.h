#pragma once
/// A ray on its way through the cells between voxel centres. Cells that cannot matter are passed many at a time: a
/// coarse cell (16 voxels) or a fine one (4 voxels) whose bound does not exceed a bar. See FlatMajorants and GridRay.

#include <type_traits>

#include "render/kernel/grid_ray.h"
#include "render/kernel/walk/weight_along.h"

namespace pdr {

/// The HU along a piece of a ray.
template <class Real>
struct HuAlong {
    Cubic<Real> hu;
    Real length;  ///< mm
};

/// The same where some of the volume is hidden.
template <class Real>
struct MaskedHuAlong : HuAlong<Real> {
    Cubic<Real> weight;  ///< in [0, 1]
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
        ray_.start(grid, origin, direction, t_, end_);
    }

    PDR_HD Mask walking() const { return t_ < end_; }
    PDR_HD void stop(Mask mask) { end_ = mask ? Real{} - 1.0f : end_; }
    /// mm from the ray's origin to where it is.
    PDR_HD Real reached() const { return t_; }

    /// Where `mask` holds: lane l goes on where lane from[l] of `other` is.
    void take(Mask mask, const CellWalk& other, Int from) {
        t_ = mask ? permuted(other.t_, from) : t_;
        end_ = mask ? permuted(other.end_, from) : end_;
        ray_.take(mask, other.ray_, from);
    }

    /// Takes the lanes of `mask`, all walking, through one cell of the largest size whose bound is at most `bar`, or
    /// through one cell between voxels. Result: where it was the latter; `way` is then what was passed.
    /// Way: HuAlong, or MaskedHuAlong for scenes with a mask.
    template <class Way>
    PDR_HD_INLINE Mask step(const FlatScene& scene, Mask mask, Real bar, Way& way) {
        const FlatMajorants& grid = scene.majorants;
        Mask met = mask & (gather(grid.coarse, ray_.template cellIndex<16>(grid.coarseSize, mask)) > bar);
        Int within = met ? Int{} + 3 : Int{} + 15;
        if (any(met)) {
            met = met & (gather(grid.fine, ray_.template cellIndex<4>(grid.fineSize, met)) > bar);
            within = met ? Int{} : within;
        }
        const Vec3<Real> borders = ray_.borders(within);
        const Real leave = max(min(nearest(borders), end_), t_);
        if (any(met))
            read(scene, met, leave, way);
        ray_.advance(mask, within, borders, leave);
        t_ = mask ? leave : t_;
        prefetchNext(scene);
        return met;
    }

  private:
    /// What the next step will read: by then it has come from memory.
    PDR_HD_INLINE void prefetchNext(const FlatScene& scene) const {
        const FlatMajorants& grid = scene.majorants;
        prefetch(grid.fine, ray_.template cellIndex<4>(grid.fineSize, walking()));
        prefetchCell(scene.volume, nearestCorner(scene.volume, ray_.voxel(), walking()));
    }

    template <class Way>
    PDR_HD_INLINE void read(const FlatScene& scene, Mask mask, Real leave, Way& way) const {
        // In the half cells outside the first and last centres the fractions stay at 0 or 1: constant, as clamped.
        const auto corner = nearestCorner(scene.volume, ray_.voxel(), mask);
        const VoxelCell<Real> cell = cellAt(scene.volume, corner);
        const Vec3<Real> from = fractionsIn(cell, ray_.at(t_)), to = fractionsIn(cell, ray_.at(leave));
        way.hu.take(mask, hounsfieldAlong(cell, from, to));
        if constexpr (std::is_same_v<Way, MaskedHuAlong<Real>>)
            way.weight.take(mask, weightAlong(scene.mask, corner, from, to));
        way.length = mask ? leave - t_ : way.length;
    }

    GridRay<Real, 1> ray_{};
    Real t_{}, end_{};  ///< mm from the origin
};

}  // namespace pdr
