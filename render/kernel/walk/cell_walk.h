#pragma once
/// Traversal of the cells between voxel centres along a ray. Cells that cannot matter are skipped many at a time: a
/// coarse cell (16 voxels) or a fine one (4 voxels) whose bound does not exceed a threshold. See FlatMajorants and
/// GridRay.

#include <type_traits>

#include "render/kernel/grid_ray.h"
#include "render/kernel/parts.h"
#include "render/kernel/walk/weight_along.h"

namespace pdr {

/// The HU along a ray segment inside one cell.
template <class Real>
struct HuAlong {
    Cubic<Real> hu;
    Real length;  ///< mm
};

/// The HU and the visibility weight along a ray segment inside one cell, for scenes with a mask.
template <class Real>
struct MaskedHuAlong : HuAlong<Real> {
    Cubic<Real> weight;  ///< in [0, 1]
};

/// HU, weight (with a mask) and curves along a ray segment inside one cell, for scenes with parts.
template <class Real>
struct PartedHuAlong : MaskedHuAlong<Real> {
    using Int = typename SimdTraits<Real>::Int;
    using Bits = typename SimdTraits<Real>::Bits;

    Int curve;              ///< the only curve of the cell, or kSeveralCurves
    Bits labels;            ///< those of the corners of a cell with several curves
    Vec3<Real> begin, end;  ///< ends of the segment there, as fractions of the cell
};

/// Assigns `other` where `mask` holds.
template <class Number, class Mask>
PDR_HD_INLINE void take(Vec3<Number>& mine, Mask mask, const Vec3<Number>& other) {
    mine = chosen(mask, other, mine);
}

/// Reads the cell between voxels whose lowest corner is `voxel`, or the nearest one, and describes in `way` the segment
/// from one position in it to another (index space), without its length; where `mask` holds.
template <class Real, class Way>
PDR_HD_INLINE void readCell(const FlatScene& scene, const Vec3<typename SimdTraits<Real>::Int>& voxel,
                            typename SimdTraits<Real>::Mask mask, const Vec3<Real>& begin, const Vec3<Real>& end,
                            Way& way) {
    // In the half cells outside the first and last centres the fractions stay at 0 or 1: HU are clamped there.
    const auto corner = nearestCorner(scene.volume, voxel, mask);
    const VoxelCell<Real> cell = cellAt(scene.volume, corner);
    const Vec3<Real> from = fractionsIn(cell, begin), to = fractionsIn(cell, end);
    way.hu.take(mask, hounsfieldAlong(cell, from, to));
    if constexpr (std::is_same_v<Way, MaskedHuAlong<Real>>)
        way.weight.take(mask, weightAlong(scene.mask, corner, from, to));
    if constexpr (std::is_same_v<Way, PartedHuAlong<Real>>) {
        if (isMasked(scene))
            way.weight.take(mask, weightAlong(scene.mask, corner, from, to));
        way.curve = mask ? onlyCurve(scene, corner, mask, way.labels) : way.curve;
        if (any(mask & (way.curve == kSeveralCurves))) {
            take(way.begin, mask, from);
            take(way.end, mask, to);
        }
    }
}

template <class Real>
class CellWalk {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    /// Starts at the beginning of the part of a ray that can matter. walking() is false at once if there is none.
    PDR_HD_INLINE void start(const FlatMajorants& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real length) {
        t_ = Real{};
        end_ = length;
        ray_.start(grid, origin, direction, t_, end_);
    }

    PDR_HD Mask walking() const { return t_ < end_; }
    PDR_HD void stop(Mask mask) { end_ = mask ? Real{} - 1.0f : end_; }
    /// Returns the lanes whose segment is a look at a random place: none.
    PDR_HD static Mask looking() { return Mask{}; }
    /// Returns the distance from the ray's origin to the current position [mm].
    PDR_HD Real reached() const { return t_; }

    /// Copies the state of lane from[l] of `other` into lane l, where `mask` holds.
    void take(Mask mask, const CellWalk& other, Int from) {
        t_ = mask ? permuted(other.t_, from) : t_;
        end_ = mask ? permuted(other.end_, from) : end_;
        ray_.take(mask, other.ray_, from);
    }

    /// Moves the lanes of `mask` as below, past cells that are clear.
    template <class Way>
    PDR_HD_INLINE Mask step(const FlatScene& scene, Mask mask, Way& way) {
        return step(scene, mask, Real{}, way);
    }
    /// Moves the lanes of `mask`, all of them walking, through one cell: the largest cell whose bound is at most `bar`,
    /// or else one cell between voxels. Returns the lanes that took a cell between voxels; `way` then describes the
    /// segment that was passed. Way: HuAlong, MaskedHuAlong or PartedHuAlong, as Tissue says.
    template <class Way>
    PDR_HD_INLINE Mask step(const FlatScene& scene, Mask mask, Real bar, Way& way) {
        const FlatMajorants& grid = scene.majorants;
        // Find the largest cell whose bound is at most `bar`.
        Mask met = mask & (gather(grid.coarse, ray_.template cellIndex<16>(grid.coarseSize, mask)) > bar);
        Int within = met ? Int{} + 3 : Int{} + 15;
        if (any(met)) {
            met = met & (gather(grid.fine, ray_.template cellIndex<4>(grid.fineSize, met)) > bar);
            within = met ? Int{} : within;
        }
        // Pass the cell, and read the voxels where it is one between voxels.
        const Vec3<Real> borders = ray_.borders(within);
        const Real leave = greater(lesser(nearest(borders), end_), t_);
        if (any(met)) {
            readCell(scene, ray_.voxel(), met, ray_.at(t_), ray_.at(leave), way);
            way.length = met ? leave - t_ : way.length;
        }
        ray_.advance(mask, within, borders, leave);
        t_ = mask ? leave : t_;
        prefetchNext(scene);
        return met;
    }

  private:
    /// Prefetches what the next step reads.
    PDR_HD_INLINE void prefetchNext(const FlatScene& scene) const {
        const FlatMajorants& grid = scene.majorants;
        prefetch(grid.fine, ray_.template cellIndex<4>(grid.fineSize, walking()));
        prefetchCell(scene.volume, nearestCorner(scene.volume, ray_.voxel(), walking()));
    }

    GridRay<Real, 1> ray_{};
    Real t_{}, end_{};  ///< mm from the origin
};

}  // namespace pdr
