/// Tests the building blocks of the rule against the simplest way to compute them.

#include <QTest>

#include <random>

#include "render/segment/cell_values.h"
#include "render/segment/distance.h"
#include "render/segment/outline.h"
#include "render/segment/pieces.h"
#include "render/volume/sheared.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;
using namespace pdr::segment;

namespace {

CellGrid gridOf(ivec3 size, dvec3 spacing) {
    return {.size = size, .spacingMm = spacing};
}

/// Returns flags, one in `rarity` of them set.
Cells randomCells(const CellGrid& grid, unsigned rarity, unsigned seed) {
    std::mt19937 random(seed);
    Cells cells(grid.count());
    for (std::uint8_t& cell : cells)
        cell = random() % rarity == 0;
    return cells;
}

template <class Visit>
void eachCell(const CellGrid& grid, Visit&& visit) {
    for (int z = 0; z < grid.size.z; ++z)
        for (int y = 0; y < grid.size.y; ++y)
            for (int x = 0; x < grid.size.x; ++x)
                visit(ivec3(x, y, z), grid.index(x, y, z));
}

}  // namespace

class CellsTest : public QObject {
    Q_OBJECT

  private slots:
    void cellsAreAboutTwoMillimetresAndCoverAll() {
        for (const auto& [size, spacing, block, cells] :
             {std::tuple(ivec3(512, 512, 275), dvec3(0.78, 0.78, 1), ivec3(3, 3, 2), ivec3(171, 171, 138)),
              std::tuple(ivec3(512, 512, 100), dvec3(0.9, 0.9, 2.5), ivec3(2, 2, 1), ivec3(256, 256, 100)),
              std::tuple(ivec3(5, 1, 1), dvec3(0.1, 0.1, 5), ivec3(5, 1, 1), ivec3(1, 1, 1))}) {
            const CellGrid grid = CellGrid::over(VolumeGeometry::aligned(size, spacing, dvec3(0)));
            QVERIFY(grid.block == block);
            QVERIFY(grid.size == cells);
            QVERIFY(glm::length(grid.spacingMm - spacing * dvec3(block)) < 1e-12);
        }
    }

    void aCellIsTheMeanOfItsVoxels() {
        const auto volume = test::bumpyVolume({13, 10, 9}, dvec3(0.7, 0.9, 1.1), 3);
        const CellGrid grid = CellGrid::over(volume->geometry());
        const Cells cells = cellsAbove(-250, cellSums(*volume, grid), grid);
        int above = 0;
        eachCell(grid, [&](ivec3 cell, std::size_t i) {
            double sum = 0, count = 0;
            const ivec3 end = glm::min((cell + 1) * grid.block, volume->size());
            for (int z = cell.z * grid.block.z; z < end.z; ++z)
                for (int y = cell.y * grid.block.y; y < end.y; ++y)
                    for (int x = cell.x * grid.block.x; x < end.x; ++x, ++count)
                        sum += volume->voxels()[(std::size_t(z) * 10 + std::size_t(y)) * 13 + std::size_t(x)];
            QCOMPARE(int(cells[i]), int(sum / count > -250));
            above += cells[i];
        });
        QVERIFY(above > 0 && above < int(cells.size()));
    }

    void whatLiesBelowAirCountsAsAir() {
        const auto padded =
            test::makeVolume({2, 1, 1}, dvec3(1, 2, 2), [](int i, int, int) { return i ? 600 : -3024; });
        const CellGrid one = CellGrid::over(padded->geometry());
        QCOMPARE(int(cellsAbove(-250, cellSums(*padded, one), one)[0]), 1);
    }

    void distancesAreThoseToTheNearestCell() {
        const CellGrid grid = gridOf({19, 14, 11}, {1.8, 2.1, 3.3});
        constexpr double kReach = 7;
        for (const unsigned rarity : {3u, 200u, 100000u}) {
            const Cells cells = randomCells(grid, rarity, rarity);
            const std::vector<float> found = squaredDistances(cells, 1, grid, kReach);
            eachCell(grid, [&](ivec3 here, std::size_t i) {
                double nearest = 1e30;
                eachCell(grid, [&](ivec3 there, std::size_t j) {
                    const dvec3 way = dvec3(there - here) * grid.spacingMm;
                    if (cells[j])
                        nearest = std::min(nearest, glm::dot(way, way));
                });
                if (nearest <= kReach * kReach)
                    QVERIFY(std::abs(double(found[i]) - nearest) <= 1e-5 * nearest);
                else
                    QVERIFY(atLeast(found[i], kReach));
            });
        }
    }

    /// Layers that drift sideways, as those of a tilted gantry do: not to the last bit, but to half of a cell.
    void distancesOnAShearedGridAreThoseInTheRoom() {
        CellGrid grid = gridOf({17, 19, 13}, {1.9, 2.1, 2.4});
        grid.driftMm = {-0.7, 1.6};
        constexpr double kReach = 9, kHalfCell = 1.1;
        for (const unsigned rarity : {40u, 700u}) {
            const Cells cells = randomCells(grid, rarity, rarity);
            const std::vector<float> found = squaredDistances(cells, 1, grid, kReach);
            eachCell(grid, [&](ivec3 here, std::size_t i) {
                double nearest = 1e30;
                eachCell(grid, [&](ivec3 there, std::size_t j) {
                    const dvec3 way =
                        dvec3(there - here) * grid.spacingMm + dvec3(double(there.z - here.z) * grid.driftMm, 0);
                    if (cells[j])
                        nearest = std::min(nearest, glm::length(way));
                });
                const double mm = std::sqrt(double(found[i]));
                QVERIFY(cells[i] ? mm == 0 : mm > 0);
                if (nearest <= kReach - kHalfCell)
                    QVERIFY2(std::abs(mm - nearest) <= kHalfCell, qPrintable(QString("%1 %2").arg(mm).arg(nearest)));
                else if (nearest > kReach + kHalfCell)
                    QVERIFY(mm >= kReach - kHalfCell);
            });
        }
    }

