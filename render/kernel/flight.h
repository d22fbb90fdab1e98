#pragma once
/// A ray on its way through the two-level grid of extinction bounds, from one tentative collision to the next.
///
/// A step ends at a tentative collision or at the border of a cell, whichever comes first. The cell is a coarse one
/// (16 voxels) where its bound promises at most kDescend collisions, else a fine one (4 voxels). The optical depth
/// still to go is carried from cell to cell, never drawn anew. Cells are whole numbers that only ever move forward, so
/// rounding can neither stall nor reverse a ray. An accelerator: it never changes the picture. Grid walk after
/// Amanatides & Woo 1987; tentative collisions after Woodcock et al. 1965.

#include "render/kernel/medium.h"
#include "render/kernel/random.h"
#include "render/kernel/ray.h"

namespace pdr {

inline constexpr float kDescend =
    1.5f;  ///< optical depth of a coarse cell's chord above which its fine cells are walked

/// Where a tentative collision happened, and what decides it.
template <class Real>
struct TentativeCollision {
    typename Numbers<Real>::Mask happened;
    Real extinction, majorant;  ///< 1/mm; extinction <= majorant
    Real u;                     ///< a number for the decision
};

template <class Real>
class Flight {
  public:
    using Int = typename Numbers<Real>::Int;
    using Mask = typename Numbers<Real>::Mask;

    Real t;  ///< mm from the ray's origin

    /// The part of a ray that can meet matter, ready to fly. Empty (t >= end) where there is none.
    PDR_HD_INLINE void start(const FlatMajorants& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real length, const RandomStreamOf<Real>& random) {
        t = Real{};
        end_ = length;
        x_.start(origin.x, direction.x, grid.occupiedLow.x, grid.occupiedHigh.x, t, end_);
        y_.start(origin.y, direction.y, grid.occupiedLow.y, grid.occupiedHigh.y, t, end_);
        z_.start(origin.z, direction.z, grid.occupiedLow.z, grid.occupiedHigh.z, t, end_);
        x_.enter(t, grid.fineSize.x);
        y_.enter(t, grid.fineSize.y);
        z_.enter(t, grid.fineSize.z);
        random_ = random;
        Real u;
        random_.pair(t < end_, u, decision_);
        depth_ = negativeLog(u);
        rest_ = Real{};
    }

    PDR_HD Mask flying() const { return t < end_; }
    PDR_HD void stop(Mask mask) { end_ = mask ? Real{} - 1.0f : end_; }

    /// Where `mask` holds: lane l goes on with the flight of lane from[l] of `other`.
    void take(Mask mask, const Flight& other, Int from) {
        const auto taken = [mask, from](auto& mine, const auto& theirs) {
            mine = mask ? shuffled(theirs, from) : mine;
        };
        const auto takenAxis = [&](Axis& mine, const Axis& theirs) {
            taken(mine.origin, theirs.origin);
            taken(mine.direction, theirs.direction);
            taken(mine.inverse, theirs.inverse);
            taken(mine.cell, theirs.cell);
            taken(mine.up, theirs.up);
        };
        taken(t, other.t);
        taken(end_, other.end_);
        taken(depth_, other.depth_);
        taken(decision_, other.decision_);
        taken(rest_, other.rest_);
        takenAxis(x_, other.x_);
        takenAxis(y_, other.y_);
        takenAxis(z_, other.z_);
        random_.counter = selected(mask, shuffled(other.random_.counter, from), random_.counter);
        random_.key = selected(mask, shuffled(other.random_.key, from), random_.key);
    }

