#include "render/segment/smooth_distance.h"

#include <algorithm>
#include <cmath>

#include "render/segment/distance.h"
#include "render/segment/for_each_slice.h"

namespace pdr::segment {
namespace {

constexpr float kWeights[5] = {1.0f / 16, 4.0f / 16, 6.0f / 16, 4.0f / 16, 1.0f / 16};

/// Replaces each value of a row by the mean of its neighbours with binomial weights; ends are repeated.
void smoothAlong(float* row, int length, std::vector<float>& before) {
    before.assign(row, row + length);
    for (int i = 0; i < length; ++i) {
        float sum = 0;
        for (int n = -2; n <= 2; ++n)
            sum += kWeights[n + 2] * before[std::size_t(std::clamp(i + n, 0, length - 1))];
        row[i] = sum;
    }
}

/// Smooths as smoothAlong() does, across `count` rows that begin `stride` values apart.
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

SmoothDistance::SmoothDistance(const Cells& cells, std::uint8_t value, const CellGrid& grid, double reachMm,
                               const Checkpoint& checkpoint)
    : grid_(grid), mm_(squaredDistances(cells, value, grid, reachMm, checkpoint)) {
    const auto halfCell = float(0.5 * std::min({grid.spacingMm.x, grid.spacingMm.y, grid.spacingMm.z}));
    const auto reach = float(reachMm);
    forEachSlice(grid.size.z, checkpoint, [&](int z) {
        float* slice = &mm_[grid.index(0, 0, z)];
        for (std::size_t i = 0; i < grid.sliceCount(); ++i)
            slice[i] = std::min(std::sqrt(slice[i]) - halfCell, reach);
    });
    smooth(checkpoint);
}

void SmoothDistance::smooth(const Checkpoint& checkpoint) {
    const ivec3 size = grid_.size;
    forEachSlice(size.z, checkpoint, [&](int z) {
        std::vector<float> before;
        for (int y = 0; y < size.y; ++y)
            smoothAlong(&mm_[grid_.index(0, y, z)], size.x, before);
        smoothAcross(&mm_[grid_.index(0, 0, z)], size.x, size.y, std::size_t(size.x), before);
    });
    forEachSlice(size.y, checkpoint, [&](int y) {
        std::vector<float> before;
        smoothAcross(&mm_[grid_.index(0, y, 0)], size.x, size.z, grid_.sliceCount(), before);
    });
}

double SmoothDistance::at(dvec3 place) const {
    const Between x = between(place.x, 0), y = between(place.y, 1), z = between(place.z, 2);
    const auto row = [&](int j, int k) {
        return glm::mix(double(mm_[grid_.index(x.low, j, k)]), double(mm_[grid_.index(x.high, j, k)]), x.f);
    };
    return glm::mix(glm::mix(row(y.low, z.low), row(y.high, z.low), y.f),
                    glm::mix(row(y.low, z.high), row(y.high, z.high), y.f), z.f);
}

/// Computes in the order of at(), so that both give the same bits.
void SmoothDistance::along(ivec3 first, int step, int count, double* mm) const {
    const Between y = between(first.y, 1), z = between(first.z, 2);
    const float* const rows[4] = {&mm_[grid_.index(0, y.low, z.low)], &mm_[grid_.index(0, y.high, z.low)],
                                  &mm_[grid_.index(0, y.low, z.high)], &mm_[grid_.index(0, y.high, z.high)]};
    for (int i = 0; i < count; ++i) {
        const Between x = between(first.x + i * step, 0);
        const auto row = [&](const float* cells) { return glm::mix(double(cells[x.low]), double(cells[x.high]), x.f); };
        mm[i] = glm::mix(glm::mix(row(rows[0]), row(rows[1]), y.f), glm::mix(row(rows[2]), row(rows[3]), y.f), z.f);
    }
}

}  // namespace pdr::segment
