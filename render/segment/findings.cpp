#include "render/segment/findings.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "render/volume/sheared.h"

namespace pdr::segment {
namespace {

/// Edge of the cells, which are as near to it as whole voxels allow: small enough to lie inside a great vessel, with
/// enough voxels to distinguish noise from edges.
constexpr double kCellMm = 4;
constexpr int kMetalHu = 2500;

// Cells are counted by their mean, in bins of 10 HU, and by their standard deviation, in bins of 4 HU.
constexpr int kLowestHu = -1024, kBinHu = 10, kMeans = 205, kSpreadHu = 4, kSpreads = 50;

constexpr int meanBin(double hu) {
    return std::clamp(int((hu - kLowestHu) / kBinHu), 0, kMeans - 1);
}

struct CellCounts {
    std::array<std::array<std::uint32_t, kSpreads>, kMeans> cells{};  ///< cells of larger spread are left out
    std::uint64_t metal = 0;                                          ///< voxels above kMetalHu

    void add(const CellCounts& other) {
        metal += other.metal;
        for (int mean = 0; mean < kMeans; ++mean)
            for (int spread = 0; spread < kSpreads; ++spread)
                cells[mean][spread] += other.cells[mean][spread];
    }
    /// Returns the number of cells in the bins [first, last] whose spread lies below bin `spreads`.
    std::uint64_t within(int first, int last, int spreads) const {
        std::uint64_t sum = 0;
        for (int mean = first; mean <= last; ++mean)
            for (int spread = 0; spread < spreads; ++spread)
                sum += cells[mean][spread];
        return sum;
    }
};

struct Moments {
    std::int64_t sum = 0, squares = 0, count = 0;
    void add(std::int64_t hu) {
        sum += hu;
        squares += hu * hu;
        ++count;
    }
    double mean() const { return double(sum) / double(count); }
    double spread() const { return std::sqrt(std::max(0.0, double(squares) / double(count) - mean() * mean())); }
};

ivec3 blockOf(const VolumeGeometry& geometry) {
    const dvec3 voxels = glm::round(dvec3(kCellMm) / geometry.spacingMm());
    return glm::clamp(ivec3(voxels), ivec3(1), geometry.size);
}

/// Counts the whole cells of a layer; the remainder at the end of an axis is left out.
CellCounts countLayer(const Volume& scan, ivec3 block, int layer) {
    const ivec3 size = scan.size(), cells = size / block;
    CellCounts counts;
    std::vector<Moments> row(std::size_t(cells.x));
    for (int j = 0; j < cells.y; ++j) {
        std::ranges::fill(row, Moments{});
        for (int z = layer * block.z; z < (layer + 1) * block.z; ++z)
            for (int y = j * block.y; y < (j + 1) * block.y; ++y) {
                const std::int16_t* hu = &scan.voxels()[(std::size_t(z) * size.y + y) * size.x];
                for (int x = 0; x < cells.x * block.x; ++x) {
                    row[std::size_t(x / block.x)].add(hu[x]);
                    counts.metal += hu[x] > kMetalHu;
                }
            }
        for (const Moments& cell : row)
            if (const int spread = int(cell.spread() / kSpreadHu); spread < kSpreads)
                ++counts.cells[meanBin(cell.mean())][spread];
    }
    return counts;
}

CellCounts countCells(const Volume& scan, ivec3 block) {
    std::vector<CellCounts> layers(std::size_t(scan.size().z / block.z));
    tbb::parallel_for(std::size_t(0), layers.size(),
                      [&](std::size_t layer) { layers[layer] = countLayer(scan, block, int(layer)); });
    CellCounts all;
    for (const CellCounts& layer : layers)
        all.add(layer);
    return all;
}

/// Returns the number of spread bins in which half of the cells of soft tissue lie: the scan's noise.
int noiseBins(const CellCounts& counts) {
    const int first = meanBin(-20), last = meanBin(100);
    const std::uint64_t all = counts.within(first, last, kSpreads);
    int bins = 1;
    while (bins < kSpreads && 2 * counts.within(first, last, bins) < all)
        ++bins;
    return bins;
}

/// Returns the mean HU within 50 of the bin that has the most uniform cells around it; nothing without such a peak.
std::optional<float> bloodPeak(const CellCounts& counts, double cellMl) {
    constexpr double kLeastMl = 15, kEven = 1.6;  // a great vessel; relative to the noise of soft tissue
    constexpr int kReach = 5;
    const int spreads = std::min(int(kEven * noiseBins(counts)) + 1, kSpreads);
    const int first = meanBin(180), last = meanBin(800);
    // Find the bin with the most cells around it
    int best = first;
    std::uint64_t most = 0;
    for (int bin = first; bin <= last; ++bin)
        if (const std::uint64_t here = counts.within(bin - kReach, bin + kReach, spreads); here > most) {
            most = here;
            best = bin;
        }
    if (double(most) * cellMl < kLeastMl || best == first)  // a mere descent from there is dense soft tissue
        return std::nullopt;
    // Average the means around it
    double sum = 0;
    for (int bin = best - kReach; bin <= best + kReach; ++bin)
        sum += (kLowestHu + (bin + 0.5) * kBinHu) * double(counts.within(bin, bin, spreads));
    return float(std::round(sum / double(most)));
}

}  // namespace

Findings findingsOn(const Volume& scan, const VolumeGeometry& bodyBox) {
    const VolumeGeometry& geometry = scan.geometry();
    const ivec3 block = blockOf(geometry);
    const CellCounts counts = countCells(scan, block);
    const double voxel = voxelMl(geometry), cellMl = voxel * block.x * block.y * block.z;
    const dmat4& axes = bodyBox.patientFromIndex;
    Findings findings;
    for (int axis = 0; axis < 3; ++axis)
        findings.widthMm += std::abs(axes[axis].x) * bodyBox.size[axis];
    findings.lungMl = cellMl * double(counts.within(meanBin(-950), meanBin(-600), kSpreads));
    findings.metalMl = voxel * double(counts.metal);
    findings.blood = bloodPeak(counts, cellMl);
    return findings;
}

}  // namespace pdr::segment
