#pragma once
/// A walk along a ray that looks at thin tissue and reads in full only what is thick. A cell whose bound promises at
/// most the optical depth kThinDepth is passed as a whole: its HU, and its weight, are those of one random place in it,
/// and NestedLooks makes of them an unbiased estimate of what the cell takes of the light. Elsewhere the walk goes from
/// one cell between voxels to the next, as CellWalk does.

#include "render/kernel/random.h"
#include "render/kernel/walk/cell_walk.h"

namespace pdr {

/// Optical depth that the bound of a cell promises at most on its longest way where it is looked at; see
/// FlatScene::thinBound.
inline constexpr float kThinDepth = 0.5f;

/// What a part of a ray takes of the light, from looks at random places:
///
///   1 - exp(-int_0^l sigma ds) = X1 (1 - X2 (1 - ...)),   X1 = l sigma(s1),   X2 = s1 sigma(s2) / p2,   ...
///
/// with s1 uniform on the part, s2 uniform in front of s1, and so on. Each further look is taken with the probability
/// p2 = s1 * bound that the way in front of the last one promises, and counts 1 / p2 where it is taken. The estimate is
/// unbiased and lies in [0, l * bound]. Given s1, light collides at s1 with the right density, so that an event there
/// is exactly distributed.
template <class Real>
class NestedLooks {
  public:
    using Mask = typename SimdTraits<Real>::Mask;

    Real place{};  ///< where to look next [mm from the ray's origin]
    Real first{};  ///< where the first look was
    Real taken{};  ///< by the looks so far

    /// Begins with the part [begin, begin + length] in the lanes of `mask`. `bound`: on the extinction there [1/mm];
    /// `u`: a random number.
    PDR_HD_INLINE void begin(Mask mask, Real begin, Real length, Real bound, Real u) {
        begin_ = mask ? begin : begin_;
        bound_ = mask ? bound : bound_;
        term_ = mask ? -(bound * length) : term_;
        taken = mask ? Real{} : taken;
        place = mask ? begin + length * u : place;
        first = mask ? place : first;
    }

    /// Takes the extinction at `place` into account. Returns the lanes that must look again, at a new `place`. `u`,
    /// `v`: random numbers.
    PDR_HD_INLINE Mask look(Mask mask, Real extinction, Real u, Real v) {
        const Real term = -term_ * lesser(extinction / bound_, Real{} + 1.0f);
        taken = mask ? taken + term : taken;
        term_ = mask ? term : term_;
        const Real before = place - begin_;
        const Mask again = unfolded(mask & (extinction > 0.0f) & (u < bound_ * before));
        place = again ? begin_ + before * v : place;
        return again;
    }

  private:
    Real begin_{}, bound_{};
    Real term_{};  ///< the last look's part of `taken`
};

template <class Real>
class ThinWalk {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    /// Starts at the beginning of the part of a ray that can meet tissue. walking() is false at once if there is none.
    PDR_HD_INLINE void start(const FlatMajorants& grid, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real length, float thinBound, const RandomStreamOf<Real>& random) {
        thinBound_ = thinBound;
        t_ = Real{};
        end_ = length;
        ray_.start(grid, origin, direction, t_, end_);
        random_ = random;
        Real unused;
        random_.pair(t_ < end_, unused, next_);
    }

    PDR_HD Mask walking() const { return (t_ < end_) | looksAgain(); }
    PDR_HD void stop(Mask mask) {
        end_ = mask ? Real{} - 1.0f : end_;
        again_ = mask ? Real{} : again_;
    }
    /// Returns the distance from the ray's origin to the current position [mm].
    PDR_HD Real reached() const { return t_; }
    /// Returns the lanes whose segment is a look.
    PDR_HD Mask looking() const { return looking_ > 0.0f; }

