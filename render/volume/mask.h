#pragma once
/// The visible part of a volume: a weight at every place, between 0 (hidden) and 1 (visible), that multiplies the
/// extinction there. Voxels, HU, gradients and materials stay as they are, so the edge of a mask is not a skin of
/// half-dense tissue, as it would be with overwritten voxels.
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

/// The positions of a mask's nodes in a volume.
struct MaskGrid {
    ivec3 voxels{0};  ///< size of the volume
    ivec3 shift{0};   ///< along each axis every 2^shift-th voxel has a node; [0, 15]

    /// Returns a grid of nodes at most `nodeMm` apart, but never closer than voxels: fine enough for edges as wide as
    /// kEdgeMm.
    static MaskGrid over(const VolumeGeometry& geometry, double nodeMm = kNodeMm);
    static constexpr double kNodeMm = 1.6;

    /// Returns the number of nodes along each axis; the last one lies on or beyond the last voxel.
    ivec3 size() const { return ((voxels - 1 + (ivec3(1) << shift) - 1) >> shift) + 1; }
    /// Returns the place of a node in the volume, index space.
    dvec3 place(ivec3 node) const { return dvec3(node << shift); }
    bool operator==(const MaskGrid&) const = default;
};

class Mask {
  public:
    /// Width of an edge from hidden to visible [mm]: about two nodes, so that it is smooth and shows no steps.
    static constexpr double kEdgeMm = 2.5;

    /// Makes a mask with one weight per node. `hidden`: see hidden().
    Mask(MaskGrid grid, HugePageVector<std::int16_t> weights, Text hidden);

    const MaskGrid& grid() const { return grid_; }
    const HugePageVector<std::int16_t>& weights() const { return weights_; }
    /// Returns the weight at a place of the volume (index space), in [0, 1]; outside, that of the nearest place inside.
    double at(dvec3 place) const;
    /// Returns what is not shown, as sentences for images and users: "Peeled 7 mm: skin is not shown."
    const Text& hidden() const { return hidden_; }

  private:
    MaskGrid grid_;
    HugePageVector<std::int16_t> weights_;
    Text hidden_;
};

/// Returns the weight at a place that lies `depthMm` from the edge of the visible part: positive inside, negative in
/// what is hidden. At 0 it is half way through the ramp.
inline std::int16_t edgeWeight(double depthMm, double edgeMm = Mask::kEdgeMm) {
    return std::int16_t(std::lround(std::clamp(depthMm / edgeMm + 0.5, 0.0, 1.0) * kSeen));
}

/// Makes the mask whose weight at each place (index space of the volume) is weightAt(place), in [0, kSeen]. weightAt()
/// is called from many threads at once.
std::shared_ptr<const Mask> maskOf(const MaskGrid& grid, Text hidden,
                                   const std::function<std::int16_t(dvec3 place)>& weightAt);

/// Returns the mask of what both masks show: the product of their weights, on the finer grid of the two along each
/// axis. Null stands for "everything is visible". Both must belong to volumes of one size.
std::shared_ptr<const Mask> combined(const std::shared_ptr<const Mask>& a, const std::shared_ptr<const Mask>& b);

/// Returns the mask of what either mask shows: the larger of their weights, on the finer grid of the two along each
/// axis. Neither may be null, and both must belong to volumes of one size. `hidden`: see Mask::hidden().
std::shared_ptr<const Mask> united(const Mask& a, const Mask& b, Text hidden);

}  // namespace pdr
