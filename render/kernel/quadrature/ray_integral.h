#pragma once
/// The optical models without scattering: absorption, emission, and both together, as sums along one straight ray.
///   L = B exp(-int sigma)      L = int sigma c ds + B      L = int sigma c T ds + T B,  T = exp(-int sigma)
/// with sigma the extinction, c the source (albedo + emission: each tissue shines as if white light of radiance 1
/// reached it from all sides unshadowed) and B what lies behind.
///
/// A step goes through one cell between voxels and one linear piece of the curve, whose borders are met exactly; there
/// is no step length. In it sigma and c are cubic polynomials of the way, so the optical depth and int sigma c ds are
/// exact. Only how a step is seen through itself is approximated, within a bound (layer.h). Steps whose bounds add up
/// to more than the tolerance are halved. Rounding is not part of the bound.

#include "render/kernel/quadrature/cell_walk.h"
#include "render/kernel/quadrature/layer.h"

namespace pdr {

/// What a walk along a ray has found.
template <class Real>
struct RayResult {
    Real value[3]{};            ///< radiance gathered on the way, linear Rec. 709; maximumIntensity: highest HU first
    Real left = Real{} + 1.0f;  ///< fraction of what lies behind that reaches the camera
    Real exceeded{};            ///< 1: a step could not be made short enough for the tolerance
};

template <class Real, FlatModel Model>
class RayIntegral {
  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    PDR_HD_INLINE void start(const FlatScene& scene, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real length) {
        walk_.start(scene.majorants, origin, direction, length);
    }

    PDR_HD Mask going() const { return walk_.walking() | (way_.length > 0.0f); }

    PDR_HD RayResult<Real> result() const {
        RayResult<Real> result = sum_;
        if constexpr (Model == FlatModel::absorption)
            result.left = attenuation(depth_).left;
        return result;
    }

    /// One step: lanes that look for tissue move, or those that are in it go on, whichever are more.
    PDR_HD_INLINE void step(const FlatScene& scene) {
        const Mask inCell = way_.length > 0.0f;
        const Mask seeking = walk_.walking() & !inCell;
        if (count(seeking) >= count(inCell))
            seek(scene, seeking);
        else
            goOn(scene, inCell);
    }

    /// Where `mask` holds: lane l begins the ray of lane from[l] of `other`, which has been started only.
    void take(Mask mask, const RayIntegral& other, Int from) {
        const auto fresh = [mask](Real& mine, Real first) { mine = mask ? first : mine; };
        walk_.take(mask, other.walk_, from);
        fresh(way_.length, Real{});
        fresh(reach_, Real{} + 1.0f);
        fresh(sum_.exceeded, Real{});
        fresh(depth_, Real{});
        fresh(sum_.left, Real{} + 1.0f);
        for (int channel = 0; channel < 3; ++channel) {
            fresh(sum_.value[channel], Real{});
            fresh(bound_[channel], Real{});
        }
    }

  private:
    static constexpr float kShortest = 0x1p-24f;  ///< fraction of a cell's way below which a step is not halved

    PDR_HD_INLINE void seek(const FlatScene& scene, Mask seeking) {
        const Mask met = walk_.step(scene, seeking, Real{}, way_);
        const Mask clear = (way_.hu.highest() < scene.optics.clearUpTo) | (way_.hu.lowest() >= scene.optics.clearFrom);
        way_.length = (met & clear) ? Real{} : way_.length;
    }

    /// The next step of the way through the cell where the ray is.
    PDR_HD_INLINE void goOn(const FlatScene& scene, Mask inCell) {
        const FlatOptics& optics = scene.optics;
        Cubic<Real> before, behind;
        way_.hu.split(reach_, before, behind);
        const OpticsPiece<Real> piece = pieceAtBegin(scene, before);
        const Mask fits =
            (before.lowest() >= piece.start - optics.rounding) & (before.highest() <= piece.end + optics.rounding);
        const Mask crosses = inCell & !fits & before.monotone();
        Real reach = reach_;
        if (any(crosses)) {
            const Real border = before.b3 < before.b0 ? piece.start : piece.end;
            const Real fraction = reach_ * before.whereIs(border, crosses);
            reach = crosses ? fraction : reach_;
            way_.hu.split(reach, before, behind);
            before.b3 = crosses ? border : before.b3;
            behind.b0 = crosses ? border : behind.b0;
        }
        // Where a step had to be that short, the tolerance cannot be kept: from there on all steps are taken.
        sum_.exceeded = (inCell & (reach_ <= kShortest)) ? Real{} + 1.0f : sum_.exceeded;
        const Mask forced = sum_.exceeded > 0.0f;
        const Mask ready = inCell & (fits | crosses | forced);
        const Real length = way_.length * reach;
        const Mask gone = ready & add(optics, piece, before, length, ready, forced);
        reach_ = inCell ? (gone ? Real{} + 1.0f : 0.5f * reach) : reach_;
        reach_ = max(reach_, Real{} + kShortest);
        const Mask split = gone & (reach < 1.0f);
        way_.hu.b0 = split ? behind.b0 : way_.hu.b0;
        way_.hu.b1 = split ? behind.b1 : way_.hu.b1;
        way_.hu.b2 = split ? behind.b2 : way_.hu.b2;
        way_.hu.b3 = split ? behind.b3 : way_.hu.b3;
        way_.length = gone ? way_.length - length : way_.length;
        if constexpr (Model == FlatModel::absorption)
            stop(gone & (depth_ > kOpaqueDepth));
        if constexpr (Model == FlatModel::emissionAbsorption)
            stop(gone & nothingMoreToSee(scene));
    }

