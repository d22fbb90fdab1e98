#pragma once
/// The optics of tissue, once more and in double precision, from the formulas as they are written: nothing here is
/// shared with render/kernel. Directions are unit vectors.
///   Henyey & Greenstein 1941; Schlick 1994; GGX after Walter et al. 2007, with Smith's height-correlated masking as
///   Heitz 2014 writes it, by the auxiliary function Lambda; surface probability after Kroes, Post & Botha 2012

#include <cmath>
#include <vector>

#include "render/scene/transfer_function.h"

namespace pdr::test::written {

struct Tissue {
    double opacity;
    dvec3 albedo, specular;
    double roughness;
};

inline Tissue tissueOf(const TransferNode& node) {
    return {node.opacity, dvec3(node.albedo), dvec3(node.specular), node.roughness};
}

/// Linear from node to node; of two nodes at one HU the later one holds from there on.
inline Tissue tissueAt(const std::vector<TransferNode>& nodes, double hu) {
    std::size_t next = 0;
    while (next < nodes.size() && nodes[next].hu <= hu)
        ++next;
    if (next == 0 || next == nodes.size())
        return tissueOf(next == 0 ? nodes.front() : nodes.back());
    const Tissue a = tissueOf(nodes[next - 1]), b = tissueOf(nodes[next]);
    const double s = (hu - nodes[next - 1].hu) / (double(nodes[next].hu) - nodes[next - 1].hu);
    return {(1 - s) * a.opacity + s * b.opacity, (1 - s) * a.albedo + s * b.albedo,
            (1 - s) * a.specular + s * b.specular, (1 - s) * a.roughness + s * b.roughness};
}

/// [1/sr]
inline double henyeyGreenstein(double g, double cosine) {
    return (1 - g * g) / (4 * M_PI * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}

inline dvec3 schlick(dvec3 normalReflectance, double cosine) {
    return normalReflectance + (dvec3(1) - normalReflectance) * std::pow(1 - cosine, 5.0);
}

/// A GGX layer of width alpha = roughness^2, but no narrower than 1e-3.
struct Ggx {
    double alpha;

    explicit Ggx(double roughness) : alpha(std::max(roughness * roughness, 1e-3)) {}
    double distribution(double cosine) const {
        const double tangentSquared = 1 / (cosine * cosine) - 1, c4 = std::pow(cosine, 4.0);
        return alpha * alpha / (M_PI * c4 * std::pow(alpha * alpha + tangentSquared, 2.0));
    }
    double lambda(double cosine) const { return (std::sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1) / 2; }
    double masking(double cosView, double cosLight) const { return 1 / (1 + lambda(cosView) + lambda(cosLight)); }
};

/// BRDF times the cosine of the light [1/sr]: Lambert, seen and lit through the gloss; bare where nothing is specular.
inline dvec3 surface(const Tissue& tissue, dvec3 normal, dvec3 toViewer, dvec3 toLight) {
    const double view = glm::dot(normal, toViewer), light = glm::dot(normal, toLight);
    if (view <= 0 || light <= 0)
        return dvec3(0);
    if (tissue.specular == dvec3(0))
        return tissue.albedo / M_PI * light;
    const dvec3 half = glm::normalize(toViewer + toLight);
    const Ggx ggx(tissue.roughness);
    const dvec3 gloss = schlick(tissue.specular, glm::dot(half, toLight)) *
                        (ggx.distribution(glm::dot(half, normal)) * ggx.masking(view, light) / (4 * view * light));
    const dvec3 enters = dvec3(1) - schlick(tissue.specular, light), leaves = dvec3(1) - schlick(tissue.specular, view);
    return (tissue.albedo / M_PI * enters * leaves + gloss) * light;
}

/// Probability that an event is a reflection; `steepness`: length of the gradient [HU/mm].
inline double surfaceProbability(double opacity, double gradientFactor, double steepness) {
    return opacity * (1 - std::exp(-25 * std::pow(gradientFactor, 3.0) * steepness / 4096));
}

}  // namespace pdr::test::written