    /// Moves the lanes of `mask`, all of them walking, through one cell: the largest that promises little, or else one
    /// between voxels. Returns the lanes that met tissue; `way` then describes it. A look has the same
    /// HU all along, and a length of 1.
    template <class Way>
    PDR_HD_INLINE Mask step(const FlatScene& scene, Mask mask, Way& way) {
        const FlatMajorants& grid = scene.majorants;
        const Mask again = mask & looksAgain();
        const Mask onward = unfolded(mask & !again);
        // Find the largest cell that is thin.
        Real bound = gather(grid.coarse, ray_.template cellIndex<16>(grid.coarseSize, onward));
        Mask thick = onward & (bound > 0.25f * thinBound_);
        Int within = thick ? Int{} + 3 : Int{} + 15;
        if (any(thick)) {
            bound = thick ? gather(grid.fine, ray_.template cellIndex<4>(grid.fineSize, thick)) : bound;
            thick = thick & (bound > thinBound_);
            within = thick ? Int{} : within;
        }
        const Vec3<Real> borders = ray_.borders(within);
        const Real leave = greater(lesser(nearest(borders), end_), t_);
        // Look at it, or read all of it.
        const Mask thin = onward & !thick & (bound > 0.0f);
        const Mask look = thin | again, met = look | thick;
        looking_ = mask ? (look ? Real{} + 1.0f : Real{}) : looking_;
        if (any(met)) {
            Vec3<Int> voxel = ray_.voxel();
            Vec3<Real> from = ray_.at(t_), to = ray_.at(leave);
            way.length = met ? leave - t_ : way.length;
            if (any(look)) {
                looks_.begin(thin, t_, leave - t_, bound, next_);
                again_ = mask ? Real{} : again_;
                const Vec3<Real> place = ray_.at(looks_.place);
                from = chosen(look, place, from);
                to = chosen(look, place, to);
                // Rounding towards 0 is a voxel too high only in front of the first one, where it is clamped anyway.
                voxel = chosen(look, {toInt(place.x), toInt(place.y), toInt(place.z)}, voxel);
                way.length = look ? Real{} + 1.0f : way.length;
            }
            readCell(scene, voxel, met, from, to, way);
        }
        ray_.advance(onward, within, borders, leave);
        t_ = onward ? leave : t_;
        prefetchNext(scene);
        return met;
    }

    /// Takes the extinction of the looks in `mask` into account. Returns the lanes that are done; see NestedLooks.
    PDR_HD_INLINE Mask look(Mask mask, Real extinction) {
        Real u;
        random_.pair(mask, u, next_);
        const Mask again = looks_.look(mask, extinction, u, next_);
        again_ = again ? Real{} + 1.0f : again_;
        return mask & !again;
    }
    PDR_HD const NestedLooks<Real>& looks() const { return looks_; }

    /// Copies the state of lane from[l] of `other`, which has been started but not stepped, into lane l, where `mask`
    /// holds.
    void take(Mask mask, const ThinWalk& other, Int from) {
        thinBound_ = other.thinBound_;
        t_ = mask ? permuted(other.t_, from) : t_;
        end_ = mask ? permuted(other.end_, from) : end_;
        ray_.take(mask, other.ray_, from);
        next_ = mask ? permuted(other.next_, from) : next_;
        random_.counter = selected(mask, permuted(other.random_.counter, from), random_.counter);
        random_.key = selected(mask, permuted(other.random_.key, from), random_.key);
        again_ = mask ? Real{} : again_;
    }

  private:
    PDR_HD Mask looksAgain() const { return again_ > 0.0f; }

    /// Prefetches what the next step reads, unless it is a look.
    PDR_HD_INLINE void prefetchNext(const FlatScene& scene) const {
        const FlatMajorants& grid = scene.majorants;
        prefetch(grid.fine, ray_.template cellIndex<4>(grid.fineSize, t_ < end_));
        prefetchCell(scene.volume, nearestCorner(scene.volume, ray_.voxel(), t_ < end_));
    }

    GridRay<Real, 1> ray_{};
    Real t_{}, end_{};  ///< mm from the origin
    float thinBound_ = 0;
    NestedLooks<Real> looks_;
    Real looking_{};  ///< 1: the last segment was a look
    Real again_{};    ///< 1: another look follows
    RandomStreamOf<Real> random_{};
    Real next_{};  ///< the random number for the place in the next cell
};

}  // namespace pdr
