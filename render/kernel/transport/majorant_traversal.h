#pragma once
/// Traversal of the two-level grid of extinction bounds by a ray, from one tentative collision to the next.
///
/// A step ends at a tentative collision or at the border of a cell, whichever comes first. The cell is a coarse one (16
/// voxels) where the optical depth under its bound is at most kFineMajorantDepth, else a fine one (4 voxels). Where
/// even the depth of the fine cell exceeds kVoxelMajorantDepth, the eight surrounding voxels are read, and their own
/// bound holds up to the border of their cell: dense tissue then costs one look-up per voxel instead of a fetch per
/// free path. The remaining optical depth is carried from cell to cell, never drawn anew. This acceleration never
/// changes the image. Tentative collisions after Woodcock et al. 1965.

#include "render/base/cells.h"
#include "render/kernel/bounds/cell_bound.h"
#include "render/kernel/grid_ray.h"
#include "render/kernel/random.h"
#include "render/kernel/ray.h"

namespace pdr {

/// Optical depth of a coarse cell's chord above which its fine cells are traversed.
inline constexpr float kFineMajorantDepth = 1.5f;
/// Optical depth of a fine cell's chord above which its voxels are traversed.
inline constexpr float kVoxelMajorantDepth = 12;

/// Returns FlatMajorants::dense of a volume whose highest bound is `highest` [1/mm].
PDR_HD inline bool mayBeDense(const FlatVolume& volume, float highest) {
    // The longest chord of an upright grid. In a sheared one another may be half as long again: voxels come in later.
    const float chord = kFineCell * glm::length(volume.localFromIndex * vec3(1));
    return highest * chord > kVoxelMajorantDepth;
}

/// Where a tentative collision happened, and what decides whether it is real.
template <class Real>
struct TentativeCollision {
    typename SimdTraits<Real>::Mask happened;
    typename SimdTraits<Real>::Mask voxelMajorant;  ///< the bound is that of the surrounding voxels
    Real extinction, majorant;                      ///< 1/mm; extinction <= majorant
    Real u;                                         ///< random number for the decision
};

/// Traverses the grid along one ray, or along several in lanes. Dense: for tissue that may need bounds of voxels; see
/// FlatMajorants::dense. Without it, the code for them is not compiled.
template <class Real, bool Dense>
class MajorantTraversal {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    Real t;  ///< mm from the ray's origin

    /// Starts at the beginning of the part of a ray that can meet tissue. isActive() is false at once if there is none.
    PDR_HD_INLINE void start(const FlatMajorants& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real length, const RandomStreamOf<Real>& random) {
        t = Real{};
        end_ = length;
        ray_.start(grid, origin, direction, t, end_);
        random_ = random;
        Real u;
        random_.pair(t < end_, u, decision_);
        depth_ = negativeLog(u);
        carry_ = Real{};
    }

    PDR_HD Mask isActive() const { return t < end_; }
    PDR_HD void stop(Mask mask) { end_ = mask ? Real{} - 1.0f : end_; }

    /// Copies the flight of lane from[l] of `other` into lane l, where `mask` holds.
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
        ray_.take(mask, other.ray_, from);
        random_.counter = selected(mask, permuted(other.random_.counter, from), random_.counter);
        random_.key = selected(mask, permuted(other.random_.key, from), random_.key);
    }

