#pragma once
/// Free flight by exact inversion: the distance along a ray at which it has passed a given optical depth. It needs no
/// bounds and no tentative collisions, and one random number, of which the distance is a monotone function, as
/// low-discrepancy numbers (sobol.h) require. Between voxels and along a linear piece of the curve the extinction is a
/// cubic polynomial of the distance, so that its integral is known in closed form; only the end of the flight within
/// such a segment is found by Newton's method. A flight that leaves the volume yields the transmittance, since it has
/// passed the optical depth of the whole ray.

#include <type_traits>

#include "render/kernel/attenuation.h"
#include "render/kernel/random.h"
#include "render/kernel/ray.h"
#include "render/kernel/transport/light_flight.h"
#include "render/kernel/walk/piece_walk.h"
#include "render/kernel/walk/thin_walk.h"

namespace pdr {

/// The optical depth from 0 to s in [0, 1] of a segment whose extinction is a cubic: a polynomial of degree four by its
/// Bernstein coefficients except the first, which is 0. It rises from 0 to 1, in units of the whole segment's depth.
template <class Real>
struct DepthPassed {
    Cubic<Real> extinction;  ///< extinction divided by its mean

    PDR_HD_INLINE Real at(Real s) const {
        const Real c1 = 0.25f * extinction.b0, c2 = c1 + 0.25f * extinction.b1, c3 = c2 + 0.25f * extinction.b2;
        const Real c4 = c3 + 0.25f * extinction.b3;
        const Real r = 1.0f - s;
        return s * (r * r * (4.0f * r * c1 + 6.0f * s * c2) + s * s * (4.0f * r * c3 + s * c4));
    }
    PDR_HD_INLINE Real slopeAt(Real s) const { return extinction.at(s); }
};

/// Returns the fraction of a segment of `length` after which a flight has passed the depth `left`; it lies within the
/// segment.
template <class Real>
PDR_HD_INLINE Real flightEndOn(const OpticsAlong<Real>& along, Real length, Real left,
                               typename SimdTraits<Real>::Mask ended) {
    const Real scale = 1.0f / along.meanExtinction;
    const auto relative = [&](Real fraction) {
        return max(along.extinction + along.extinctionRise * fraction, Real{}) * scale;
    };
    const DepthPassed<Real> depth{{relative(along.fraction.b0), relative(along.fraction.b1),
                                   relative(along.fraction.b2), relative(along.fraction.b3)}};
    const Real wanted = left * scale / length;
    return whereMonotoneIs(depth, wanted, Real{}, Real{} + 1.0f, ended);
}

/// How a flight passes thin tissue: by exact integrals, or by looks (ThinWalk), which cost less; light may pass all
/// tissue by looks (LightFlight). All are unbiased.
enum class ThinTissue { solved, looked, allLooked };

/// The flight of one ray, or of several in lanes. Kind: see PieceWalk.
template <class Real, Tissue Kind = Tissue::whole, FlightEnd End = FlightEnd::place,
          ThinTissue Thin = ThinTissue::solved>
class FreeFlight {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    /// Distance at which the ray has passed the depth [mm], 0 for FlightEnd::whether; -1: it never does.
    Real distance = Real{} - 1.0f;
    Real further = Real{} - 1.0f;  ///< with FlightEnd::places: the same for the further depth
    Real passed{};                 ///< optical depth of the whole ray where it passes them

    static constexpr FlightEnd kEnd = End;
    static constexpr bool kLooks = Thin == ThinTissue::looked;

    /// Starts the flight. `depth`: the optical depth to pass; > 0. `random`: for looks.
    PDR_HD_INLINE void start(const FlatScene& scene, const Vec3<Real>& origin, const Vec3<Real>& direction, Real length,
                             Real depth, const RandomStreamOf<Real>& random = {}) {
        if constexpr (kLooks)
            walk_.start(scene.majorants, origin, direction, length, scene.thinBound, random);
        else
            walk_.start(scene.majorants, origin, direction, length);
        depth_ = depth;
    }
    /// Starts the flight of one ray and discards any flight before.
    PDR_HD_INLINE void start(const FlatScene& scene, const Ray& ray, float depth,
                             const RandomStreamOf<Real>& random = {}) requires std::is_same_v<Real, float> {
        *this = FreeFlight();
        start(scene, {ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z},
              ray.length, depth, random);
    }
    /// With FlightEnd::places: lets the flight go on to this depth, no less than that of start().
    PDR_HD_INLINE void goOnTo(Real depth) requires(End == FlightEnd::places) { furtherDepth_ = depth; }

