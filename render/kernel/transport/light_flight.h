#pragma once
/// The flight of light by looks alone, in tissue thin or thick: it reads the HU of single random places and solves no
/// integral. NestedLooks makes of them an unbiased estimate of what each step takes of the light. It has more noise
/// than an exact flight, which counts for less on the way to a light than on the camera's ray.

#include <type_traits>

#include "render/kernel/attenuation.h"
#include "render/kernel/medium.h"
#include "render/kernel/ray.h"
#include "render/kernel/walk/thin_walk.h"

namespace pdr {

/// What a flight is for: where it ends, where it passes two depths, or only whether it ends, which costs no search.
enum class FlightEnd { place, places, whether };

/// The light of one ray, or of several in lanes. Kind: the scene's tissue; code for masks and parts is compiled only
/// where it says so.
template <class Real, Tissue Kind>
class LightFlight {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    static constexpr FlightEnd kEnd = FlightEnd::whether;

    Real distance = Real{} - 1.0f;  ///< 0: the ray passes the depth; -1: it never does
    Real passed{};                  ///< optical depth of the whole ray where distance is -1

    /// Starts the flight. `depth`: the optical depth to pass; > 0.
    PDR_HD_INLINE void start(const FlatScene& scene, const Vec3<Real>& origin, const Vec3<Real>& direction, Real length,
                             Real depth, const RandomStreamOf<Real>& random) {
        wholeBound_ = 2 * scene.thinBound;
        t_ = Real{};
        end_ = length;
        ray_.start(scene.majorants, origin, direction, t_, end_);
        depth_ = depth;
        random_ = random;
        Real unused;
        random_.pair(t_ < end_, unused, next_);
    }
    /// Starts the flight of one ray and discards any flight before.
    PDR_HD_INLINE void start(const FlatScene& scene, const Ray& ray, float depth,
                             const RandomStreamOf<Real>& random) requires std::is_same_v<Real, float> {
        *this = LightFlight();
        start(scene, {ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z},
              ray.length, depth, random);
    }

    PDR_HD Mask going() const { return (t_ < end_) | looking(); }

    /// Looks where the last step said, then takes the next step of lanes that need not look again.
    PDR_HD_INLINE void step(const FlatScene& scene) {
        // The bound ahead is read first, so that neither read waits for the other. Few lanes then do not need it.
        const Stretch ahead = stretchAhead(scene.majorants);
        const Mask looks = looking();
        if (any(looks))
            look(scene, looks);
        const Mask onward = (t_ < end_) & !looking();
        if (any(onward))
            goOn(ahead, onward);
        prefetchNext(scene);
    }

    /// Starts lane l, where `mask` holds, on the ray of lane from[l] of `other`, which has been started but not
    /// stepped.
    void take(Mask mask, const LightFlight& other, Int from) {
        const auto taken = [mask, from](auto& mine, const auto& theirs) {
            mine = mask ? permuted(theirs, from) : mine;
        };
        wholeBound_ = other.wholeBound_;
        taken(t_, other.t_);
        taken(end_, other.end_);
        taken(depth_, other.depth_);
        taken(next_, other.next_);
        ray_.take(mask, other.ray_, from);
        random_.counter = selected(mask, permuted(other.random_.counter, from), random_.counter);
        random_.key = selected(mask, permuted(other.random_.key, from), random_.key);
        looking_ = mask ? Real{} : looking_;
        distance = mask ? Real{} - 1.0f : distance;
        passed = mask ? Real{} : passed;
    }

  private:
    static constexpr float kMostTaken = 1 - 0x1p-24f;  ///< cells that promise 1 take no more, with rounding

    PDR_HD Mask looking() const { return looking_ > 0.0f; }

