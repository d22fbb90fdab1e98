#pragma once
/// Walks a ray through the two-level grid of extinction bounds.
///
/// walkMajorants calls visit(begin, end, majorant) for consecutive parts of the ray, in order, distances in mm; parts
/// whose bound is 0 are left out. It descends from a coarse cell to the fine ones only where the coarse bound promises
/// more than kDescend tentative collisions. visit returns false to stop. An accelerator: it never changes the picture.
/// After Amanatides & Woo 1987 ("A fast voxel traversal algorithm"), two levels.

#include "render/kernel/flat_scene.h"
#include "render/kernel/ray.h"

namespace pdr {

inline constexpr float kDescend = 1.5f;  ///< optical depth of a coarse cell's chord above which its fine cells are walked

/// One level of the walk: which cell, and when the ray leaves it along each axis.
class CellWalk {
  public:
    /// Cells of `edge` voxels; `first` is the index coordinate where cell 0 begins; cell indices are clamped into
    /// [low, high] so that rounding at a border cannot start outside.
    PDR_HD CellWalk(const Ray& ray, vec3 inverse, float t, float edge, ivec3 low, ivec3 high) {
        const vec3 position = ray.origin + ray.direction * t;
        for (int axis = 0; axis < 3; ++axis) {
            const float place = (position[axis] + kFineVoxels) / edge;
            cell[axis] = glm::clamp(int(place), low[axis], high[axis]);
            const bool up = ray.direction[axis] > 0;
            step_[axis] = up ? 1 : -1;
            const float border = float(cell[axis] + up) * edge - kFineVoxels;
            leave_[axis] = ray.direction[axis] == 0 ? 1e30f : (border - ray.origin[axis]) * inverse[axis];
            advance_[axis] = glm::abs(edge * inverse[axis]);
        }
    }

    /// Distance at which the ray leaves the current cell; never before `t`.
    PDR_HD float leave(float t) const { return glm::max(t, glm::min(leave_.x, glm::min(leave_.y, leave_.z))); }

    /// On to the next cell; false when that is outside [low, high].
    PDR_HD bool advance(ivec3 low, ivec3 high) {
        const int axis = leave_.x < leave_.y ? (leave_.x < leave_.z ? 0 : 2) : (leave_.y < leave_.z ? 1 : 2);
        leave_[axis] += advance_[axis];
        cell[axis] += step_[axis];
        return cell[axis] >= low[axis] && cell[axis] <= high[axis];
    }

    ivec3 cell;

  private:
    static constexpr float kFineVoxels = 4;  ///< cell 0 begins one fine cell below the first voxel centre

    ivec3 step_;
    vec3 leave_, advance_;
};

template <class Visit>
PDR_HD inline bool walkFine(const FlatMajorants& grid, const Ray& ray, vec3 inverse, ivec3 coarse, float t, float end,
                            Visit& visit) {
    const ivec3 low = coarse * 4, high = low + 3;
    CellWalk walk(ray, inverse, t, 4, low, high);
    do {
        const float leave = glm::min(walk.leave(t), end);
        const ivec3 cell = walk.cell;
        const float majorant = grid.fine[(cell.z * grid.fineSize.y + cell.y) * grid.fineSize.x + cell.x];
        if (majorant > 0 && !visit(t, leave, majorant))
            return false;
        t = leave;
    } while (t < end && walk.advance(low, high));
    return true;
}

template <class Visit>
PDR_HD inline void walkMajorants(const FlatMajorants& grid, const Ray& ray, float begin, Visit&& visit) {
    const Interval occupied =
        clipped(ray.origin, ray.direction, grid.occupiedLow, grid.occupiedHigh, {begin, ray.length});
    float t = occupied.enter;
    const float end = occupied.leave;
    if (!(t < end))
        return;
    const vec3 inverse = 1.0f / ray.direction;
    const ivec3 low(0), high = grid.coarseSize - 1;
    CellWalk walk(ray, inverse, t, 16, low, high);
    do {
        const float leave = glm::min(walk.leave(t), end);
        const ivec3 cell = walk.cell;
        const float majorant = grid.coarse[(cell.z * grid.coarseSize.y + cell.y) * grid.coarseSize.x + cell.x];
        if (majorant * (leave - t) > kDescend) {
            if (!walkFine(grid, ray, inverse, cell, t, leave, visit))
                return;
        } else if (majorant > 0 && !visit(t, leave, majorant)) {
            return;
        }
        t = leave;
    } while (t < end && walk.advance(low, high));
}

}  // namespace pdr
