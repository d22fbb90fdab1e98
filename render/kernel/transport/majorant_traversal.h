#pragma once
/// A ray on its way through the two-level grid of extinction bounds, from one tentative collision to the next.
///
/// A step ends at a tentative collision or at the border of a cell, whichever comes first. The cell is a coarse one
/// (16 voxels) where its bound promises at most kFineMajorantDepth collisions, else a fine one (4 voxels). Where even that one
/// promises more than kVoxelMajorantDepth, the eight voxels around are read, and their own bound holds to the border of their
/// cube: dense tissue costs a look per voxel instead of a fetch per free path. The optical depth still to go is carried
/// from cell to cell, never drawn anew. An accelerator: it never changes the picture. Tentative
/// collisions after Woodcock et al. 1965.

#include "render/base/cells.h"
#include "render/kernel/grid_axis.h"
#include "render/kernel/medium.h"
#include "render/kernel/random.h"
#include "render/kernel/ray.h"

namespace pdr {

inline constexpr float kFineMajorantDepth =
    1.5f;  ///< optical depth of a coarse cell's chord above which its fine cells are walked
inline constexpr float kVoxelMajorantDepth = 12;  ///< optical depth of a fine cell's chord above which its voxels are walked

/// FlatMajorants::dense of a volume whose highest bound is `highest` [1/mm].
PDR_HD inline bool mayBeDense(const FlatVolume& volume, float highest) {
    const float chord =
        kFineCell * glm::length(volume.localFromIndex * vec3(1));  // the diagonal: axes are at right angles
    return highest * chord > kVoxelMajorantDepth;
}

/// Where a tentative collision happened, and what decides it.
template <class Real>
struct TentativeCollision {
    typename SimdTraits<Real>::Mask happened;
    typename SimdTraits<Real>::Mask voxelMajorant;  ///< the voxels around were looked at for a bound
    Real extinction, majorant;             ///< 1/mm; extinction <= majorant
    Real u;                                ///< a number for the decision
};

/// Dense: for tissue that may call for a close look; see FlatMajorants::dense. Without it the code for that is not
/// there.
template <class Real, bool Dense>
class MajorantTraversal {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    Real t;  ///< mm from the ray's origin

    /// The part of a ray that can meet tissue, ready to fly. Empty (t >= end) where there is none.
    PDR_HD_INLINE void start(const FlatMajorants& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real length, const RandomStreamOf<Real>& random) {
        t = Real{};
        end_ = length;
        x_.start(origin.x, direction.x, grid.occupiedLow.x, grid.occupiedHigh.x, t, end_);
        y_.start(origin.y, direction.y, grid.occupiedLow.y, grid.occupiedHigh.y, t, end_);
        z_.start(origin.z, direction.z, grid.occupiedLow.z, grid.occupiedHigh.z, t, end_);
        x_.enter(t, 4 / kFinest * grid.fineSize.x);
        y_.enter(t, 4 / kFinest * grid.fineSize.y);
        z_.enter(t, 4 / kFinest * grid.fineSize.z);
        random_ = random;
        Real u;
        random_.pair(t < end_, u, decision_);
        depth_ = negativeLog(u);
        carry_ = Real{};
    }

    PDR_HD Mask isActive() const { return t < end_; }
    PDR_HD void stop(Mask mask) { end_ = mask ? Real{} - 1.0f : end_; }

    /// Where `mask` holds: lane l goes on with the flight of lane from[l] of `other`.
    void take(Mask mask, const MajorantTraversal& other, Int from) {
        const auto taken = [mask, from](auto& mine, const auto& theirs) {
            mine = mask ? permuted(theirs, from) : mine;
        };
        taken(t, other.t);
        taken(end_, other.end_);
        taken(depth_, other.depth_);
        taken(decision_, other.decision_);
        if constexpr (Dense)
            taken(carry_, other.carry_);
        x_.take(mask, other.x_, from);
        y_.take(mask, other.y_, from);
        z_.take(mask, other.z_, from);
        random_.counter = selected(mask, permuted(other.random_.counter, from), random_.counter);
        random_.key = selected(mask, permuted(other.random_.key, from), random_.key);
    }

