#include "render/segment/findings.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "render/volume/sheared.h"
#include "render/volume/value_unit.h"

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
    double mean() const { return double(sum) / double(count); }
    double spread() const { return std::sqrt(std::max(0.0, double(squares) / double(count) - mean() * mean())); }
};

ivec3 blockOf(const VolumeGeometry& geometry) {
    const dvec3 voxels = glm::round(dvec3(kCellMm) / geometry.spacingMm());
    return glm::clamp(ivec3(voxels), ivec3(1), geometry.size);
}

/// Sums over the voxels of a row of cells that have the same place along the row. Their loops become vector
/// instructions.
struct RowSums {
    explicit RowSums(int length) : sum(std::size_t(length)), squares(sum.size()) {}

    void clear() {
        std::ranges::fill(sum, 0);
        std::ranges::fill(squares, 0);
    }
    void add(const std::int16_t* hu) {
        int above = 0;
        for (std::size_t x = 0; x < sum.size(); ++x) {
            sum[x] += hu[x];
            squares[x] += double(int(hu[x]) * int(hu[x]));
            above += int(hu[x] > kMetalHu);
        }
        metal += std::uint64_t(above);
    }
    /// Returns the moments of the `count` voxels that lie in [first, first + length) along the row.
    Moments of(int first, int length, std::int64_t count) const {
        Moments cell{0, 0, count};
        const auto begin = std::size_t(first), end = begin + std::size_t(length);
        for (auto x = begin; x < end; ++x) {
            cell.sum += sum[x];
            cell.squares += std::int64_t(squares[x]);
        }
        return cell;
    }

    std::vector<std::int64_t> sum;
    std::vector<double> squares;  ///< whole numbers
    std::uint64_t metal = 0;      ///< voxels above kMetalHu
};

/// Counts the whole cells of a layer; the remainder at the end of an axis is left out.
CellCounts countLayer(const Volume& scan, ivec3 block, int layer) {
    const ivec3 size = scan.size(), cells = size / block;
    CellCounts counts;
    RowSums sums(cells.x * block.x);
    for (int j = 0; j < cells.y; ++j) {
        sums.clear();
        for (int z = layer * block.z; z < (layer + 1) * block.z; ++z)
            for (int y = j * block.y; y < (j + 1) * block.y; ++y)
                sums.add(&scan.voxels()[(std::size_t(z) * size.y + y) * size.x]);
        for (int i = 0; i < cells.x; ++i) {
            const Moments cell = sums.of(i * block.x, block.x, std::int64_t(block.x) * block.y * block.z);
            if (const int spread = int(cell.spread() / kSpreadHu); spread < kSpreads)
                ++counts.cells[meanBin(cell.mean())][spread];
        }
    }
    counts.metal = sums.metal;
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
    if (!unitOf(scan).isHu)
        return {};
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
