#pragma once
/// The HU on a plane through a volume. Every value is one that the renderer meets there (trilinearAt of
/// kernel/volume_sampling.h, exact filtering), bit by bit, and at the centre of a voxel it is the voxel.
/// Places are computed in double at the first of every 64 pixels of a row and rounded there to 2^-20 of a voxel, so
/// that voxel centres are met; from there on in float, at most 1e-5 voxels off. They are the same on every machine.

#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include "render/slice/slice_plane.h"
#include "render/volume/volume.h"

namespace pdr {

/// The way in which the values across a slab become one. Values outside the volume are left out.
enum class SlabKind {
    maximum,  ///< MIP: the largest of the samples
    minimum,  ///< MinIP: the smallest
    mean      ///< the integral by the trapezoidal rule, over the thickness
};

/// How thick a slice is. Samples lie half a step (sliceStepMm) or less apart, evenly, from face to face.
struct Slab {
    double thicknessMm = 0;  ///< whole thickness, half of it on either side; >= 0; 0: the plane alone
    SlabKind kind = SlabKind::maximum;
    bool operator==(const Slab&) const = default;
};

/// A slice, and what it is a slice of: whatever is painted beside it is taken from here.
struct SliceImage {
    SlicePlane plane;
    Slab slab;
    std::vector<float> hu;  ///< row by row from the top; NaN outside the voxels, [-0.5, size - 0.5] in index space

    float at(ivec2 pixel) const { return hu[std::size_t(pixel.y) * std::size_t(plane.size.x) + std::size_t(pixel.x)]; }
};

/// Returns the slice of `volume` on `plane`, computed on the calling thread. None: a stop was requested, which is
/// looked at after every 1024 pixels. `memory`: values that are no longer needed; the new ones take their place, which
/// saves up to half of the time while one slice follows another.
std::optional<SliceImage> reslice(const Volume& volume, const SlicePlane& plane, const Slab& slab = {},
                                  const std::stop_token& stop = {}, std::vector<float> memory = {});
/// Returns the slice of `voxels` on the grid `geometry`, x fastest, then y, then z.
std::optional<SliceImage> reslice(const VolumeGeometry& geometry, std::span<const std::int16_t> voxels,
                                  const SlicePlane& plane, const Slab& slab, const std::stop_token& stop,
                                  std::vector<float> memory);

}  // namespace pdr