    /// Makes one step in every active lane.
    PDR_HD_INLINE TentativeCollision<Real> step(const FlatScene& scene) {
        const Mask active = isActive();
        const MajorantCell here = look(scene, active);
        const Real leave = here.leave, majorant = here.majorant;

        // Decide whether a tentative collision happens before the border of the cell.
        const Real ahead = majorant * (leave - t);
        TentativeCollision<Real> collision;
        collision.happened = active & (depth_ < ahead);
        const Mask onward = active & !(collision.happened);
        Real there = t, step{};
        if (any(collision.happened)) {  // division by 0 is slow on a GPU, and most cells are empty
            step = depth_ / majorant;
            if constexpr (Dense)
                step = step + carry_;
            there = t + step;
        }
        if constexpr (Dense)
            carry_ = collision.happened ? step - (there - t) : (onward ? Real{} : carry_);
        // Move to the collision or into the next cell.
        t = collision.happened ? there : (onward ? leave : t);
        depth_ = onward ? depth_ - ahead : depth_;
        ray_.advance(onward, here.within, here.borders, leave);

        // Evaluate the extinction at the collision and draw the next free path.
        collision.voxelMajorant = here.voxelMajorant;
        collision.majorant = majorant;
        collision.extinction = Real{};
        collision.u = decision_;
        if (any(collision.happened)) {
            const Mask happened = collision.happened;
            const Vec3<Real> position = ray_.at(t);
            Real hu{};
            if (!Dense || any(happened & !(here.voxelMajorant)))
                hu = hounsfield(scene.volume, position);
            if (Dense && any(happened & here.voxelMajorant))
                hu = here.voxelMajorant ? trilinear(here.voxels, fractionsIn(here.voxels, position)) : hu;
            collision.extinction = extinction(scene, position, hu, happened);
            Real u, decision;
            random_.pair(happened, u, decision);
            depth_ = happened ? negativeLog(u) : depth_;
            decision_ = happened ? decision : decision_;
        }
        return collision;
    }

  private:
    static constexpr int kFinest = Dense ? 1 : 4;  ///< edge of the smallest cells that are traversed [voxels]

    /// The cell that a ray is in.
    struct MajorantCell {
        Int within;          ///< the cell is within + 1 of the smallest cells wide
        Vec3<Real> borders;  ///< mm from the ray's origin to the cell's border along each axis
        Real leave;          ///< mm from the ray's origin to the end of the cell or of the ray
        Real majorant;       ///< 1/mm
        Mask voxelMajorant;  ///< `voxels` have been read and give the bound
        VoxelCell<Real> voxels;

        /// Makes the cell the ray's cell of Edge voxels, where `mask` holds.
        template <int Edge>
        PDR_HD_INLINE void enter(const MajorantTraversal& flight, Mask mask) {
            within = mask ? Int{} + (Edge / kFinest - 1) : within;
            const Vec3<Real> reached = flight.ray_.template borders<Edge>();
            borders.x = mask ? reached.x : borders.x;
            borders.y = mask ? reached.y : borders.y;
            borders.z = mask ? reached.z : borders.z;
            leave = min(nearest(borders), flight.end_);
        }
    };

    /// Returns the cell of each active lane with its bound: coarse, fine or, for dense tissue, between voxels.
    PDR_HD_INLINE MajorantCell look(const FlatScene& scene, Mask active) const {
        const FlatMajorants& grid = scene.majorants;
        MajorantCell here;
        here.within = Int{} + (16 / kFinest - 1);
        here.borders = ray_.template borders<16>();
        here.leave = min(nearest(here.borders), end_);
        here.majorant = gather(grid.coarse, ray_.template cellIndex<16>(grid.coarseSize, active));
        const Mask descend = active & (here.majorant * (here.leave - t) > kFineMajorantDepth);
        if (any(descend)) {
            here.template enter<4>(*this, descend);
            const Int fine = ray_.template cellIndex<4>(grid.fineSize, descend);
            here.majorant = descend ? gather(grid.fine, fine) : here.majorant;
        }
        here.voxelMajorant = descend & (here.majorant * (here.leave - t) > kVoxelMajorantDepth);
        if constexpr (Dense)
            if (any(here.voxelMajorant)) {
                here.voxels = nearestCell(scene.volume, ray_.voxel(), here.voxelMajorant);
                const Real bound = extinctionBound(scene, here.voxels, here.voxelMajorant);
                here.template enter<1>(*this, here.voxelMajorant);
                here.majorant = here.voxelMajorant ? min(here.majorant, bound) : here.majorant;
            }
        here.leave = max(here.leave, t);
        return here;
    }

    GridRay<Real, kFinest> ray_;
    Real end_, depth_, decision_;
    /// The part of the distance that t cannot hold: far from the origin a float is coarser than steps through the
    /// densest tissue.
    Real carry_;
    RandomStreamOf<Real> random_;
};

}  // namespace pdr
