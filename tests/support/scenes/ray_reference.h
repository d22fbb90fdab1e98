#pragma once
/// Reference for the models without scattering, by brute force in double precision, with which tests compare the
/// quadrature. It shares nothing with the quadrature but the scene.

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "render/kernel/ray.h"
#include "render/scene/scene.h"

namespace pdr::test {

/// Returns the HU at `position` (index space), trilinear, borders clamped.
inline double huAt(const Volume& volume, dvec3 position) {
    const ivec3 size = volume.size();
    const dvec3 p = glm::clamp(position, dvec3(0), dvec3(size - 1));
    const ivec3 low = glm::min(ivec3(p), glm::max(size - 2, ivec3(0)));
    double sum = 0;
    for (int n = 0; n < 8; ++n) {
        const ivec3 corner = glm::min(low + ivec3(n & 1, (n >> 1) & 1, n >> 2), size - 1);
        const dvec3 fraction = p - dvec3(low);
        const double weight = (n & 1 ? fraction.x : 1 - fraction.x) * (n & 2 ? fraction.y : 1 - fraction.y) *
                              (n & 4 ? fraction.z : 1 - fraction.z);
        sum += weight * volume.voxels()[(std::size_t(corner.z) * size.y + corner.y) * size.x + corner.x];
    }
    return sum;
}

/// Integrals along a ray.
struct RayTruth {
    double depth = 0;   ///< int sigma ds
    dvec3 emitted{0};   ///< int sigma c ds
    dvec3 absorbed{0};  ///< int sigma c T ds
};

/// Extinction and source at one HU, in double precision; right-continuous where several nodes have the same HU.
struct Optics {
    double extinction;
    dvec3 source;
};
inline Optics opticsAt(const TransferFunction& function, double hu) {
    const auto& nodes = function.nodes;
    const auto of = [&](const TransferNode& a, const TransferNode& b, double fraction) {
        return Optics{function.extinctionPerMm * (a.opacity + fraction * (double(b.opacity) - a.opacity)),
                      glm::mix(dvec3(a.albedo) + dvec3(a.emission), dvec3(b.albedo) + dvec3(b.emission), fraction)};
    };
    std::size_t after = 0;
    while (after < nodes.size() && nodes[after].hu <= hu)
        ++after;
    if (after == 0 || after == nodes.size()) {
        const TransferNode& outermost = after == 0 ? nodes.front() : nodes.back();
        return of(outermost, outermost, 0);
    }
    const TransferNode &a = nodes[after - 1], &b = nodes[after];
    return of(a, b, (hu - a.hu) / (double(b.hu) - a.hu));
}

/// Returns extinction and source at `position` (index space): those of the eight voxels' curves by their weights, and
/// no more of it than the mask shows.
inline Optics opticsIn(const Scene& scene, dvec3 position) {
    const double hu = huAt(*scene.volume, position);
    if (!scene.parts.map && !scene.mask)
        return opticsAt(scene.transferFunction, hu);
    const ivec3 size = scene.volume->size();
    const dvec3 p = glm::clamp(position, dvec3(0), dvec3(size - 1));
    const ivec3 low = glm::min(ivec3(p), glm::max(size - 2, ivec3(0)));
    Optics mixed{0, dvec3(0)};
    for (int n = 0; n < 8; ++n) {
        const ivec3 voxel = glm::min(low + ivec3(n & 1, (n >> 1) & 1, n >> 2), size - 1);
        const dvec3 share = glm::abs(dvec3(~n & 1, ~(n >> 1) & 1, ~(n >> 2) & 1) - (p - dvec3(low)));
        const std::size_t at = (std::size_t(voxel.z) * size.y + voxel.y) * size.x + std::size_t(voxel.x);
        const int label = scene.parts.map ? scene.parts.map->labels[at] : 0;
        const auto part = std::ranges::find(scene.parts.curves, label, &PartCurve::label);
        const Optics one =
            opticsAt(part == scene.parts.curves.end() ? scene.transferFunction : part->transferFunction, hu);
        const double extinction = share.x * share.y * share.z * one.extinction;
        mixed.extinction += extinction;
        mixed.source += extinction * one.source;
    }
    mixed.source /= std::max(mixed.extinction, 1e-300);
    mixed.extinction *= scene.mask ? scene.mask->at(position) : 1;
    return mixed;
}

/// Integrates by the midpoint rule in steps of `stepMm`, which are 200 times finer where the HU pass a node.
inline RayTruth rayTruth(const Scene& scene, const Ray& ray, double stepMm) {
    RayTruth truth;
    std::vector<TransferNode> nodes = scene.transferFunction.nodes;
    for (const PartCurve& part : scene.parts.curves)
        nodes.insert(nodes.end(), part.transferFunction.nodes.begin(), part.transferFunction.nodes.end());
    const auto place = [&](double t) { return dvec3(ray.origin) + dvec3(ray.direction) * t; };
    const auto hu = [&](double t) { return huAt(*scene.volume, place(t)); };
    const auto add = [&](double from, double to) {
        const Optics optics = opticsIn(scene, place((from + to) / 2));
        const double depth = optics.extinction * (to - from);
        truth.absorbed += optics.source * (std::exp(-truth.depth) * -std::expm1(-depth));
        truth.emitted += optics.source * depth;
        truth.depth += depth;
    };
    const auto steps = std::int64_t(std::ceil(ray.length / stepMm));
    double before = hu(0);
    for (std::int64_t i = 0; i < steps; ++i) {
        const double from = double(ray.length) * double(i) / double(steps),
                     to = double(ray.length) * double(i + 1) / double(steps);
        const double behind = hu(to);
        const bool passes = std::ranges::any_of(
            nodes, [&](const TransferNode& node) { return (node.hu - before) * (node.hu - behind) <= 0; });
        before = behind;
        const int parts = passes ? 200 : 1;
        for (int part = 0; part < parts; ++part)
            add(from + (to - from) * part / parts, from + (to - from) * (part + 1) / parts);
    }
    return truth;
}

/// Returns the highest HU on a ray: in steps of `stepMm`, and a thousand times finer about the best of them.
inline double highestOn(const Volume& volume, const Ray& ray, double stepMm) {
    const auto hu = [&](double t) { return huAt(volume, dvec3(ray.origin) + dvec3(ray.direction) * t); };
    double best = 0;
    for (double t = 0; t < ray.length; t += stepMm)
        best = hu(t) > hu(best) ? t : best;
    double highest = -1e30;
    for (int i = -1000; i <= 1000; ++i)
        highest = std::max(highest, hu(std::clamp(best + i * stepMm / 1000, 0.0, double(ray.length))));
    return highest;
}

/// Makes rays that cross the box of `volume` in all directions, along axes and planes too, some from inside.
inline std::vector<Ray> raysThrough(const Volume& volume, int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-1, 1);
    const auto place = [&] { return vec3(unit(random), unit(random), unit(random)); };
    const vec3 low(-0.5f), high = vec3(volume.size()) - 0.5f;
    const vec3 spacing(volume.geometry().spacingMm());
    std::vector<Ray> rays;
    while (int(rays.size()) < count) {
        vec3 direction = place();
        for (int axis = 0; axis < 3; ++axis)
            if (random() % 6 == 0)
                direction[axis] = 0;
        if (glm::length(direction) < 0.1f)
            continue;
        direction = glm::normalize(direction) / spacing;
        const vec3 through = low + (high - low) * (0.5f + 0.4f * place());
        const Interval<float> inside =
            clipped(through, direction, low, high, Interval<float>{random() % 4 ? -1e30f : 0, 1e30f});
        rays.push_back({through + direction * inside.enter, direction, inside.leave - inside.enter});
    }
    return rays;
}

/// Returns the largest relative deviation of a channel from its truth.
inline double worst(dvec3 value, dvec3 truth) {
    const dvec3 off = glm::abs(value - truth) / truth;
    return std::max({off.x, off.y, off.z});
}

}  // namespace pdr::test