    PDR_HD Mask going() const { return walk_.going(); }

    PDR_HD_INLINE void step(const FlatScene& scene) {
        step(scene, [](const OpticsAlong<Real>& along, const Way& way, Real left, Mask ended) {
            return way.begin + way.length * endOn(along, way, left, ended);
        });
    }
    /// Makes one step; placeOf(along, way, left, ended) returns where flights end that pass the depth `left` on the
    /// segment `way`, in the lanes of `ended`. FlightEnd::whether does not ask.
    template <class PlaceOf>
    PDR_HD_INLINE void step(const FlatScene& scene, PlaceOf&& placeOf) {
        Mask ended{};
        walk_.step(scene, [&](const Way& way, Mask ready, Mask) {
            const OpticsAlong<Real> along = opticsAlong(scene.optics, way.piece, way.hu);
            const Real extinction = meanExtinctionOn<Kind>(along, way);
            Real depth = extinction * way.length;
            const Mask looks = ready & walk_.cells().looking();
            if constexpr (kLooks)
                if (any(looks))
                    depth = looked(looks, extinction, depth);
            const Real passed = this->passed + depth;
            ended = ready & (passed > depth_);
            if constexpr (End == FlightEnd::whether) {
                distance = ended ? Real{} : distance;
            } else {
                for (Mask reached = ended; any(reached);) {
                    Real there{};
                    const Mask inside = reached & !looks;
                    if (any(inside))
                        there = placeOf(along, way, depth_ - this->passed, inside);
                    if constexpr (kLooks)
                        there = looks ? walk_.cells().looks().first : there;
                    reached = arrive(reached, there, passed, ended);
                }
            }
            this->passed = ready ? passed : this->passed;
            return ready;
        });
        walk_.stop(ended);
    }

    /// Starts lane l, where `mask` holds, on the ray of lane from[l] of `other`, which has been started but not
    /// stepped.
    void take(Mask mask, const FreeFlight& other, Int from) {
        walk_.take(mask, other.walk_, from);
        depth_ = mask ? permuted(other.depth_, from) : depth_;
        distance = mask ? Real{} - 1.0f : distance;
        passed = mask ? Real{} : passed;
        if constexpr (End == FlightEnd::places) {
            furtherDepth_ = mask ? permuted(other.furtherDepth_, from) : furtherDepth_;
            further = mask ? Real{} - 1.0f : further;
        }
    }

    using Walk = PieceWalk<Real, Kind, std::conditional_t<kLooks, ThinWalk<Real>, CellWalk<Real>>>;
    using Way = typename Walk::Way;

  private:
    /// Notes that the lanes of `reached` pass a depth `there`, and takes from `ended` those that fly on. Returns the
    /// lanes that pass the further depth on the same segment. `passed`: depth at its end.
    PDR_HD_INLINE Mask arrive(Mask reached, Real there, Real passed, Mask& ended) {
        if constexpr (End != FlightEnd::places) {
            distance = reached ? there : distance;
            return Mask{};
        } else {
            const Mask first = unfolded(reached & (distance < 0.0f)),
                       last = unfolded(reached & (depth_ >= furtherDepth_));
            distance = first ? there : distance;
            further = last ? there : further;
            depth_ = reached ? furtherDepth_ : depth_;
            const Mask onward = unfolded(reached & !last), again = unfolded(onward & (passed > furtherDepth_));
            ended = unfolded(ended & !unfolded(onward & !again));
            return again;
        }
    }

    /// Makes looks of the segments that are. Returns the optical depth of each segment; of a look that another follows,
    /// none.
    PDR_HD_INLINE Real looked(Mask looks, Real extinction, Real depth) {
        const Mask done = walk_.cells().look(looks, extinction);
        const Real taken = depthThatTakes(walk_.cells().looks().taken);
        return looks ? (done ? taken : Real{}) : depth;
    }