    /// One step of every lane that is flying.
    PDR_HD_INLINE TentativeCollision<Real> step(const FlatScene& scene) {
        const Mask active = isActive();
        const MajorantCell here = look(scene, active);
        const Real leave = here.leave, majorant = here.majorant;

        const Real ahead = majorant * (leave - t);
        TentativeCollision<Real> collision;
        collision.happened = active & (depth_ < ahead);
        const Mask onward = active & !(collision.happened);
        Real step = depth_ / majorant;
        if constexpr (Dense)
            step = step + carry_;
        const Real there = t + step;
        if constexpr (Dense)
            carry_ = collision.happened ? step - (there - t) : (onward ? Real{} : carry_);
        t = collision.happened ? there : (onward ? leave : t);
        depth_ = onward ? depth_ - ahead : depth_;
        x_.advance(onward, here.within, here.border.x, leave);
        y_.advance(onward, here.within, here.border.y, leave);
        z_.advance(onward, here.within, here.border.z, leave);

        collision.voxelMajorant = here.voxelMajorant;
        collision.majorant = majorant;
        collision.extinction = Real{};
        collision.u = decision_;
        if (any(collision.happened)) {
            const Mask happened = collision.happened;
            const Vec3<Real> position{x_.at(t), y_.at(t), z_.at(t)};
            Real hu{};
            if (!Dense || any(happened & !(here.voxelMajorant)))
                hu = hounsfield(scene.volume, position);
            if (Dense && any(happened & here.voxelMajorant))
                hu = here.voxelMajorant ? hounsfield(here.cube, position) : hu;
            collision.extinction = extinctionOf(scene.transferFunction, hu);
            Real u, decision;
            random_.pair(happened, u, decision);
            depth_ = happened ? negativeLog(u) : depth_;
            decision_ = happened ? decision : decision_;
        }
        return collision;
    }

  private:
    static constexpr int kFinest = Dense ? 1 : 4;  ///< edge of the smallest cells that are walked, voxels

    /// The cell that a ray stands in.
    struct MajorantCell {
        Int within;         ///< it is within + 1 of the smallest cells wide
        Vec3<Real> border;  ///< mm from the ray's origin to its border along each axis
        Real leave;         ///< mm from the ray's origin to its end, or to the ray's
        Real majorant;      ///< 1/mm
        Mask voxelMajorant;       ///< `cube` is known and decides
        Cube<Real> cube;

        /// Where `mask` holds the cell is the one of Edge voxels.
        template <int Edge>
        PDR_HD_INLINE void enter(const MajorantTraversal& flight, Mask mask) {
            within = mask ? Int{} + (Edge / kFinest - 1) : within;
            border.x = mask ? flight.x_.template leave<Edge>() : border.x;
            border.y = mask ? flight.y_.template leave<Edge>() : border.y;
            border.z = mask ? flight.z_.template leave<Edge>() : border.z;
            leave = min(min(border.x, min(border.y, border.z)), flight.end_);
        }
    };

    PDR_HD_INLINE MajorantCell look(const FlatScene& scene, Mask active) const {
        const FlatMajorants& grid = scene.majorants;
        MajorantCell here;
        here.within = Int{} + (16 / kFinest - 1);
        here.border = {x_.template leave<16>(), y_.template leave<16>(), z_.template leave<16>()};
        here.leave = min(min(here.border.x, min(here.border.y, here.border.z)), end_);
        here.majorant = gather(grid.coarse, cellIndex<16>(grid.coarseSize, active));
        const Mask descend = active & (here.majorant * (here.leave - t) > kFineMajorantDepth);
        if (any(descend)) {
            here.template enter<4>(*this, descend);
            here.majorant = descend ? gather(grid.fine, cellIndex<4>(grid.fineSize, descend)) : here.majorant;
        }
        here.voxelMajorant = descend & (here.majorant * (here.leave - t) > kVoxelMajorantDepth);
        if constexpr (Dense)
            if (any(here.voxelMajorant)) {
                here.cube = cubeAt(scene.volume, x_.cell - 4, y_.cell - 4, z_.cell - 4);
                const Real bound = extinctionBound(scene.transferFunction, here.cube);
                here.template enter<1>(*this, here.voxelMajorant);
                here.majorant = here.voxelMajorant ? min(here.majorant, bound) : here.majorant;
            }
        here.leave = max(here.leave, t);
        return here;
    }

    /// Index of the cell of Edge voxels. Lanes that do not fly may stand outside the grid: they read cell 0.
    template <int Edge>
    PDR_HD Int cellIndex(ivec3 size, Mask mask) const {
        constexpr int kShift = Edge / kFinest == 16 ? 4 : Edge / kFinest == 4 ? 2 : 0;
        const Int index = ((z_.cell >> kShift) * size.y + (y_.cell >> kShift)) * size.x + (x_.cell >> kShift);
        return mask ? index : Int{};
    }

    GridAxis<Real, kFinest> x_, y_, z_;
    Real end_, depth_, decision_;
    Real carry_;  ///< of the way, what t does not hold: far out a float is coarser than steps through the densest tissue
    RandomStreamOf<Real> random_;
};

}  // namespace pdr
