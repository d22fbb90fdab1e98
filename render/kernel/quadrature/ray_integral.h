#pragma once
/// The optical models without scattering: absorption, emission, and both together, as sums along one straight ray.
///   L = B exp(-int sigma)      L = int sigma c ds + B      L = int sigma c T ds + T B,  T = exp(-int sigma)
/// with sigma the extinction, c the source (albedo + emission: each tissue shines as if unshadowed white light of
/// radiance 1 reached it from all sides) and B the radiance behind the volume.
///
/// A step goes through one cell between voxels and one linear piece of the curve (piece_walk.h). In it sigma and c are
/// cubic polynomials of the distance, so the optical depth and int sigma c ds are exact. Only the attenuation of a
/// step's light within the step is approximated, within a bound (layer.h). Steps whose bounds add up to more than the
/// tolerance are halved. Rounding is not part of the bound.

#include "render/kernel/quadrature/layer.h"
#include "render/kernel/walk/piece_walk.h"

namespace pdr {

/// The result of a walk along a ray.
template <class Real>
struct RayResult {
    /// Radiance accumulated along the ray, linear Rec. 709; maximumIntensity: value[0] is the highest HU.
    Real value[3]{};
    Real left = Real{} + 1.0f;  ///< fraction of the background's radiance that reaches the camera
    Real exceeded{};            ///< 1: a step could not be made short enough for the tolerance
};

/// Accumulates the sum along one ray, or along several in lanes. Kind: the scene's tissue; parts only for absorption.
template <class Real, FlatModel Model, Tissue Kind>
class RayIntegral {
    static_assert(Kind != Tissue::parted || Model == FlatModel::absorption);

  public:
    using Int = typename SimdTraits<Real>::Int;
    using Mask = typename SimdTraits<Real>::Mask;

    PDR_HD_INLINE void start(const FlatScene& scene, const Vec3<Real>& origin, const Vec3<Real>& direction,
                             Real length) {
        walk_.start(scene.majorants, origin, direction, length);
    }

    PDR_HD Mask going() const { return walk_.going(); }

    PDR_HD RayResult<Real> result() const {
        RayResult<Real> result = sum_;
        result.exceeded = walk_.exceeded() ? Real{} + 1.0f : Real{};
        if constexpr (Model == FlatModel::absorption)
            result.left = attenuation(depth_).left;
        return result;
    }

    PDR_HD_INLINE void step(const FlatScene& scene) {
        Mask gone{};
        walk_.step(scene, [&](const Way& way, Mask ready, Mask forced) {
            gone = add(scene.optics, way, ready, forced);
            return gone;
        });
        if constexpr (Model == FlatModel::absorption)
            walk_.stop(gone & (depth_ > kOpaqueDepth));
        if constexpr (Model == FlatModel::emissionAbsorption)
            walk_.stop(gone & nothingMoreToSee(scene));
    }

    /// Starts lane l, where `mask` holds, on the ray of lane from[l] of `other`, which has been started but not
    /// stepped.
    void take(Mask mask, const RayIntegral& other, Int from) {
        const auto fresh = [mask](Real& mine, Real first) { mine = mask ? first : mine; };
        walk_.take(mask, other.walk_, from);
        fresh(depth_, Real{});
        fresh(sum_.left, Real{} + 1.0f);
        for (int channel = 0; channel < 3; ++channel) {
            fresh(sum_.value[channel], Real{});
            fresh(bound_[channel], Real{});
        }
    }

  private:
    using Walk = PieceWalk<Real, Kind>;
    using Way = typename Walk::Way;

    /// Adds a segment through one piece where `ready` holds. Returns the lanes in which it was added; in the others it
    /// must be halved.
    PDR_HD_INLINE Mask add(const FlatOptics& optics, const Way& way, Mask ready, Mask forced) {
        const OpticsPiece<Real>& piece = way.piece;
        const OpticsAlong<Real> along = opticsAlong(optics, piece, way.hu);
        const Real depth = meanExtinctionOn<Kind>(along, way) * way.length;
        if constexpr (Model == FlatModel::absorption) {
            depth_ = ready ? depth_ + depth : depth_;
            return ready;
        } else if constexpr (Model == FlatModel::emission) {
            const Real fraction = sourceOn(along, way).fraction;
            for (int channel = 0; channel < 3; ++channel) {
                const Source source = sourceOf(optics, piece, channel);
                const Real more = sum_.value[channel] + depth * (source.begin + source.rise * fraction);
                sum_.value[channel] = ready ? more : sum_.value[channel];
            }
            return ready;
        } else {
            return addAttenuated(optics, piece, layerAlong(along, depth, sourceOn(along, way)), ready, forced);
        }
    }

    struct Source {
        Real begin, rise;  ///< radiance per optical depth: at the start of the piece, and its change over the piece
    };
    PDR_HD_INLINE static Source sourceOf(const FlatOptics& optics, const OpticsPiece<Real>& piece, int channel) {
        return {opticsColumn<Real>(optics, int(OpticsColumn::source) + channel, piece.index),
                opticsColumn<Real>(optics, int(OpticsColumn::sourceRise) + channel, piece.index)};
    }

    PDR_HD_INLINE static SourceAlong<Real> sourceOn(const OpticsAlong<Real>& along, const Way& way) {
        if constexpr (Kind == Tissue::masked)
            return sourceAlong(along, way.weight);
        else
            return sourceAlong(along);
    }

    /// Adds a layer behind the accumulated ones, in the lanes of `ready` where the error bound stays within the
    /// tolerance or `forced` holds. Returns these lanes.
    PDR_HD_INLINE Mask addAttenuated(const FlatOptics& optics, const OpticsPiece<Real>& piece, const Layer<Real>& layer,
                                     Mask ready, Mask forced) {
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

    /// Returns the lanes in which the rest of the ray can add no more than FlatOptics::cutOff.
    PDR_HD_INLINE Mask nothingMoreToSee(const FlatScene& scene) const {
        const FlatOptics& optics = scene.optics;
        Mask dark = sum_.left * optics.brightest.x <= optics.cutOff * sum_.value[0];
        dark = dark & (sum_.left * optics.brightest.y <= optics.cutOff * sum_.value[1]);
        return dark & (sum_.left * optics.brightest.z <= optics.cutOff * sum_.value[2]);
    }

    Walk walk_;
    RayResult<Real> sum_;
    Real bound_[3]{};  ///< bounds on the errors of sum_.value
    Real depth_{};     ///< optical depth (absorption)
};

}  // namespace pdr