    /// A cell keeps its volume when the layers drift, and a layer's thickness is that across it.
    void cellsOfATiltedScanHoldWhatItsVoxelsHold() {
        VolumeGeometry tilted = VolumeGeometry::aligned({60, 50, 40}, {0.5, 0.5, 2.5}, dvec3(0));
        const double angle = glm::radians(18.5);
        tilted.patientFromIndex[1] = dvec4(0, 0.5 * std::cos(angle), -0.5 * std::sin(angle), 0);
        const CellGrid grid = CellGrid::over(tilted);
        QVERIFY(std::abs(grid.spacingMm.z - 2.5 * std::cos(angle)) < 1e-12);
        QVERIFY(std::abs(grid.driftMm.y + 2.5 * std::sin(angle)) < 1e-12 && std::abs(grid.driftMm.x) < 1e-12);
        QVERIFY(std::abs(grid.cellMl() - 2 * 2 * 2.5 * std::cos(angle) / 1000) < 1e-12);
        QVERIFY(std::abs(volumeMl(Cells(grid.count(), 1), grid) - 60 * 50 * 40 * voxelMl(tilted)) < 1e-9);
    }

    void piecesAreWhatFacesJoin() {
        const CellGrid grid = gridOf({17, 13, 9}, dvec3(2));
        const Cells mask = randomCells(grid, 2, 5);
        const Pieces pieces = piecesOf(mask, grid);
        std::vector<int> seen(std::size_t(pieces.count) + 1);
        eachCell(grid, [&](ivec3 at, std::size_t i) {
            QCOMPARE(pieces.of[i] != 0, mask[i] != 0);
            ++seen[std::size_t(pieces.of[i])];
            for (int axis = 0; axis < 3; ++axis) {
                ivec3 next = at;
                if (++next[axis] < grid.size[axis] && mask[i] && mask[grid.index(next.x, next.y, next.z)])
                    QCOMPARE(pieces.of[i], pieces.of[grid.index(next.x, next.y, next.z)]);
            }
        });
        QVERIFY(std::find(seen.begin(), seen.end(), 0) == seen.end());

        // By painting: as many pieces.
        Cells left = mask;
        int painted = 0;
        for (std::size_t first = 0; first < left.size(); ++first) {
            if (!left[first])
                continue;
            ++painted;
            left[first] = 0;
            std::vector<std::size_t> waiting{first};
            while (!waiting.empty()) {
                const std::size_t i = waiting.back();
                waiting.pop_back();
                const ivec3 at(int(i % 17), int(i / 17 % 13), int(i / 17 / 13));
                for (const ivec3 step : {ivec3(1, 0, 0), ivec3(-1, 0, 0), ivec3(0, 1, 0), ivec3(0, -1, 0),
                                         ivec3(0, 0, 1), ivec3(0, 0, -1)}) {
                    const ivec3 next = at + step;
                    if (glm::any(glm::lessThan(next, ivec3(0))) || glm::any(glm::greaterThanEqual(next, grid.size)))
                        continue;
                    const std::size_t j = grid.index(next.x, next.y, next.z);
                    if (std::exchange(left[j], std::uint8_t(0)))
                        waiting.push_back(j);
                }
            }
        }
        QCOMPARE(pieces.count, painted);
    }

    void holesAreFilledSliceBySlice() {
        const CellGrid grid = gridOf({9, 9, 2}, dvec3(2));
        Cells mask(grid.count());
        for (int z = 0; z < 2; ++z)
            for (int i = 2; i < 7; ++i)
                for (const int side : {2, 6})
                    mask[grid.index(i, side, z)] = mask[grid.index(side, i, z)] = 1;
        mask[grid.index(6, 4, 1)] = 0;  // a door in the second slice
        const Cells filled = withHolesFilled(mask, grid);
        eachCell(grid, [&](ivec3 at, std::size_t i) {
            const bool within = at.x > 1 && at.x < 7 && at.y > 1 && at.y < 7;
            QCOMPARE(int(filled[i]), at.z == 0 ? int(within) : int(mask[i]));
        });
    }

    void growingReachesAllTouchingCells() {
        const CellGrid grid = gridOf({12, 10, 8}, dvec3(2));
        const Cells mask = randomCells(grid, 60, 9);
        const Cells result = grown(mask, grid);
        eachCell(grid, [&](ivec3 at, std::size_t i) {
            int touched = 0;
            eachCell(grid, [&](ivec3 other, std::size_t j) {
                const ivec3 way = glm::abs(other - at);
                touched |= mask[j] && std::max({way.x, way.y, way.z}) <= 1;
            });
            QCOMPARE(int(result[i]), touched);
        });
    }

    void theBoxHoldsTheMask() {
        const CellGrid grid = gridOf({12, 10, 8}, dvec3(2));
        Cells mask(grid.count());
        mask[grid.index(3, 4, 5)] = mask[grid.index(7, 2, 6)] = 1;
        QVERIFY(boxOf(mask, grid).first == ivec3(3, 2, 5));
        QVERIFY(boxOf(mask, grid).end == ivec3(8, 5, 7));
    }
};

QTEST_APPLESS_MAIN(CellsTest)
#include "cells_test.moc"