    /// One step of every lane that is flying.
    PDR_HD_INLINE TentativeCollision<Real> step(const FlatScene& scene) {
        const FlatMajorants& grid = scene.majorants;
        const Mask active = flying();

        const Real leaveCoarse = smaller(leave<16>(), end_);
        const Real coarse = gather(grid.coarse, coarseIndex(grid, active));
        const Mask descend = active & (coarse * (leaveCoarse - t) > kDescend);
        Real leave = leaveCoarse, majorant = coarse;
        if (any(descend)) {
            leave = descend ? smaller(this->template leave<4>(), end_) : leave;
            majorant = descend ? gather(grid.fine, fineIndex(grid, descend)) : majorant;
        }
        leave = larger(leave, t);

        const Real ahead = majorant * (leave - t);
        TentativeCollision<Real> collision;
        collision.happened = active & (depth_ < ahead);
        const Mask onward = active & !(collision.happened);
        const Real hop = depth_ / majorant + rest_, there = t + hop;
        rest_ = collision.happened ? hop - (there - t) : (onward ? Real{} : rest_);
        t = collision.happened ? there : (onward ? leave : t);
        depth_ = onward ? depth_ - ahead : depth_;
        x_.advance(onward, descend, leave);
        y_.advance(onward, descend, leave);
        z_.advance(onward, descend, leave);

        collision.majorant = majorant;
        collision.extinction = Real{};
        collision.u = decision_;
        if (any(collision.happened)) {
            const Mask happened = collision.happened;
            const Vec3<Real> position{x_.at(t), y_.at(t), z_.at(t)};
            collision.extinction = extinction(scene, position);
            Real u, decision;
            random_.pair(happened, u, decision);
            depth_ = happened ? negativeLog(u) : depth_;
            decision_ = happened ? decision : decision_;
        }
        return collision;
    }

  private:
    /// The flight along one axis of the grid.
    struct Axis {
        Real origin, direction, inverse;
        Int cell;  ///< fine cell
        Int up;    ///< 1: moves to higher cells, 0: to lower ones

        PDR_HD_INLINE void start(Real from, Real along, float low, float high, Real& enter, Real& leave) {
            origin = from;
            // A component of 0 becomes one that reaches no border within any volume.
            direction = ((along < 1e-20f) & (along > -1e-20f)) ? Real{} + 1e-20f : along;
            inverse = 1.0f / direction;
            up = direction > 0.0f ? Int{} + 1 : Int{};
            const Real a = (low - origin) * inverse, b = (high - origin) * inverse;
            enter = larger(enter, smaller(a, b));
            leave = smaller(leave, larger(a, b));
        }

        PDR_HD Real at(Real t) const { return origin + direction * t; }

        PDR_HD void enter(Real t, int cells) { cell = clamped(fineCell(at(t)), Int{}, Int{} + (cells - 1)); }

        /// Distance at which the ray leaves its cell of Edge voxels along this axis.
        template <int Edge>
        PDR_HD Real leave() const {
            constexpr int kShift = Edge == 16 ? 2 : 0;
            return (toFloat(((cell >> kShift) + up) * Edge - 4) - origin) * inverse;
        }

        /// Into the cell beyond `leave`: the neighbour along the axis whose border was reached. Along the others a fine
        /// cell stays, and in a coarse one the fine cell is found anew, inside it.
        PDR_HD_INLINE void advance(Mask onward, Mask descend, Real leaveAt) {
            const Int low = descend ? cell : (cell & ~3), high = descend ? cell : (cell | 3);
            const Real reach = descend ? leave<4>() : leave<16>();
            const Int inside = clamped(fineCell(at(leaveAt)), low, high);
            const Int beyond = up > 0 ? high + 1 : low - 1;
            const Int next = reach <= leaveAt ? beyond : inside;
            cell = onward ? next : cell;
        }

        PDR_HD static Int fineCell(Real position) { return toInt(position * 0.25f + 1.0f); }
        PDR_HD static Int clamped(Int value, Int low, Int high) {
            value = value < low ? low : value;
            return value > high ? high : value;
        }
    };

    template <int Edge>
    PDR_HD Real leave() const {
        return smaller(x_.template leave<Edge>(), smaller(y_.template leave<Edge>(), z_.template leave<Edge>()));
    }

    // Lanes that do not fly may stand outside the grid: they read cell 0.
    PDR_HD Int coarseIndex(const FlatMajorants& grid, Mask mask) const {
        const Int index = ((z_.cell >> 2) * grid.coarseSize.y + (y_.cell >> 2)) * grid.coarseSize.x + (x_.cell >> 2);
        return mask ? index : Int{};
    }
    PDR_HD Int fineIndex(const FlatMajorants& grid, Mask mask) const {
        const Int index = (z_.cell * grid.fineSize.y + y_.cell) * grid.fineSize.x + x_.cell;
        return mask ? index : Int{};
    }

    Axis x_, y_, z_;
    Real end_, depth_, decision_;
    Real rest_;  ///< of the way, what t does not hold: far out a float is coarser than steps through the densest tissue
    RandomStreamOf<Real> random_;
};

}  // namespace pdr
