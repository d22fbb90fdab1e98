#pragma once
/// Free flight by exact inversion: how far a ray flies until it has passed a given optical depth. No bounds, no
/// tentative collisions and one random number, of which the flight's end is a monotone function: what low-discrepancy
/// numbers (sobol.h) need. Between voxels and along a linear piece of the curve the extinction is a cubic polynomial of
/// the way, so that its integral is known in closed form; only where in that way the flight ends is found by Newton's
/// method. The same answers the question how much light comes through: a flight that leaves the volume has passed the
/// optical depth of the whole ray.

#include <type_traits>

#include "render/kernel/attenuation.h"
#include "render/kernel/ray.h"
#include "render/kernel/walk/piece_walk.h"

namespace pdr {

/// The optical depth that is passed on the way from 0 to s in [0, 1] of a piece, for extinctions along it that are a
/// cubic: of degree four, by its Bernstein coefficients but the first, which is 0. Rises from 0 to 1: in units of the
/// whole.
template <class Real>
struct DepthPassed {
    Cubic<Real> extinction;  ///< divided by its mean

    PDR_HD_INLINE Real at(Real s) const {
        const Real c1 = 0.25f * extinction.b0, c2 = c1 + 0.25f * extinction.b1, c3 = c2 + 0.25f * extinction.b2;
        const Real c4 = c3 + 0.25f * extinction.b3;
        const Real r = 1.0f - s;
        return s * (r * r * (4.0f * r * c1 + 6.0f * s * c2) + s * s * (4.0f * r * c3 + s * c4));
    }
    PDR_HD_INLINE Real slopeAt(Real s) const { return extinction.at(s); }
};

/// One ray, or several in step. Masked: see PieceWalk.
template <class Real, bool Masked = false>
class FreeFlight {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    Real distance = Real{} - 1.0f;  ///< mm from the ray's origin to where it has passed that depth; -1: it never did
    Real passed{};                  ///< optical depth of the whole ray, where it never did

    /// `depth`: the optical depth to pass; > 0.
    PDR_HD_INLINE void start(const FlatScene& scene, const Vec3<Real>& origin, const Vec3<Real>& direction, Real length,
                             Real depth) {
        walk_.start(scene.majorants, origin, direction, length);
        depth_ = depth;
    }
    /// Of one ray; what has flown here before is forgotten.
    PDR_HD_INLINE void start(const FlatScene& scene, const Ray& ray, float depth) requires std::is_same_v<Real, float> {
        *this = FreeFlight();
        start(scene, {ray.origin.x, ray.origin.y, ray.origin.z}, {ray.direction.x, ray.direction.y, ray.direction.z},
              ray.length, depth);
    }

    PDR_HD Mask going() const { return walk_.going(); }

    PDR_HD_INLINE void step(const FlatScene& scene) {
        Mask ended{};
        walk_.step(scene, [&](const Way& way, Mask ready, Mask) {
            const OpticsAlong<Real> along = opticsAlong(scene.optics, way.piece, way.hu);
            const Real passed = this->passed + meanExtinction(along, way) * way.length;
            ended = ready & (passed > depth_);
            if (any(ended))
                distance = ended ? way.begin + way.length * endOn(along, way, ended) : distance;
            this->passed = ready ? passed : this->passed;
            return ready;
        });
        walk_.stop(ended);
    }

    /// Where `mask` holds: lane l begins the ray of lane from[l] of `other`, which has been started only.
    void take(Mask mask, const FreeFlight& other, Int from) {
        walk_.take(mask, other.walk_, from);
        depth_ = mask ? permuted(other.depth_, from) : depth_;
        distance = mask ? Real{} - 1.0f : distance;
        passed = mask ? Real{} : passed;
    }

  private:
    using Way = typename PieceWalk<Real, Masked>::Way;

    PDR_HD_INLINE static Real meanExtinction(const OpticsAlong<Real>& along, const Way& way) {
        if constexpr (Masked)
            return seenAlong(along, way.weight).meanExtinction;
        else
            return along.meanExtinction;
    }

    PDR_HD_INLINE Real endOn(const OpticsAlong<Real>& along, const Way& way, Mask ended) const {
        if constexpr (Masked)
            return endOnSeen(along, way, ended);
        else
            return endOf(along, way.length, ended);
    }

    /// The same on a way of which some may be hidden.
    PDR_HD_INLINE Real endOnSeen(const OpticsAlong<Real>& along, const Way& way, Mask ended) const {
        const SeenAlong<Real> seen = seenAlong(along, way.weight);
        const Mask partly = ended & seen.partly;
        Real end = endOf(along, way.length, ended & !seen.partly);
        if (any(partly)) {
            const SeenDepthPassed<Real> depth{along, way.weight, 1.0f / seen.meanExtinction};
            const Real wanted = (depth_ - passed) * depth.scale / way.length;
            const Real found = whereMonotoneIs(depth, wanted, Real{}, Real{} + 1.0f, partly);
            end = partly ? found : end;
        }
        return end;
    }

    /// The fraction of a way of that length after which the depth has been passed; it is before its end.
    PDR_HD_INLINE Real endOf(const OpticsAlong<Real>& along, Real length, Mask ended) const {
        const Real scale = 1.0f / along.meanExtinction;
        const auto relative = [&](Real fraction) {
            return max(along.extinction + along.extinctionRise * fraction, Real{}) * scale;
        };
        const DepthPassed<Real> depth{{relative(along.fraction.b0), relative(along.fraction.b1),
                                       relative(along.fraction.b2), relative(along.fraction.b3)}};
        const Real wanted = (depth_ - passed) * scale / length;
        return whereMonotoneIs(depth, wanted, Real{}, Real{} + 1.0f, ended);
    }

    PieceWalk<Real, Masked> walk_;
    Real depth_{};
};

/// What becomes of one ray.
struct Flight {
    float distance;  ///< as in FreeFlight
    float passed;
};

template <bool Masked>
PDR_HD inline Flight freeFlightOf(const FlatScene& scene, const Ray& ray, float depth) {
    FreeFlight<float, Masked> flight;
    flight.start(scene, ray, depth);
    while (flight.going())
        flight.step(scene);
    return {flight.distance, flight.passed};
}

PDR_HD inline Flight freeFlight(const FlatScene& scene, const Ray& ray, float depth) {
    return isMasked(scene) ? freeFlightOf<true>(scene, ray, depth) : freeFlightOf<false>(scene, ray, depth);
}

}  // namespace pdr
