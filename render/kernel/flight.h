#pragma once
/// A ray on its way through the two-level grid of extinction bounds, from one tentative collision to the next.
///
/// A step ends at a tentative collision or at the border of a cell, whichever comes first. The cell is a coarse one
/// (16 voxels) where its bound promises at most kDescend collisions, else a fine one (4 voxels). Where even that one
/// promises more than kLookClosely, the eight voxels around are read, and their own bound holds to the border of their
/// cube: dense tissue costs a look per voxel instead of a fetch per free path. The optical depth still to go is carried
/// from cell to cell, never drawn anew. Cells are whole numbers that only ever move forward, so rounding can neither
/// stall nor reverse a ray. An accelerator: it never changes the picture. Grid walk after Amanatides & Woo 1987;
/// tentative collisions after Woodcock et al. 1965.

#include "render/kernel/medium.h"
#include "render/kernel/random.h"
#include "render/kernel/ray.h"

namespace pdr {

inline constexpr float kDescend =
    1.5f;  ///< optical depth of a coarse cell's chord above which its fine cells are walked
inline constexpr float kLookClosely = 8;  ///< optical depth of a fine cell's chord above which its voxels are walked

/// Where a tentative collision happened, and what decides it.
template <class Real>
struct TentativeCollision {
    typename Numbers<Real>::Mask happened;
    typename Numbers<Real>::Mask closely;  ///< the voxels around were looked at for a bound
    Real extinction, majorant;             ///< 1/mm; extinction <= majorant
    Real u;                                ///< a number for the decision
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
        takenAxis(x_, other.x_);
        takenAxis(y_, other.y_);
        takenAxis(z_, other.z_);
        random_.counter = selected(mask, shuffled(other.random_.counter, from), random_.counter);
        random_.key = selected(mask, shuffled(other.random_.key, from), random_.key);
    }

    /// One step of every lane that is flying.
    PDR_HD_INLINE TentativeCollision<Real> step(const FlatScene& scene) {
        const Mask active = flying();
        const Surroundings here = look(scene, active);
        const Real leave = here.leave, majorant = here.majorant;

        const Real ahead = majorant * (leave - t);
        TentativeCollision<Real> collision;
        collision.happened = active & (depth_ < ahead);
        const Mask onward = active & !(collision.happened);
        t = collision.happened ? t + depth_ / majorant : (onward ? leave : t);
        depth_ = onward ? depth_ - ahead : depth_;
        x_.advance(onward, here.within, leave);
        y_.advance(onward, here.within, leave);
        z_.advance(onward, here.within, leave);

        collision.closely = here.closely;
        collision.majorant = majorant;
        collision.extinction = Real{};
        collision.u = decision_;
        if (any(collision.happened)) {
            const Mask happened = collision.happened;
            const Vec3<Real> position{x_.at(t), y_.at(t), z_.at(t)};
            Real hu{};
            if (any(happened & !(here.closely)))
                hu = hounsfield(scene.volume, position);
            if (any(happened & here.closely))
                hu = here.closely ? hounsfield(here.cube, position) : hu;
            collision.extinction = extinctionOf(scene.transferFunction, hu);
            Real u, decision;
            random_.pair(happened, u, decision);
            depth_ = happened ? negativeLog(u) : depth_;
            decision_ = happened ? decision : decision_;
        }
        return collision;
    }

  private:
    /// Where a ray stands: in a cell of within + 1 voxels.
    struct Surroundings {
        Real leave;     ///< mm from the ray's origin to the end of the cell, or of the ray
        Real majorant;  ///< 1/mm
        Int within;     ///< 15, 3 or 0
        Mask closely;   ///< `cube` is known and decides
        Cube<Real> cube;
    };

    PDR_HD_INLINE Surroundings look(const FlatScene& scene, Mask active) const {
        const FlatMajorants& grid = scene.majorants;
        Surroundings here;
        here.within = Int{} + 15;
        here.leave = smaller(leaveCell(here.within), end_);
        here.majorant = gather(grid.coarse, coarseIndex(grid, active));
        const Mask descend = active & (here.majorant * (here.leave - t) > kDescend);
        if (any(descend)) {
            here.within = descend ? Int{} + 3 : here.within;
            here.leave = descend ? smaller(leaveCell(Int{} + 3), end_) : here.leave;
            here.majorant = descend ? gather(grid.fine, fineIndex(grid, descend)) : here.majorant;
        }
        here.closely = descend & (here.majorant * (here.leave - t) > kLookClosely);
        if (any(here.closely)) {
            here.cube = cubeAt(scene.volume, x_.cell - 4, y_.cell - 4, z_.cell - 4);
            const Real bound = extinctionBound(scene.transferFunction, here.cube);
            here.within = here.closely ? Int{} : here.within;
            here.leave = here.closely ? smaller(leaveCell(Int{}), end_) : here.leave;
            here.majorant = here.closely ? smaller(here.majorant, bound) : here.majorant;
        }
        here.leave = larger(here.leave, t);
        return here;
    }

    /// The flight along one axis of the grid.
    struct Axis {
        Real origin, direction, inverse;
        Int cell;  ///< between which voxels: the whole part of the index coordinate, + 4
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

        PDR_HD void enter(Real t, int cells) { cell = clamped(cellAt(at(t)), Int{}, Int{} + (4 * cells - 1)); }

        /// The first cell beyond the larger one that holds `cell` and is within + 1 cells wide.
        PDR_HD Int beyond(Int within) const { return up > 0 ? (cell | within) + 1 : (cell & ~within) - 1; }

        /// Distance at which the ray leaves that larger cell along this axis.
        PDR_HD Real leave(Int within) const {
            const Int border = up > 0 ? (cell | within) + 1 : (cell & ~within);
            return (toFloat(border - 4) - origin) * inverse;
        }

        /// Into the cell beyond `leaveAt`: the neighbour along the axis whose border was reached. Along the others the
        /// smallest cell is found anew, inside the larger one.
        PDR_HD_INLINE void advance(Mask onward, Int within, Real leaveAt) {
            const Int inside = clamped(cellAt(at(leaveAt)), cell & ~within, cell | within);
            const Int next = leave(within) <= leaveAt ? beyond(within) : inside;
            cell = onward ? next : cell;
        }

        PDR_HD static Int cellAt(Real position) { return toInt(position + 4.0f); }
        PDR_HD static Int clamped(Int value, Int low, Int high) {
            value = value < low ? low : value;
            return value > high ? high : value;
        }
    };

    PDR_HD Real leaveCell(Int within) const {
        return smaller(x_.leave(within), smaller(y_.leave(within), z_.leave(within)));
    }

    // Lanes that do not fly may stand outside the grid: they read cell 0.
    PDR_HD Int coarseIndex(const FlatMajorants& grid, Mask mask) const {
        const Int index = ((z_.cell >> 4) * grid.coarseSize.y + (y_.cell >> 4)) * grid.coarseSize.x + (x_.cell >> 4);
        return mask ? index : Int{};
    }
    PDR_HD Int fineIndex(const FlatMajorants& grid, Mask mask) const {
        const Int index = ((z_.cell >> 2) * grid.fineSize.y + (y_.cell >> 2)) * grid.fineSize.x + (x_.cell >> 2);
        return mask ? index : Int{};
    }

    Axis x_, y_, z_;
    Real end_, depth_, decision_;
    RandomStreamOf<Real> random_;
};

}  // namespace pdr