    /// Takes the tissue at the lanes' places into account, and ends flights that have passed their depth.
    PDR_HD_INLINE void look(const FlatScene& scene, Mask looks) {
        const Vec3<Real> place = ray_.at(looks_.place);
        const VoxelCell<Real> cell = nearestCell(scene.volume, voxelAt(place), looks);
        const Real extinction = extinctionAt(scene, place, trilinear(cell, fractionsIn(cell, place)), looks);
        Real u;
        random_.pair(looks, u, next_);
        const Mask done = looks & !looks_.look(looks, extinction, u, next_);
        looking_ = done ? Real{} : looking_;
        const Real taken = lesser(looks_.taken, Real{} + kMostTaken);
        passed = done ? passed + depthThatTakes(taken) : passed;
        const Mask ended = done & (passed > depth_);
        distance = ended ? Real{} : distance;
        end_ = ended ? Real{} - 1.0f : end_;
    }

    /// Returns the visible extinction in the lanes of `looks` [1/mm].
    PDR_HD_INLINE static Real extinctionAt(const FlatScene& scene, const Vec3<Real>& place, Real hu,
                                           [[maybe_unused]] Mask looks) {
        if constexpr (Kind == Tissue::parted)
            return extinction(scene, place, hu, looks);
        else if constexpr (Kind == Tissue::masked)
            return extinctionOf(scene.transferFunction, hu) * weightAt(scene, place);
        else
            return extinctionOf(scene.transferFunction, hu);
    }

    /// The part of a ray that one step passes.
    struct Stretch {
        Real bound;          ///< on the extinction [1/mm]
        Int within;          ///< its cell is within + 1 voxels wide
        Vec3<Real> borders;  ///< distances to the borders of that cell [mm]
        Real leave;          ///< its end [mm from the ray's origin]
    };

    /// Returns the part ahead: through the largest cell that promises little, or else as far as kThinDepth allows.
    PDR_HD_INLINE Stretch stretchAhead(const FlatMajorants& grid) const {
        const Mask flying = t_ < end_;
        Real bound = gather(grid.coarse, ray_.template cellIndex<16>(grid.coarseSize, flying));
        Mask thick = flying & (bound > 0.25f * wholeBound_);
        const Int within = thick ? Int{} + 3 : Int{} + 15;
        if (any(thick))
            bound = thick ? gather(grid.fine, ray_.template cellIndex<4>(grid.fineSize, thick)) : bound;
        thick = thick & (bound > wholeBound_);
        const Vec3<Real> borders = ray_.borders(within);
        Real leave = greater(lesser(nearest(borders), end_), t_);
        if (any(thick))
            leave = thick ? lesser(leave, t_ + kThinDepth / bound) : leave;
        return {bound, within, borders, leave};
    }

    /// Passes the part ahead, and says where to look in it.
    PDR_HD_INLINE void goOn(const Stretch& ahead, Mask onward) {
        const Mask tissue = onward & (ahead.bound > 0.0f);
        looks_.begin(tissue, t_, ahead.leave - t_, ahead.bound, next_);
        looking_ = tissue ? Real{} + 1.0f : looking_;
        ray_.advance(onward, ahead.within, ahead.borders, ahead.leave);
        t_ = onward ? ahead.leave : t_;
    }

    /// Prefetches what the next step reads.
    PDR_HD_INLINE void prefetchNext(const FlatScene& scene) const {
        const FlatMajorants& grid = scene.majorants;
        prefetch(grid.fine, ray_.template cellIndex<4>(grid.fineSize, t_ < end_));
        prefetchCell(scene.volume, nearestCorner(scene.volume, voxelAt(ray_.at(looks_.place)), looking()));
    }

    /// Rounding towards 0 is a voxel too high only in front of the first one, where it is clamped anyway.
    PDR_HD_INLINE static Vec3<Int> voxelAt(const Vec3<Real>& place) {
        return {toInt(place.x), toInt(place.y), toInt(place.z)};
    }

    GridRay<Real, 1> ray_{};
    Real t_{}, end_{};  ///< mm from the origin
    Real depth_{};
    float wholeBound_ = 0;  ///< bound up to which a fine cell is one step [1/mm]: on average it promises kThinDepth
    NestedLooks<Real> looks_;
    Real looking_{};  ///< 1: the next step looks
    RandomStreamOf<Real> random_{};
    Real next_{};  ///< the random number for the next place
};

}  // namespace pdr
