#include "render/segment/smooth_distance.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "render/segment/distance.h"

namespace pdr::segment {
namespace {

constexpr float kWeights[5] = {1.0f / 16, 4.0f / 16, 6.0f / 16, 4.0f / 16, 1.0f / 16};

/// Replaces each value of a row by the mean of its neighbours with the binomial weights; ends are repeated.
void smoothAlong(float* row, int length, std::vector<float>& before) {
    before.assign(row, row + length);
    for (int i = 0; i < length; ++i) {
        float sum = 0;
        for (int n = -2; n <= 2; ++n)
            sum += kWeights[n + 2] * before[std::size_t(std::clamp(i + n, 0, length - 1))];
        row[i] = sum;
    }
}

/// The same across `count` rows that begin `stride` values apart.
void smoothAcross(float* rows, int length, int count, std::size_t stride, std::vector<float>& before) {
    before.resize(std::size_t(length) * std::size_t(count));
    for (int y = 0; y < count; ++y)
        std::copy_n(rows + std::size_t(y) * stride, length, &before[std::size_t(y) * std::size_t(length)]);
    for (int y = 0; y < count; ++y) {
        const float* from[5];
        for (int n = -2; n <= 2; ++n)
            from[n + 2] = &before[std::size_t(std::clamp(y + n, 0, count - 1)) * std::size_t(length)];
        float* row = rows + std::size_t(y) * stride;
        for (int x = 0; x < length; ++x)
            row[x] = kWeights[0] * from[0][x] + kWeights[1] * from[1][x] + kWeights[2] * from[2][x] +
                     kWeights[3] * from[3][x] + kWeights[4] * from[4][x];
    }
}

}  // namespace

SmoothDistance::SmoothDistance(const Cells& cells, std::uint8_t value, const CellGrid& grid, double reachMm)
    : grid_(grid), mm_(squaredDistances(cells, value, grid, reachMm)) {
    const auto halfCell = float(0.5 * std::min({grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z}));
    const auto reach = float(reachMm);
    tbb::parallel_for(0, grid.size.z, [&](int z) {
        float* slice = &mm_[grid.index(0, 0, z)];
        for (std::size_t i = 0; i < grid.sliceCount(); ++i)
            slice[i] = std::min(std::sqrt(slice[i]) - halfCell, reach);
    });
    smooth();
}

void SmoothDistance::smooth() {
    const ivec3 size = grid_.size;
    tbb::parallel_for(0, size.z, [&](int z) {
        std::vector<float> before;
        for (int y = 0; y < size.y; ++y)
            smoothAlong(&mm_[grid_.index(0, y, z)], size.x, before);
        smoothAcross(&mm_[grid_.index(0, 0, z)], size.x, size.y, std::size_t(size.x), before);
    });
    tbb::parallel_for(0, size.y, [&](int y) {
        std::vector<float> before;
        smoothAcross(&mm_[grid_.index(0, y, 0)], size.x, size.z, grid_.sliceCount(), before);
    });
}

double SmoothDistance::at(dvec3 place) const {
    const dvec3 cell = (place + 0.5) / dvec3(grid_.block) - 0.5;  // of cells' centres
    const dvec3 inside = glm::clamp(cell, dvec3(0), dvec3(grid_.size - 1));
    const ivec3 low = glm::min(ivec3(inside), glm::max(grid_.size - 2, ivec3(0)));
    const ivec3 high = glm::min(low + 1, grid_.size - 1);
    const dvec3 f = inside - dvec3(low);
    const auto row = [&](int y, int z) {
        return glm::mix(double(mm_[grid_.index(low.x, y, z)]), double(mm_[grid_.index(high.x, y, z)]), f.x);
    };
    return glm::mix(glm::mix(row(low.y, low.z), row(high.y, low.z), f.y),
                    glm::mix(row(low.y, high.z), row(high.y, high.z), f.y), f.z);
}

}  // namespace pdr::segment
