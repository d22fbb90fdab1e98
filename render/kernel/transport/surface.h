#pragma once
/// Reflection at a surface in the volume: Lambert under a GGX microfacet layer with Schlick's Fresnel term. Directions
/// are unit vectors away from the surface, in local space; n is on the side of wo. The three functions are those of the
/// phase function: eval returns f * cos(theta_light) [1/sr], pdf is per solid angle, sample draws a direction. Walter
/// et al. 2007 (GGX), Heitz 2014 (height-correlated masking), Schlick 1994.

#include "render/kernel/flat_scene.h"
#include "render/kernel/transport/phase.h"

namespace pdr {

template <class Real>
PDR_HD inline Vec3<Real> fresnel(const Vec3<Real>& specular, Real cosine) {
    const Real m = 1.0f - min(Real{} + 1.0f, max(Real{}, cosine));
    const Real m2 = m * m;
    return specular + (1.0f - specular) * (m2 * m2 * m);
}

/// Returns the GGX width of a roughness, never so narrow that the peak exceeds the range of float.
template <class Real>
PDR_HD inline Real ggxAlpha(Real roughness) {
    return max(Real{} + 1e-3f, roughness * roughness);
}

template <class Real>
PDR_HD inline Real ggxDensity(Real alpha, Real cosHalf) {
    const Real a2 = alpha * alpha;
    const Real d = (1.0f - cosHalf * cosHalf) + a2 * cosHalf * cosHalf;
    return a2 / (kPi * d * d);
}

/// Returns the masking-shadowing term divided by 4 cosView cosLight.
template <class Real>
PDR_HD inline Real ggxVisibility(Real alpha, Real cosView, Real cosLight) {
    const Real a2 = alpha * alpha;
    const Real view = cosLight * squareRoot(a2 + (1.0f - a2) * cosView * cosView);
    const Real light = cosView * squareRoot(a2 + (1.0f - a2) * cosLight * cosLight);
    return 0.5f / (view + light);
}

template <class Real>
PDR_HD inline auto isShiny(const MaterialOf<Real>& material) {
    return material.specular.x + material.specular.y + material.specular.z > 0.0f;
}

template <class Real>
PDR_HD inline Vec3<Real> surfaceEval(const MaterialOf<Real>& material, const Vec3<Real>& n, const Vec3<Real>& wo,
                                     const Vec3<Real>& wi) {
    using Mask = typename SimdTraits<Real>::Mask;
    const Real cosView = dot(n, wo), cosLight = dot(n, wi);
    const Mask lit = !((cosView <= 0.0f) | (cosLight <= 0.0f));
    if (!any(lit))
        return Vec3<Real>{};
    const Vec3<Real> matt = chosen(lit, material.albedo * (cosLight / kPi), Vec3<Real>{});
    const Mask shiny = lit & isShiny(material);
    if (!any(shiny))
        return matt;
    const Vec3<Real> half = normalize(wo + wi);
    const Real alpha = ggxAlpha(material.roughness);
    const Vec3<Real> gloss = fresnel(material.specular, dot(wo, half)) * ggxDensity(alpha, dot(n, half)) *
                             ggxVisibility(alpha, cosView, cosLight);
    const Vec3<Real> below =
        (1.0f - fresnel(material.specular, cosView)) * (1.0f - fresnel(material.specular, cosLight));
    return chosen(shiny, (material.albedo * below / kPi + gloss) * cosLight, matt);
}

/// Returns the probability that the gloss is sampled instead of the diffuse layer below, in proportion to what each
/// reflects. No sample then weighs much more than the surface reflects, however often light bounces.
template <class Real>
PDR_HD inline Real glossProbability(const MaterialOf<Real>& material, Real cosView) {
    const Vec3<Real> gloss = fresnel(material.specular, cosView);
    const Vec3<Real> below = material.albedo * (1.0f - gloss);
    const Real most = max(gloss.z, max(gloss.y, gloss.x));
    return most / (most + max(below.z, max(below.y, below.x)));
}

template <class Real>
PDR_HD inline Real surfacePdf(const MaterialOf<Real>& material, const Vec3<Real>& n, const Vec3<Real>& wo,
                              const Vec3<Real>& wi) {
    using Mask = typename SimdTraits<Real>::Mask;
    const Real cosLight = dot(n, wi);
    const Mask lit = !(cosLight <= 0.0f);
    if (!any(lit))
        return Real{};
    const Real diffuse = lit ? cosLight / kPi : Real{};
    const Mask shiny = lit & isShiny(material);
    if (!any(shiny))
        return diffuse;
    const Vec3<Real> half = normalize(wo + wi);
    const Real cosHalf = dot(n, half);
    const Real gloss =
        ggxDensity(ggxAlpha(material.roughness), cosHalf) * cosHalf / (4.0f * max(Real{} + 1e-6f, dot(wo, half)));
    const Real share = glossProbability(material, dot(n, wo));
    return shiny ? diffuse * (1.0f - share) + gloss * share : diffuse;
}

/// Samples a direction that light may come from, distributed as surfacePdf; `choice` and `u` are independent numbers.
template <class Real>
PDR_HD inline Vec3<Real> surfaceSample(const MaterialOf<Real>& material, const Vec3<Real>& n, const Vec3<Real>& wo,
                                       Real choice, const Vec2<Real>& u) {
    using Mask = typename SimdTraits<Real>::Mask;
    Vec3<Real> s, t;
    orthonormalBasis(n, s, t);
    const Vec3<Real> around = circlePoint(s, t, u.y);
    const Vec3<Real> diffuse = around * squareRoot(u.x) + n * squareRoot(1.0f - u.x);
    Mask gloss = isShiny(material);
    if (any(gloss))
        gloss = gloss & !(choice >= glossProbability(material, dot(n, wo)));
    if (!any(gloss))
        return diffuse;
    const Real alpha = ggxAlpha(material.roughness);
    const Real cosSquared = (1.0f - u.x) / (1.0f + (alpha * alpha - 1.0f) * u.x);
    const Vec3<Real> half = around * squareRoot(max(Real{}, 1.0f - cosSquared)) + n * squareRoot(cosSquared);
    return chosen(gloss, half * (2.0f * dot(wo, half)) - wo, diffuse);
}

}  // namespace pdr
