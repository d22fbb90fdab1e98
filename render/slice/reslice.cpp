#include "render/slice/reslice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>

#include "render/base/tile.h"
#include "render/kernel/flat_grid.h"
#include "render/kernel/volume_sampling.h"
#include "render/slice/slice_step.h"

namespace pdr {
namespace {

/// Pixels of a tile: so few rows that the voxels of neighbouring rows and samples are still in the cache.
constexpr int kTileWidth = 64, kTileHeight = 16;

/// Rounds away what is left of a voxel's centre after the way through millimetres, about 1e-13: a value of 0 HU must
/// not become 1e-10. Places change by less than the last bit of a float at 16 voxels.
dvec3 rounded(dvec3 index, double parts) {
    return glm::floor(index * parts + 0.5) / parts;
}
constexpr double kPlaceParts = 0x1p20, kStepParts = 0x1p32;

/// A slab in index space. Sample s of pixel (x, y) lies at origin + x perX + y perY + s perSample.
struct IndexSlab {
    dvec3 origin, perX, perY, perSample;
    int samples;

    IndexSlab(const VolumeGeometry& geometry, const SlicePlane& plane, const Slab& slab) {
        const dmat4 indexFromPatient = glm::inverse(geometry.patientFromIndex);
        const auto direction = [&](dvec3 mm) { return dvec3(indexFromPatient * dvec4(mm, 0)); };
        const double half = slab.thicknessMm / 2;
        samples = 1 + int(std::ceil(2 * slab.thicknessMm / sliceStepMm(geometry, plane.normal())));
        origin = dvec3(indexFromPatient * dvec4(plane.behind(-half).originMm, 1));
        perX = rounded(direction(plane.mmPerPixel * plane.right), kStepParts);
        perY = direction(plane.mmPerPixel * plane.down);
        perSample = samples > 1 ? direction(slab.thicknessMm / (samples - 1) * plane.normal()) : dvec3(0);
    }

