#pragma once
/// A ray on its way through the two-level grid of extinction bounds, from one tentative collision to the next.
///
/// A step ends at a tentative collision or at the border of a cell, whichever comes first. The cell is a coarse one
/// (16 voxels) where its bound promises at most kDescend collisions, else a fine one (4 voxels). The optical depth
/// still to go is carried from cell to cell, never drawn anew. An accelerator: it never changes the picture. Tentative
/// collisions after Woodcock et al. 1965.

#include "render/kernel/grid_axis.h"
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
        taken(t, other.t);
        taken(end_, other.end_);
        taken(depth_, other.depth_);
        taken(decision_, other.decision_);
        taken(rest_, other.rest_);
        x_.take(mask, other.x_, from);
        y_.take(mask, other.y_, from);
        z_.take(mask, other.z_, from);
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
        advance(x_, onward, descend, leave);
        advance(y_, onward, descend, leave);
        advance(z_, onward, descend, leave);

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
    PDR_HD_INLINE void advance(GridAxis<Real, 4>& axis, Mask onward, Mask descend, Real leaveAt) {
        const Int within = descend ? Int{} : Int{} + 3;
        const Real reach = descend ? axis.template leave<4>() : axis.template leave<16>();
        axis.advance(onward, within, reach, leaveAt);
    }

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

    GridAxis<Real, 4> x_, y_, z_;
    Real end_, depth_, decision_;
    Real rest_;  ///< of the way, what t does not hold: far out a float is coarser than steps through the densest tissue
    RandomStreamOf<Real> random_;
};

}  // namespace pdr
