#pragma once
/// What is seen of a volume: a weight at every place, between 0 (hidden) and 1 (seen), that multiplies the extinction
/// there. Voxels stay as they are, and so do HU, gradients and materials: an edge of a mask is no skin of half-dense
/// tissue, as overwritten voxels would be.
///   node (i,j,k)  voxel (i,j,k) << shift of the volume; between nodes weights are trilinear
///   order         x fastest, then y, then z
///   weights       whole numbers from 0 to kSeen (base/seen.h)
/// Immutable once built.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>

#include "render/base/huge_pages.h"
#include "render/base/seen.h"
#include "render/base/text.h"
#include "render/volume/volume.h"

namespace pdr {

/// Where the nodes of a mask lie in a volume.
struct MaskGrid {
    ivec3 voxels{0};  ///< size of the volume
    ivec3 shift{0};   ///< along each axis every 2^shift-th voxel has a node; [0, 15]

    /// Nodes at most `nodeMm` apart, but never closer than voxels: fine enough for edges as wide as kEdgeMm.
    static MaskGrid over(const VolumeGeometry& geometry, double nodeMm = kNodeMm);
    static constexpr double kNodeMm = 1.6;

    /// Nodes along each axis; the last one lies on or beyond the last voxel.
    ivec3 size() const { return ((voxels - 1 + (ivec3(1) << shift) - 1) >> shift) + 1; }
    /// Place of a node in the volume, index space.
    dvec3 place(ivec3 node) const { return dvec3(node << shift); }
    bool operator==(const MaskGrid&) const = default;
};

class Mask {
  public:
    /// Over so many mm an edge goes from hidden to seen: as wide as two nodes, so that it is smooth and shows no steps.
    static constexpr double kEdgeMm = 2.5;

    /// One weight per node. `hidden`: see hidden().
    Mask(MaskGrid grid, HugePageVector<std::int16_t> weights, Text hidden);

    const MaskGrid& grid() const { return grid_; }
    const HugePageVector<std::int16_t>& weights() const { return weights_; }
    /// The weight at a place of the volume (index space), in [0, 1]; outside, that of the nearest place inside.
    double at(dvec3 place) const;
    /// What is not seen, as sentences for pictures and users: "Peeled 7 mm: skin is not shown."
    const Text& hidden() const { return hidden_; }

  private:
    MaskGrid grid_;
    HugePageVector<std::int16_t> weights_;
    Text hidden_;
};

/// The weight where the edge of what is seen lies `depthMm` away: positive inside, negative in what is hidden. Half way
/// through the ramp at 0.
inline std::int16_t edgeWeight(double depthMm, double edgeMm = Mask::kEdgeMm) {
    return std::int16_t(std::lround(std::clamp(depthMm / edgeMm + 0.5, 0.0, 1.0) * kSeen));
}

/// The mask whose weight at each place (index space of the volume) is weightAt(place), in [0, kSeen]. It is called from
/// many threads at once.
std::shared_ptr<const Mask> maskOf(const MaskGrid& grid, Text hidden,
                                   const std::function<std::int16_t(dvec3 place)>& weightAt);

/// What is seen by both: the product of their weights, on the finer grid of the two along each axis. Null stands for
/// "everything is seen". Both are of volumes of one size.
std::shared_ptr<const Mask> combined(const std::shared_ptr<const Mask>& a, const std::shared_ptr<const Mask>& b);

}  // namespace pdr
