#include "render/segment/symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "render/segment/smooth_distance.h"

namespace pdr::segment {
namespace {

constexpr double kReachMm = 30;         ///< misfit that counts at first, so that the plane is found from afar
constexpr double kMostMisfitMm = 8;     ///< and at last
constexpr std::size_t kPlaces = 20000;  ///< places of the surface to look at

/// The surface of the bones: distances from it, and some of its places.
class Surface {
  public:
    Surface(const Cells& bones, const CellGrid& grid, const VolumeGeometry& geometry, const Checkpoint& checkpoint)
        : size_(geometry.size),
          indexFromPatient_(glm::inverse(geometry.patientFromIndex)),
          outside_(bones, 1, grid, kReachMm, checkpoint),
          inside_(bones, 0, grid, kReachMm, checkpoint) {
        for (int z = 0; z < grid.size.z; ++z)
            for (int y = 0; y < grid.size.y; ++y)
                for (int x = 0; x < grid.size.x; ++x)
                    if (isAtSurface(bones, grid, {x, y, z}))
                        places_.emplace_back(geometry.patientFromIndex *
                                             dvec4((dvec3(x, y, z) + 0.5) * dvec3(grid.block) - 0.5, 1));
        thin();
    }

    const std::vector<dvec3>& places() const { return places_; }
    /// Returns how much farther from the surface the mirror image of a place lies than the place, at most `mostMm`, as
    /// images outside the scan have.
    double misfitMm(const dvec3& place, const dvec3& image, double mostMm) const {
        const dvec3 at = index(image);
        if (glm::any(glm::lessThan(at, dvec3(-0.5))) || glm::any(glm::greaterThan(at, dvec3(size_) - 0.5)))
            return mostMm;
        return std::min(std::abs(fromSurface(at) - fromSurface(index(place))), mostMm);
    }

  private:
    dvec3 index(const dvec3& mm) const { return dvec3(indexFromPatient_ * dvec4(mm, 1)); }
    /// Returns the distance of a place in index space from the surface [mm], negative in bone.
    double fromSurface(const dvec3& at) const {
        const double outside = outside_.at(at), inside = inside_.at(at);
        return outside > inside ? outside : -inside;
    }
    /// Returns whether a cell is bone beside one that is none. The border of the scan cuts bone, and is no surface.
    static bool isAtSurface(const Cells& bones, const CellGrid& grid, ivec3 cell) {
        if (!bones[grid.index(cell.x, cell.y, cell.z)])
            return false;
        for (int axis = 0; axis < 3; ++axis)
            for (const int step : {-1, 1}) {
                ivec3 beside = cell;
                beside[axis] = std::clamp(cell[axis] + step, 0, grid.size[axis] - 1);
                if (!bones[grid.index(beside.x, beside.y, beside.z)])
                    return true;
            }
        return false;
    }
    /// Keeps every so-manieth place.
    void thin() {
        const std::size_t step = places_.size() / kPlaces + 1;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < places_.size(); i += step)
            places_[kept++] = places_[i];
        places_.resize(kept);
    }

    ivec3 size_;
    dmat4 indexFromPatient_;
    SmoothDistance outside_, inside_;
    std::vector<dvec3> places_;
};

/// A plane near the one across the left-right axis: its turns about the other two axes, as slopes, and its shift from
/// the middle of the bones [mm].
using Tilt = std::array<double, 3>;

SymmetryPlane planeOf(const Tilt& tilt, const dvec3& middle) {
    SymmetryPlane plane;
    plane.normal = glm::normalize(dvec3(1, tilt[0], tilt[1]));
    plane.atMm = glm::dot(plane.normal, middle) + tilt[2];
    return plane;
}

double meanMisfit(const Surface& surface, const SymmetryPlane& plane, double mostMm) {
    double sum = 0;
    for (const dvec3& place : surface.places())
        sum += surface.misfitMm(place, plane.mirrored(place), mostMm);
    return sum / double(surface.places().size());
}

/// Farthest from the first plane: 16 degrees, and 30 mm. A skull is nearly its mirror image in other planes, too.
constexpr Tilt kFarthest{0.29, 0.29, 30};

/// Improves a plane by steps along one of its numbers at a time, which are halved where none helps, down to `least` of
/// the first ones.
Tilt improved(const Surface& surface, Tilt best, Tilt steps, double least, const dvec3& middle, double mostMm,
              const Checkpoint& checkpoint) {
    double misfit = meanMisfit(surface, planeOf(best, middle), mostMm);
    for (double scale = 1; scale >= least;) {
        bool helped = false;
        for (std::size_t n = 0; n < best.size(); ++n)
            for (const double sign : {-1.0, 1.0}) {
                checkpoint();
                Tilt other = best;
                other[n] = std::clamp(best[n] + sign * scale * steps[n], -kFarthest[n], kFarthest[n]);
                const double there = meanMisfit(surface, planeOf(other, middle), mostMm);
                if (there >= misfit)
                    continue;
                misfit = there;
                best = other;
                helped = true;
            }
        if (!helped)
            scale /= 2;
    }
    return best;
}

}  // namespace

SymmetryPlane symmetryOf(const Cells& bones, const CellGrid& grid, const VolumeGeometry& geometry,
                         const Checkpoint& checkpoint) {
    const Surface surface(bones, grid, geometry, checkpoint);
    dvec3 middle(0);
    for (const dvec3& place : surface.places())
        middle += place / double(surface.places().size());
    Tilt tilt = improved(surface, {}, {0.07, 0.07, 8}, 0.1, middle, kReachMm, checkpoint);
    tilt = improved(surface, tilt, {0.035, 0.035, 4}, 0.01, middle, kMostMisfitMm, checkpoint);
    SymmetryPlane plane = planeOf(tilt, middle);
    std::vector<double> misfits;
    for (const dvec3& place : surface.places())
        misfits.push_back(surface.misfitMm(place, plane.mirrored(place), kReachMm));
    std::ranges::sort(misfits);
    plane.medianMm = misfits[misfits.size() / 2];
    plane.mostMm = misfits[misfits.size() * 9 / 10];
    return plane;
}

}  // namespace pdr::segment
