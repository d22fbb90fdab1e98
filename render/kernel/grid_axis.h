#pragma once
/// One axis of a ray's traversal of nested grids of cells. Cell indices are integers that only move forward, so
/// rounding can neither stall nor reverse a ray. After Amanatides & Woo 1987.
///   cell c of edge E covers [E c - 4, E (c + 1) - 4] in index space: every grid begins one 4-voxel cell outside the
///   first voxel centre, and the cells of a coarser grid are found by shifting

#include "render/base/lanes.h"

namespace pdr {

/// State of the traversal along one axis. Finest: edge of the smallest cells in voxels; a power of 2, at most 4.
template <class Real, int Finest>
struct GridAxis {
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    Real origin, direction, inverse;
    Int cell;  ///< index of the finest cell
    Int up;    ///< 1: the ray moves to higher cells, 0: to lower ones

    /// Clips the ray to [low, high]: raises `enter` and lowers `leave`.
    PDR_HD_INLINE void start(Real from, Real along, float low, float high, Real& enter, Real& leave) {
        origin = from;
        // Replace a component of 0 by one that reaches no border within any volume.
        direction = ((along < 1e-20f) & (along > -1e-20f)) ? Real{} + 1e-20f : along;
        inverse = 1.0f / direction;
        up = direction > 0.0f ? Int{} + 1 : Int{};
        const Real a = (low - origin) * inverse, b = (high - origin) * inverse;
        enter = max(enter, min(a, b));
        leave = min(leave, max(a, b));
    }

    PDR_HD Real at(Real t) const { return origin + direction * t; }

    PDR_HD void enter(Real t, int cells) { cell = clamped(cellAt(at(t)), Int{}, Int{} + (cells - 1)); }

    /// Returns the distance at which the ray leaves its cell of Edge voxels along this axis.
    template <int Edge>
    PDR_HD Real leave() const {
        constexpr int kShift = shiftOf(Edge);
        return (toFloat(((cell >> kShift) + up) * Edge - 4) - origin) * inverse;
    }

    /// Returns the distance at which the ray leaves its cell that is `within` + 1 finest cells wide.
    PDR_HD Real leave(Int within) const {
        const Int border = up > 0 ? (cell | within) + 1 : cell & ~within;
        return (toFloat(border * Finest - 4) - origin) * inverse;
    }

    /// Moves into the cell beyond `leaveAt`, where `onward` holds. Along the axis whose border (`reach`) was reached,
    /// this is the neighbour of the cell of `within` + 1 finest ones that is being left. Along the other axes, the
    /// finest cell inside the cell that is being left is found anew.
    PDR_HD_INLINE void advance(Mask onward, Int within, Real reach, Real leaveAt) {
        const Int low = cell & ~within, high = cell | within;
        const Int inside = clamped(cellAt(at(leaveAt)), low, high);
        const Int beyond = up > 0 ? high + 1 : low - 1;
        const Int next = reach <= leaveAt ? beyond : inside;
        cell = onward ? next : cell;
    }

    /// Copies the state of lane from[l] of `other` into lane l, where `mask` holds.
    void take(Mask mask, const GridAxis& other, Int from) {
        const auto taken = [mask, from](auto& mine, const auto& theirs) {
            mine = mask ? permuted(theirs, from) : mine;
        };
        taken(origin, other.origin);
        taken(direction, other.direction);
        taken(inverse, other.inverse);
        taken(cell, other.cell);
        taken(up, other.up);
    }

    /// Returns the right shift from an index of finest cells to an index of cells of `edge` voxels.
    static constexpr int shiftOf(int edge) {
        int shift = 0;
        while (Finest << shift < edge)
            ++shift;
        return shift;
    }

  private:
    PDR_HD static Int cellAt(Real position) { return toInt(position * (1.0f / Finest) + 4.0f / Finest); }
    PDR_HD static Int clamped(Int value, Int low, Int high) {
        value = value < low ? low : value;
        return value > high ? high : value;
    }
};

}  // namespace pdr
