#include "render/volume/mask.h"

#include <tbb/parallel_for.h>

#include <cassert>
#include <cmath>
#include <utility>

namespace pdr {
namespace {

/// Along one axis: the nodes before and after a place, and the fraction of the way between them at which it lies.
struct NodePair {
    int low, high;
    double fraction;

    NodePair(double place, int voxels, int shift, int nodes) {
        const double node = std::clamp(place, 0.0, double(voxels - 1)) / double(1 << shift);
        low = std::min(int(node), std::max(nodes - 2, 0));
        high = std::min(low + 1, nodes - 1);
        fraction = node - low;
    }
};

}  // namespace

MaskGrid MaskGrid::over(const VolumeGeometry& geometry, double nodeMm) {
    MaskGrid grid{geometry.size, ivec3(0)};
    const dvec3 spacing = geometry.spacingMm();
    for (int axis = 0; axis < 3; ++axis)
        while (grid.shift[axis] < 15 && spacing[axis] * double(2 << grid.shift[axis]) <= nodeMm)
            ++grid.shift[axis];
    return grid;
}

Mask::Mask(MaskGrid grid, HugePageVector<std::int16_t> weights, Text hidden)
    : grid_(grid), weights_(std::move(weights)), hidden_(std::move(hidden)) {
    assert(weights_.size() == std::size_t(grid.size().x) * std::size_t(grid.size().y) * std::size_t(grid.size().z));
}

double Mask::at(dvec3 place) const {
    const ivec3 size = grid_.size();
    const NodePair x(place.x, grid_.voxels.x, grid_.shift.x, size.x), y(place.y, grid_.voxels.y, grid_.shift.y, size.y),
        z(place.z, grid_.voxels.z, grid_.shift.z, size.z);
    double sum = 0;
    for (int n = 0; n < 8; ++n) {
        const int i = n & 1 ? x.high : x.low, j = n & 2 ? y.high : y.low, k = n & 4 ? z.high : z.low;
        const double share = (n & 1 ? x.fraction : 1 - x.fraction) * (n & 2 ? y.fraction : 1 - y.fraction) *
                             (n & 4 ? z.fraction : 1 - z.fraction);
        sum += share *
               weights_[(std::size_t(k) * std::size_t(size.y) + std::size_t(j)) * std::size_t(size.x) + std::size_t(i)];
    }
    return sum / kSeen;
}

/// Returns the grid that is, along each axis, the finer of the two masks' grids.
static MaskGrid finerGrid(const Mask& a, const Mask& b) {
    assert(a.grid().voxels == b.grid().voxels);
    return {a.grid().voxels, glm::min(a.grid().shift, b.grid().shift)};
}

std::shared_ptr<const Mask> maskOf(const MaskGrid& grid, Text hidden,
                                   const std::function<std::int16_t(dvec3 place)>& weightAt) {
    const ivec3 size = grid.size();
    HugePageVector<std::int16_t> weights(std::size_t(size.x) * std::size_t(size.y) * std::size_t(size.z));
    tbb::parallel_for(0, size.z, [&](int k) {
        std::int16_t* weight = weights.data() + std::size_t(k) * std::size_t(size.y) * std::size_t(size.x);
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i)
                *weight++ = weightAt(grid.place({i, j, k}));
    });
    return std::make_shared<const Mask>(grid, std::move(weights), std::move(hidden));
}

std::shared_ptr<const Mask> combined(const std::shared_ptr<const Mask>& a, const std::shared_ptr<const Mask>& b) {
    if (!a || !b)
        return a ? a : b;
    return maskOf(finerGrid(*a, *b), joined(a->hidden(), b->hidden()),
                  [&](dvec3 place) { return std::int16_t(std::lround(kSeen * a->at(place) * b->at(place))); });
}

std::shared_ptr<const Mask> united(const Mask& a, const Mask& b, Text hidden) {
    return maskOf(finerGrid(a, b), std::move(hidden),
                  [&](dvec3 place) { return std::int16_t(std::lround(kSeen * std::max(a.at(place), b.at(place)))); });
}

}  // namespace pdr