    PDR_HD_INLINE static Real endOn(const OpticsAlong<Real>& along, const Way& way, Real left, Mask ended) {
        if constexpr (Kind == Tissue::parted) {
            const PartedExtinction<Real> extinction{along, way.hu, way.weight, way.masked, way.mixed};
            return endOnSeen(along, way, left, ended, extinction, extinction.differs(), extinction.mean());
        } else if constexpr (Kind == Tissue::masked) {
            const SeenAlong<Real> seen = seenAlong(along, way.weight);
            return endOnSeen(along, way, left, ended, SeenExtinction<Real>{along, way.weight}, seen.partly,
                             seen.meanExtinction);
        } else
            return flightEndOn(along, way.length, left, ended);
    }

    /// Returns what flightEndOn() returns, for a segment of which `extinction` is the visible one where `differs`.
    template <class Extinction>
    PDR_HD_INLINE static Real endOnSeen(const OpticsAlong<Real>& along, const Way& way, Real left, Mask ended,
                                        const Extinction& extinction, Mask differs, Real meanExtinction) {
        const Mask partly = ended & differs;
        Real end = flightEndOn(along, way.length, left, ended & !differs);
        if (any(partly)) {
            const DepthPassedByGauss<Real, Extinction> depth{extinction, 1.0f / meanExtinction};
            const Real wanted = left * depth.scale / way.length;
            const Real found = whereMonotoneIs(depth, wanted, Real{}, Real{} + 1.0f, partly);
            end = partly ? found : end;
        }
        return end;
    }

    Walk walk_;
    Real depth_{};         ///< the next depth to pass
    Real furtherDepth_{};  ///< the last one, with FlightEnd::places
};

/// The flight to an end that passes thin tissue in a way.
template <class Real, Tissue Kind, FlightEnd End, ThinTissue Thin>
using FlightFor =
    std::conditional_t<Thin == ThinTissue::allLooked, LightFlight<Real, Kind>, FreeFlight<Real, Kind, End, Thin>>;

/// The result of a flight along one ray.
struct Flight {
    float distance;  ///< as in FreeFlight
    float passed;
    float further = -1;
};

/// `further`: the further depth, with FlightEnd::places.
template <class Flying>
PDR_HD inline Flight flown(const FlatScene& scene, const Ray& ray, float depth, const RandomStream& random,
                           [[maybe_unused]] float further = 0) {
    Flying flight;
    flight.start(scene, ray, depth, random);
    if constexpr (Flying::kEnd == FlightEnd::places)
        flight.goOnTo(further);
    while (flight.going())
        flight.step(scene);
    if constexpr (Flying::kEnd == FlightEnd::places)
        return {flight.distance, flight.passed, flight.further};
    else
        return {flight.distance, flight.passed};
}

/// The exact flight of one ray.
template <FlightEnd End = FlightEnd::place>
PDR_HD inline Flight freeFlight(const FlatScene& scene, const Ray& ray, float depth, float further = 0) {
    return forTissue(
        scene, [&]<Tissue Kind>() { return flown<FreeFlight<float, Kind, End>>(scene, ray, depth, {}, further); });
}

/// The flight of one ray that looks.
template <FlightEnd End = FlightEnd::place, ThinTissue Thin = ThinTissue::looked>
PDR_HD inline Flight lookFlight(const FlatScene& scene, const Ray& ray, float depth, const RandomStream& random,
                                float further = 0) {
    return forTissue(scene, [&]<Tissue Kind>() {
        return flown<FlightFor<float, Kind, End, Thin>>(scene, ray, depth, random, further);
    });
}

/// The flight of a path's first segment to the depths of its events, and of the light there: it looks where that pays.
template <FlightEnd End>
PDR_HD inline Flight firstFlight(const FlatScene& scene, const Ray& ray, float depth, const RandomStream& random,
                                 float further = 0) {
    if constexpr (End == FlightEnd::whether)
        if (scene.lightLooks)
            return lookFlight<End, ThinTissue::allLooked>(scene, ray, depth, random);
    return scene.looksAtThin ? lookFlight<End>(scene, ray, depth, random, further)
                             : freeFlight<End>(scene, ray, depth, further);
}

}  // namespace pdr
