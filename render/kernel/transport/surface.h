#pragma once
/// Reflection at a surface in the volume: Lambert under a GGX microfacet layer with Schlick's Fresnel term. Directions
/// are unit vectors away from the surface, in local space; n is on the side of wo. The three functions are those of the
/// phase function: eval returns f * cos(theta_light) [1/sr], pdf is per solid angle, sample draws a direction. Walter
/// et al. 2007 (GGX), Heitz 2014 (height-correlated masking), Schlick 1994.

#include "render/kernel/flat_scene.h"
#include "render/kernel/transport/phase.h"

namespace pdr {

PDR_HD inline vec3 fresnel(vec3 specular, float cosine) {
    const float m = 1 - glm::clamp(cosine, 0.0f, 1.0f);
    const float m2 = m * m;
    return specular + (1.0f - specular) * (m2 * m2 * m);
}

/// Returns the GGX width of a roughness, never so narrow that the peak exceeds the range of float.
PDR_HD inline float ggxAlpha(float roughness) {
    return glm::max(roughness * roughness, 1e-3f);
}

PDR_HD inline float ggxDensity(float alpha, float cosHalf) {
    const float a2 = alpha * alpha;
    const float d = (1 - cosHalf * cosHalf) + a2 * cosHalf * cosHalf;
    return a2 / (kPi * d * d);
}

/// Returns the masking-shadowing term divided by 4 cosView cosLight.
PDR_HD inline float ggxVisibility(float alpha, float cosView, float cosLight) {
    const float a2 = alpha * alpha;
    const float view = cosLight * std::sqrt(a2 + (1 - a2) * cosView * cosView);
    const float light = cosView * std::sqrt(a2 + (1 - a2) * cosLight * cosLight);
    return 0.5f / (view + light);
}

PDR_HD inline bool isShiny(const Material& material) {
    return material.specular.x + material.specular.y + material.specular.z > 0;
}

PDR_HD inline vec3 surfaceEval(const Material& material, vec3 n, vec3 wo, vec3 wi) {
    const float cosView = glm::dot(n, wo), cosLight = glm::dot(n, wi);
    if (cosView <= 0 || cosLight <= 0)
        return vec3(0);
    if (!isShiny(material))
        return material.albedo * (cosLight / kPi);
    const vec3 half = glm::normalize(wo + wi);
    const float alpha = ggxAlpha(material.roughness);
    const vec3 gloss = fresnel(material.specular, glm::dot(wo, half)) * ggxDensity(alpha, glm::dot(n, half)) *
                       ggxVisibility(alpha, cosView, cosLight);
    const vec3 below = (1.0f - fresnel(material.specular, cosView)) * (1.0f - fresnel(material.specular, cosLight));
    return (material.albedo * below / kPi + gloss) * cosLight;
}

/// Returns the probability that the gloss is sampled instead of the diffuse layer below, in proportion to what each
/// reflects. No sample then weighs much more than the surface reflects, however often light bounces.
PDR_HD inline float glossProbability(const Material& material, float cosView) {
    const vec3 gloss = fresnel(material.specular, cosView);
    const vec3 below = material.albedo * (1.0f - gloss);
    const float most = glm::max(glm::max(gloss.x, gloss.y), gloss.z);
    return most / (most + glm::max(glm::max(below.x, below.y), below.z));
}

PDR_HD inline float surfacePdf(const Material& material, vec3 n, vec3 wo, vec3 wi) {
    const float cosLight = glm::dot(n, wi);
    if (cosLight <= 0)
        return 0;
    const float diffuse = cosLight / kPi;
    if (!isShiny(material))
        return diffuse;
    const vec3 half = glm::normalize(wo + wi);
    const float cosHalf = glm::dot(n, half);
    const float gloss =
        ggxDensity(ggxAlpha(material.roughness), cosHalf) * cosHalf / (4 * glm::max(glm::dot(wo, half), 1e-6f));
    return glm::mix(diffuse, gloss, glossProbability(material, glm::dot(n, wo)));
}

/// Samples a direction that light may come from, distributed as surfacePdf; `choice` and `u` are independent numbers.
PDR_HD inline vec3 surfaceSample(const Material& material, vec3 n, vec3 wo, float choice, vec2 u) {
    vec3 s, t;
    orthonormalBasis(n, s, t);
    const vec3 around = circlePoint(s, t, u.y);
    if (!isShiny(material) || choice >= glossProbability(material, glm::dot(n, wo)))
        return around * std::sqrt(u.x) + n * std::sqrt(1 - u.x);
    const float alpha = ggxAlpha(material.roughness);
    const float cosSquared = (1 - u.x) / (1 + (alpha * alpha - 1) * u.x);
    const vec3 half = around * std::sqrt(glm::max(1 - cosSquared, 0.0f)) + n * std::sqrt(cosSquared);
    return half * (2 * glm::dot(wo, half)) - wo;
}

}  // namespace pdr