    PDR_HD_INLINE void stop(Mask mask) {
        walk_.stop(mask);
        way_.length = mask ? Real{} : way_.length;
    }

    /// Adds a way through one piece where `ready` holds. Result: where it was added; elsewhere it must be halved.
    PDR_HD_INLINE Mask add(const FlatOptics& optics, const OpticsPiece<Real>& piece, const Cubic<Real>& hu, Real length,
                           Mask ready, Mask forced) {
        const OpticsAlong<Real> along = opticsAlong(optics, piece, hu);
        const Real depth = along.meanExtinction * length;
        if constexpr (Model == FlatModel::absorption) {
            depth_ = ready ? depth_ + depth : depth_;
            return ready;
        } else if constexpr (Model == FlatModel::emission) {
            const Real fraction = extinctionWeightedFraction(along);
            for (int channel = 0; channel < 3; ++channel) {
                const Source source = sourceOf(optics, piece, channel);
                const Real more = sum_.value[channel] + depth * (source.begin + source.rise * fraction);
                sum_.value[channel] = ready ? more : sum_.value[channel];
            }
            return ready;
        } else {
            return addAttenuated(optics, piece, along, depth, ready, forced);
        }
    }

    struct Source {
        Real begin, rise;  ///< over the piece
    };
    PDR_HD_INLINE static Source sourceOf(const FlatOptics& optics, const OpticsPiece<Real>& piece, int channel) {
        return {opticsColumn<Real>(optics, int(OpticsColumn::source) + channel, piece.index),
                opticsColumn<Real>(optics, int(OpticsColumn::sourceRise) + channel, piece.index)};
    }

    PDR_HD_INLINE Mask addAttenuated(const FlatOptics& optics, const OpticsPiece<Real>& piece,
                                     const OpticsAlong<Real>& along, Real depth, Mask ready, Mask forced) {
        const Layer<Real> layer = layerAlong(along, depth);
        const Real taken = sum_.left * layer.behind.taken;
        Real radiance[3], bound[3];
        Mask close = ready;
        for (int channel = 0; channel < 3; ++channel) {
            const Source source = sourceOf(optics, piece, channel);
            radiance[channel] = sum_.value[channel] + taken * (source.begin + source.rise * layer.fraction);
            bound[channel] = bound_[channel] + abs(source.rise) * taken * layer.bound;
            close = close & (bound[channel] <= optics.quadrature * radiance[channel]);
        }
        const Mask added = ready & (close | forced);
        for (int channel = 0; channel < 3; ++channel) {
            sum_.value[channel] = added ? radiance[channel] : sum_.value[channel];
            bound_[channel] = added ? bound[channel] : bound_[channel];
        }
        sum_.left = added ? sum_.left * layer.behind.left : sum_.left;
        return added;
    }

    /// Whatever follows can add no more than the fraction that may be left out.
    PDR_HD_INLINE Mask nothingMoreToSee(const FlatScene& scene) const {
        const FlatOptics& optics = scene.optics;
        Mask dark = sum_.left * optics.brightest.x <= optics.cutOff * sum_.value[0];
        dark = dark & (sum_.left * optics.brightest.y <= optics.cutOff * sum_.value[1]);
        return dark & (sum_.left * optics.brightest.z <= optics.cutOff * sum_.value[2]);
    }

    CellWalk<Real> walk_;
    HuAlong<Real> way_{};         ///< what is left of the way through the cell where the ray is
    Real reach_ = Real{} + 1.0f;  ///< fraction of it that is tried next
    RayResult<Real> sum_;
    Real bound_[3]{};  ///< on the error of what was gathered
    Real depth_{};     ///< optical depth (absorption)
};

}  // namespace pdr
