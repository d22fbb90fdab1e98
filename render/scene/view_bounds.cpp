#include "render/scene/view_bounds.h"

#include <cmath>
#include <limits>

namespace pdr {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kDepthRoom = 1e-4f;  ///< relative; projection and rays round differently

/// An affine map from index space to (x, y, depth): film place before the perspective division, depth in mm.
struct Projection {
    dvec3 origin, perI, perJ, perK;
    bool perspective;
    double focus;  ///< mm; 0: a pinhole
    dvec2 lens;    ///< the lens' radius in image widths and heights, at depth 1 or (orthographic) everywhere

    explicit Projection(const FlatScene& scene)
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
    }

    dvec3 operator()(dvec3 p) const { return origin + perI * p.x + perJ * p.y + perK * p.z; }

    /// How far a lens spreads what lies at `depth` on the film, to each side.
    dvec2 spread(double depth) const {
        if (!(focus > 0))
            return dvec2(0);
        return lens * std::fabs(perspective ? 1 / focus - 1 / depth : 1 - depth / focus);
    }
};

/// Pixels and depths that a cell covers.
struct Footprint {
    dvec2 low{1e30}, high{-1e30};
    dvec2 spread{0};
    double nearest = 1e30, farthest = -1e30;

    void include(dvec3 projected, const Projection& projection) {
        const dvec2 place = dvec2(projected) / (projection.perspective ? projected.z : 1.0);
        low = glm::min(low, place);
        high = glm::max(high, place);
        spread = glm::max(spread, projection.spread(projected.z));
        nearest = std::min(nearest, projected.z);
        farthest = std::max(farthest, projected.z);
    }
};

class Blocks {
  public:
    explicit Blocks(ivec2 film)
        : size_((film + kViewBlock - 1) / kViewBlock),
          film_(film),
          depths_(std::size_t(size_.x) * size_.y, vec2(kInfinity, -kInfinity)) {}

    void cover(const Footprint& footprint) {
        const dvec2 low = (footprint.low - footprint.spread + 0.5) * dvec2(film_) / double(kViewBlock) - 1e-3;
        const dvec2 high = (footprint.high + footprint.spread + 0.5) * dvec2(film_) / double(kViewBlock) + 1e-3;
        if (high.x < 0 || high.y < 0 || low.x >= size_.x || low.y >= size_.y)
            return;
        const ivec2 first(glm::max(low, dvec2(0))), last(glm::min(high, dvec2(size_ - 1)));
        const float nearest = float(footprint.nearest) * (1 - kDepthRoom);
        const float farthest = float(footprint.farthest) * (1 + kDepthRoom);
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                vec2& depth = depths_[std::size_t(y) * size_.x + x];
                depth = {std::min(depth.x, nearest), std::max(depth.y, farthest)};
            }
    }

    void coverAll() { depths_.assign(depths_.size(), vec2(0, kInfinity)); }
    std::vector<vec2> take() { return std::move(depths_); }

  private:
    ivec2 size_, film_;
    std::vector<vec2> depths_;
};

/// Whether one plane cuts all of a fine cell away.
bool cutAway(const FlatClip& clip, ivec3 cell) {
    const vec3 low((cell - 1) * 4), high(cell * 4);
    for (int i = 0; i < clip.count; ++i) {
        const FlatPlane& plane = clip.planes[i];
        const vec3 innermost = glm::mix(high, low, glm::greaterThan(plane.normal, vec3(0)));
        if (glm::dot(plane.normal, innermost) > plane.offset)
            return true;
    }
    return false;
}

/// Calls visit(cell) for each fine cell with a bound above 0, until it returns false.
template <class Visit>
void forOccupiedCells(const FlatMajorants& grid, Visit&& visit) {
    const auto at = [](const float* values, ivec3 size, ivec3 cell) {
        return values[(std::size_t(cell.z) * size.y + cell.y) * size.x + cell.x];
    };
    for (int K = 0; K < grid.coarseSize.z; ++K)
        for (int J = 0; J < grid.coarseSize.y; ++J)
            for (int I = 0; I < grid.coarseSize.x; ++I) {
                if (!(at(grid.coarse, grid.coarseSize, {I, J, K}) > 0))
                    continue;
                for (int n = 0; n < 64; ++n) {
                    const ivec3 cell(4 * I + (n & 3), 4 * J + ((n >> 2) & 3), 4 * K + (n >> 4));
                    if (at(grid.fine, grid.fineSize, cell) > 0 && !visit(cell))
                        return;
                }
            }
}

}  // namespace

std::vector<vec2> viewDepths(const FlatScene& scene) {
    const Projection projection(scene);
    const dvec3 edges[3] = {4.0 * projection.perI, 4.0 * projection.perJ, 4.0 * projection.perK};
    Blocks blocks(scene.camera.film);
    forOccupiedCells(scene.majorants, [&](ivec3 cell) {
        if (cutAway(scene.clip, cell))
            return true;
        const dvec3 corner = projection(dvec3(cell - 1) * 4.0);
        Footprint footprint;
        for (int n = 0; n < 8; ++n) {
            const dvec3 projected =
                corner + edges[0] * double(n & 1) + edges[1] * double((n >> 1) & 1) + edges[2] * double(n >> 2);
            if (projection.perspective && !(projected.z > 1e-3)) {
                blocks.coverAll();
                return false;
            }
            footprint.include(projected, projection);
        }
        blocks.cover(footprint);
        return true;
    });
    return blocks.take();
}

}  // namespace pdr
