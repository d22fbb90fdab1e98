#include "render/segment/blood_cells.h"

#include <algorithm>

#include "render/segment/for_each_slice.h"
#include "render/segment/pieces.h"

namespace pdr::segment {
namespace {

constexpr int kEvenToHu = 1200;      ///< beyond is metal or enamel
constexpr double kEvenHu = 40;       ///< standard deviation of cells' means, noise included ...
constexpr double kEvenShare = 0.08;  ///< ... or as a share of the means: undiluted medium is less uniform
constexpr double kPoolMl = 5;        ///< least pool of blood; smaller regions of marrow are as uniform

/// Returns whether the 27 cells around a cell inside the grid hold blood of uniform density.
bool isEven(const std::vector<std::int16_t>& mean, const CellGrid& grid, int leastHu, ivec3 at) {
    constexpr int kCells = 27;
    std::int64_t sum = 0, squares = 0;
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                const int hu = mean[grid.index(at.x + x, at.y + y, at.z + z)];
                if (hu < leastHu || hu > kEvenToHu)
                    return false;
                sum += hu;
                squares += std::int64_t(hu) * hu;
            }
    const double most = std::max(kEvenHu * kCells, kEvenShare * double(sum));
    return double(squares) * kCells - double(sum) * double(sum) < most * most;
}

}  // namespace

Cells bloodPools(const std::vector<std::int16_t>& mean, const CellGrid& grid, int leastHu,
                 const Checkpoint& checkpoint) {
    Cells blood(mean.size());
    forEachSlice(std::max(grid.size.z - 2, 0), checkpoint, [&](int below) {
        const int z = below + 1;
        for (int y = 1; y < grid.size.y - 1; ++y)
            for (int x = 1; x < grid.size.x - 1; ++x) {
                const std::size_t at = grid.index(x, y, z);
                blood[at] = mean[at] >= leastHu && isEven(mean, grid, leastHu, {x, y, z});
            }
    });
    checkpoint();
    return piecesWith(blood, kPoolMl / grid.cellMl(), blood, grid);
}

}  // namespace pdr::segment
