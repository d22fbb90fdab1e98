#pragma once
/// The pixels and depths that cells of the volume cover on the film. They give the depth bounds of each block of
/// pixels.

#include "render/base/cells.h"
#include "render/kernel/flat_scene.h"

namespace pdr {

inline constexpr float kDepthRoom = 1e-4f;  ///< relative margin; projection and rays round differently

/// An affine map from index space to (x, y, depth): film position before the perspective division, and depth in mm.
struct ViewProjection {
    dvec3 origin, perI, perJ, perK;
    dvec3 halfCell;  ///< from the middle of a fine cell to the sides of a box around it
    bool perspective;
    double focus;  ///< depth of the plane in focus [mm]; 0: a pinhole
    dvec2 lens;    ///< radius of the lens in image widths and heights, at depth 1 or (orthographic) at any depth

    explicit ViewProjection(const FlatScene& scene)
        : perspective(scene.camera.perspective > 0),
          focus(scene.camera.focus),
          lens(glm::length(scene.camera.lensRight) / glm::length(scene.camera.right),
               glm::length(scene.camera.lensUp) / glm::length(scene.camera.up)) {
        const FlatCamera& camera = scene.camera;
        const dvec3 right = camera.right / glm::dot(camera.right, camera.right);
        const dvec3 down = -camera.up / glm::dot(camera.up, camera.up);
        const dmat3 local = glm::inverse(scene.volume.exactIndexFromLocal);
        const auto project = [&](dvec3 v) {
            return dvec3(glm::dot(v, right), glm::dot(v, down), glm::dot(v, camera.forward));
        };
        perI = project(local[0]);
        perJ = project(local[1]);
        perK = project(local[2]);
        origin = project(local * -camera.eye);
        halfCell = double(kFineCell) / 2 * (glm::abs(perI) + glm::abs(perJ) + glm::abs(perK));
    }

    PDR_HD dvec3 operator()(dvec3 p) const { return origin + perI * p.x + perJ * p.y + perK * p.z; }

    /// Returns how far a lens spreads a point at `depth` on the film, to each side.
    PDR_HD dvec2 spread(double depth) const {
        if (!(focus > 0))
            return dvec2(0);
        return lens * std::fabs(perspective ? 1 / focus - 1 / depth : 1 - depth / focus);
    }
};

/// Pixels and depths that a cell covers.
struct Footprint {
    dvec2 low, high;
    dvec2 spread;
    double nearest, farthest;
};

/// The blocks of kViewBlock x kViewBlock pixels that a footprint covers, and its depth range.
struct CoveredBlocks {
    ivec2 first, last;  ///< inclusive; empty where first.x > last.x
    float nearest, farthest;

    PDR_HD CoveredBlocks(const Footprint& footprint, ivec2 film, ivec2 blocks)
        : first(0),
          last(-1),
          nearest(float(footprint.nearest) * (1 - kDepthRoom)),
          farthest(float(footprint.farthest) * (1 + kDepthRoom)) {
        const dvec2 low = (footprint.low - footprint.spread + 0.5) * dvec2(film) / double(kViewBlock) - 1e-3;
        const dvec2 high = (footprint.high + footprint.spread + 0.5) * dvec2(film) / double(kViewBlock) + 1e-3;
        if (high.x < 0 || high.y < 0 || low.x >= blocks.x || low.y >= blocks.y)
            return;
        first = ivec2(glm::max(low, dvec2(0)));
        last = ivec2(glm::min(high, dvec2(blocks - 1)));
    }
};

inline ivec2 viewBlocks(ivec2 film) {
    return (film + kViewBlock - 1) / kViewBlock;
}

/// Returns whether a single plane cuts all of a fine cell away.
PDR_HD inline bool cutAway(const FlatClip& clip, ivec3 cell) {
    const vec3 low((cell - 1) * 4), high(cell * 4);
    for (int i = 0; i < clip.count; ++i) {
        const FlatPlane& plane = clip.planes[i];
        const vec3 innermost = glm::mix(high, low, glm::greaterThan(plane.normal, vec3(0)));
        if (glm::dot(plane.normal, innermost) > plane.offset)
            return true;
    }
    return false;
}

/// Returns the footprint of a fine cell, that of a box around its projection. `behind` becomes true if the cell reaches
/// behind the eye and may cover any pixel.
PDR_HD inline Footprint footprintOf(const ViewProjection& projection, ivec3 cell, bool& behind) {
    const dvec3 middle = projection((dvec3(cell) - 0.5) * double(kFineCell));
    const dvec3 low = middle - projection.halfCell, high = middle + projection.halfCell;
    behind = projection.perspective && !(low.z > 1e-3);
    const dvec2 spread = glm::max(projection.spread(low.z), projection.spread(high.z));
    if (!projection.perspective || behind)
        return {dvec2(low), dvec2(high), spread, low.z, high.z};
    const double nearest = 1 / low.z, farthest = 1 / high.z;  // a division takes as long as all the rest
    return {{low.x * (low.x < 0 ? nearest : farthest), low.y * (low.y < 0 ? nearest : farthest)},
            {high.x * (high.x > 0 ? nearest : farthest), high.y * (high.y > 0 ? nearest : farthest)},
            spread,
            low.z,
            high.z};
}

}  // namespace pdr