    vec3 place(ivec2 pixel, int sample) const {
        return vec3(rounded(origin + double(pixel.x) * perX + double(pixel.y) * perY + double(sample) * perSample,
                            kPlaceParts));
    }
};

/// What the samples of a tile's pixels have come to so far. The rows lie kTileWidth apart.
struct TileValues {
    alignas(64) std::array<float, kTileWidth * kTileHeight> hu, weight;
};

/// Returns x, x + 1, ... in the lanes.
template <class Real>
Real countedFrom(int x) {
    if constexpr (std::is_same_v<Real, float>) {
        return float(x);
    } else {
        Real count;
        for (int lane = 0; lane < kLanes; ++lane)
            count[lane] = float(x + lane);
        return count;
    }
}

/// Returns where a position lies inside the box of the voxels; nowhere if it is not a number.
template <class Real>
auto isInside(const FlatGrid& grid, const Vec3<Real>& q) {
    return (q.x >= -0.5f) & (q.y >= -0.5f) & (q.z >= -0.5f) & (q.x <= grid.lastIndex.x + 0.5f) &
           (q.y <= grid.lastIndex.y + 0.5f) & (q.z <= grid.lastIndex.z + 0.5f);
}

/// Calls take(number of the pixel in the tile, HU, whether inside) for one sample of every pixel, Real by Real. The
/// grid is a copy, so that what is stored cannot change it.
template <class Real, class Take>
void sampleTile(FlatGrid grid, const IndexSlab& slab, const Tile& tile, int sample, const Take& take) {
    constexpr int kTogether = std::is_same_v<Real, float> ? 1 : kLanes;
    const vec3 perX(slab.perX);
    for (int y = 0; y < tile.height; ++y) {
        const vec3 row = slab.place({tile.x, tile.y + y}, sample);
        for (int x = 0; x < tile.width; x += kTogether) {
            const Real across = countedFrom<Real>(x);
            const Vec3<Real> q{row.x + across * perX.x, row.y + across * perX.y, row.z + across * perX.z};
            take(y * kTileWidth + x, trilinearAt(grid, q), isInside(grid, q));
        }
    }
}

template <class Real>
void sumTile(const FlatGrid& grid, const IndexSlab& slab, const Tile& tile, TileValues& values) {
    values.hu.fill(0);
    values.weight.fill(0);
    for (int sample = 0; sample < slab.samples; ++sample) {
        const float weight = sample == 0 || sample == slab.samples - 1 ? 0.5f : 1.0f;
        sampleTile<Real>(grid, slab, tile, sample, [&](int pixel, Real hu, auto inside) {
            float *sum = &values.hu[std::size_t(pixel)], *weights = &values.weight[std::size_t(pixel)];
            store<Real>(load<Real>(sum) + (inside ? weight * hu : Real{}), sum);
            store<Real>(load<Real>(weights) + (inside ? Real{} + weight : Real{}), weights);
        });
    }
    for (std::size_t pixel = 0; pixel < values.hu.size(); ++pixel)
        values.hu[pixel] /= values.weight[pixel];  // not a number where no sample lay inside
}

/// Keeps, for every pixel, the sample inside the volume that is `better` than all others; NaN if there is none.
template <class Real, class Better>
void searchTile(const FlatGrid& grid, const IndexSlab& slab, const Tile& tile, TileValues& values,
                const Better& better) {
    values.hu.fill(std::numeric_limits<float>::quiet_NaN());
    for (int sample = 0; sample < slab.samples; ++sample)
        sampleTile<Real>(grid, slab, tile, sample, [&](int pixel, Real hu, auto inside) {
            float* kept = &values.hu[std::size_t(pixel)];
            const Real before = load<Real>(kept);
            store<Real>((inside & (better(hu, before) | (before != before))) ? hu : before, kept);
        });
}

template <class Real>
void fillTile(const FlatGrid& grid, const IndexSlab& slab, SlabKind kind, const Tile& tile, TileValues& values) {
    if (kind == SlabKind::mean && slab.samples > 1)
        sumTile<Real>(grid, slab, tile, values);
    else if (kind == SlabKind::minimum)
        searchTile<Real>(grid, slab, tile, values, [](Real a, Real b) { return a < b; });
    else
        searchTile<Real>(grid, slab, tile, values, [](Real a, Real b) { return a > b; });
}

}  // namespace

std::optional<SliceImage> reslice(const Volume& volume, const SlicePlane& plane, const Slab& slab,
                                  const std::stop_token& stop, std::vector<float> memory) {
    return reslice(volume.geometry(), volume.voxels(), plane, slab, stop, std::move(memory));
}

std::optional<SliceImage> reslice(const VolumeGeometry& geometry, std::span<const std::int16_t> voxels,
                                  const SlicePlane& plane, const Slab& slab, const std::stop_token& stop,
                                  std::vector<float> memory) {
    const FlatGrid grid = flatGrid(voxels.data(), geometry.size);
    const IndexSlab inIndex(geometry, plane, slab);
    const auto fill = lanesCanRead(grid) ? fillTile<FloatLanes> : fillTile<float>;
    SliceImage image{plane, slab, std::move(memory)};
    image.hu.resize(std::size_t(plane.size.x) * std::size_t(plane.size.y));
    TileValues values;
    for (int top = 0; top < plane.size.y; top += kTileHeight)
        for (int left = 0; left < plane.size.x; left += kTileWidth) {
            if (stop.stop_requested())
                return std::nullopt;
            const Tile tile{left, top, std::min(kTileWidth, plane.size.x - left),
                            std::min(kTileHeight, plane.size.y - top)};
            fill(grid, inIndex, slab.kind, tile, values);
            for (int y = 0; y < tile.height; ++y)
                std::copy_n(&values.hu[std::size_t(y) * kTileWidth], tile.width,
                            &image.hu[std::size_t(top + y) * std::size_t(plane.size.x) + std::size_t(left)]);
        }
    return image;
}

}  // namespace pdr
