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
            gone = add(scene, way, ready, forced);
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
    PDR_HD_INLINE Mask add(const FlatScene& scene, const Way& way, Mask ready, Mask forced) {
        const OpticsAlong<Real> along = opticsAlong(scene.optics, way.piece, way.hu);
        const Real meanExtinction = meanExtinctionOn(along, way);
        const Real depth = meanExtinction * way.length;
        if constexpr (Model == FlatModel::absorption) {
            depth_ = ready ? depth_ + depth : depth_;
            return ready;
        } else {
            const Layer<Real> layer = layerOn(along, way, depth);
            const Real taken = Model == FlatModel::emission ? depth : sum_.left * layer.behind.taken;
            Light light[3];
            Mask close = ready;
            for (int channel = 0; channel < 3; ++channel) {
                light[channel] = ofPiece(scene.optics, way.piece, layer, channel, taken);
                light[channel].radiance = sum_.value[channel] + light[channel].radiance;
                light[channel].bound = bound_[channel] + light[channel].bound;
                close = close & (light[channel].bound <= scene.optics.quadrature * light[channel].radiance);
            }
            const Mask added = ready & (close | forced);
            for (int channel = 0; channel < 3; ++channel) {
                sum_.value[channel] = added ? light[channel].radiance : sum_.value[channel];
                bound_[channel] = added ? light[channel].bound : bound_[channel];
            }
            if constexpr (Model == FlatModel::emissionAbsorption)
                sum_.left = added ? sum_.left * layer.behind.left : sum_.left;
            return added;
        }
    }

    /// Returns the mean of the visible extinction along a segment [1/mm].
    PDR_HD_INLINE static Real meanExtinctionOn(const OpticsAlong<Real>& along, const Way& way) {
        if constexpr (Kind == Tissue::parted)
            return PartedExtinction<Real>{along, way.hu, way.weight, way.masked, way.mixed}.mean();
        else if constexpr (Kind == Tissue::masked)
            return seenAlong(along, way.weight).meanExtinction;
        else
            return along.meanExtinction;
    }

    PDR_HD_INLINE static SourceAlong<Real> sourceOn(const OpticsAlong<Real>& along, const Way& way) {
        if constexpr (Kind == Tissue::masked)
            return sourceAlong(along, way.weight);
        else
            return sourceAlong(along);
    }

    /// Returns a segment as a layer: in the model of emission, one that nothing attenuates.
    PDR_HD_INLINE static Layer<Real> layerOn(const OpticsAlong<Real>& along, const Way& way, Real depth) {
        const SourceAlong<Real> source = sourceOn(along, way);
        if constexpr (Model == FlatModel::emission)
            return Layer<Real>{Attenuation<Real>{}, source.fraction, Real{}};
        else
            return layerAlong(along, depth, source);
    }

    /// Light in one channel, and the bound on its error.
    struct Light {
        Real radiance, bound;
    };

    /// Returns the light of a segment in one piece. `taken`: share of white light from behind that it would absorb and
    /// that reaches the camera; its depth where nothing attenuates.
    PDR_HD_INLINE static Light ofPiece(const FlatOptics& optics, const OpticsPiece<Real>& piece,
                                       const Layer<Real>& layer, int channel, Real taken) {
        const Real begin = opticsColumn<Real>(optics, int(OpticsColumn::source) + channel, piece.index);
        const Real rise = opticsColumn<Real>(optics, int(OpticsColumn::sourceRise) + channel, piece.index);
        return {taken * (begin + rise * layer.fraction), abs(rise) * taken * layer.bound};
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
