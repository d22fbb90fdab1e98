/// Statistics of regions, and the ± of their mean in noise that is correlated as in CT.

#include <QTest>

#include "render/measure/measured_voxels.h"
#include "render/measure/noise.h"
#include "render/measure/region_statistics.h"
#include "tests/support/scenes/edge_phantoms.h"
#include "tests/support/statistics.h"

using namespace pdr;
using namespace pdr::measure;
using test::Scanner;

namespace {

const Scanner kScanner{{0.9, 0.9, 2.5}, {0.6, 0.6, 0.9}, 20};

Volume noisyWater(const Scanner& scanner, double half, std::mt19937& random) {
    return test::scanned(
        test::gridAround(scanner, half, random), scanner, [](dvec3) { return 100.0; }, random);
}

/// A scan without noise, whose HU rise by 10 a voxel along i.
Volume ramp(std::vector<bool> padding = {}) {
    Voxels voxels;
    for (int k = 0; k < 5; ++k)
        for (int j = 0; j < 9; ++j)
            for (int i = 0; i < 9; ++i)
                voxels.push_back(std::int16_t(10 * i));
    return Volume(VolumeGeometry::aligned({9, 9, 5}, {1, 1, 3}, {-4, -4, -6}), std::move(voxels), std::move(padding));
}

}  // namespace

class RegionStatisticsTest : public QObject {
    Q_OBJECT

  private slots:
    /// The seven voxels in a ball of one step: those on its border count.
    void aBorderBelongsToTheInside() {
        const auto found = regionStatistics(ramp(), Ball{dvec3(0), 1});
        QVERIFY(found);
        QCOMPARE(found->count, std::size_t(5));
        QCOMPARE(found->meanHu, 40.0);
        QCOMPARE(found->medianHu, 40.0);
        QCOMPARE(found->lowestHu, 30.0);
        QCOMPARE(found->highestHu, 50.0);
        QCOMPARE(found->sdHu, std::sqrt(200.0 / 4));
        QCOMPARE(found->millilitres, 0.015);
        QVERIFY(!found->meanPlusMinus && !found->cut);
        QVERIFY(regionStatistics(ramp(), Ball{dvec3(0), 5})->cut);
        QVERIFY(!regionStatistics(ramp(), Ball{{0.5, 0.5, 1.5}, 0.4}));
    }

    void paddingIsLeftOutAndCounted() {
        std::vector<bool> padding(9 * 9 * 5);
        for (std::size_t at = 0; at < padding.size(); ++at)
            padding[at] = at % 9 > 4;
        const auto found = regionStatistics(ramp(padding), Ball{dvec3(0), 1});
        QVERIFY(found);
        QCOMPARE(found->count, std::size_t(4));
        QCOMPARE(found->padding, std::size_t(1));
        QCOMPARE(found->highestHu, 40.0);
        QVERIFY(!regionStatistics(ramp(padding), Ball{{3, 0, 0}, 1}));
    }

    /// A ball holds as many millilitres as its radius says, and a plane takes each voxel of a tilted scan once.
    void regionsOfATiltedScanAreAsLargeAsTheyAre() {
        std::mt19937 random(2);
        const Scanner tilted{{0.9, 0.9, 2.37}, {0.6, 0.6, 0.9}, 0, 0.7, {0, 0.79}};
        const Volume scan = noisyWater(tilted, 20, random);
        const auto ball = regionStatistics(scan, Ball{{1, -2, 0.5}, 15});
        QVERIFY(ball && !ball->cut);
        QVERIFY(std::abs(ball->millilitres / (4 * std::acos(-1.0) / 3 * 3.375) - 1) < 0.01);
        for (const dvec3 normal : {dvec3(0, 0, 1), dvec3(0, 1, 0), glm::normalize(dvec3(0, 2.37, -0.79))}) {
            const double layer = layerMm(scan.geometry(), normal);
            const dvec3 u = 90.0 * glm::normalize(glm::cross(normal, dvec3(1, 0, 0))), v = glm::cross(normal, u);
            std::size_t voxels = 0;
            for (int n = -90; n <= 90; ++n)
                if (const auto found = regionStatistics(scan, PlaneEllipse{(0.23 + n) * layer * normal, u, v}))
                    voxels += found->count;
            QCOMPARE(voxels, scan.geometry().voxelCount());
        }
    }

    /// Planes side by side share no voxel and lose none.
    void aPlaneTakesEachVoxelOnce() {
        std::mt19937 random(1);
        const Volume scan = ramp();
        for (const dvec3 normal : {dvec3(0, 0, 1), dvec3(1, 0, 0), glm::normalize(dvec3(2, 1, 1))}) {
            const double layer = std::abs(normal.x) + std::abs(normal.y) + 3 * std::abs(normal.z);
            const dvec3 least = std::abs(normal.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
            const dvec3 u = 40.0 * glm::normalize(glm::cross(normal, least)), v = glm::cross(normal, u);
            std::size_t ellipses = 0, polygons = 0;
            for (int n = -15; n <= 15; ++n) {
                const dvec3 middle = (0.23 + n) * layer * normal;
                const auto ellipse = regionStatistics(scan, PlaneEllipse{middle, u, v});
                const auto polygon = regionStatistics(
                    scan, PlanePolygon{{middle + u + v, middle + u - v, middle - u - v, middle - u + v}, normal});
                ellipses += ellipse ? ellipse->count : 0;
                polygons += polygon ? polygon->count : 0;
            }
            QCOMPARE(ellipses, std::size_t(9 * 9 * 5));
            QCOMPARE(polygons, std::size_t(9 * 9 * 5));
        }
    }

    /// A plane halfway between two layers of an oblique grid takes one of them whole, whatever rounding says.
    void aPlaneHalfwayTakesOneLayer() {
        const dmat3 axes(12.0 / 13, 5.0 / 13, 0, -0.6 * 5.0 / 13, 0.6 * 12.0 / 13, 0.8, 0.8 * 5.0 / 13,
                         -0.8 * 12.0 / 13, 0.6);
        VolumeGeometry geometry{{9, 9, 5}, dmat4(1)};
        for (int axis = 0; axis < 3; ++axis)
            geometry.patientFromIndex[axis] = dvec4((axis == 2 ? 2.5 : 0.7) * axes[axis], 0);
        geometry.patientFromIndex[3] = dvec4(-217.3, 64.1, 812.7, 1);
        Voxels voxels;
        for (int n = 0; n < 9 * 9 * 5; ++n)
            voxels.push_back(std::int16_t(n / 81));
        const Volume scan(geometry, std::move(voxels));
        for (const double k : {0.5, 1.5, 2.5, 3.5}) {
            const dvec3 middle(geometry.patientFromIndex * dvec4(4, 4, k, 1));
            const auto found = regionStatistics(scan, PlaneEllipse{middle, 20.0 * axes[0], 20.0 * axes[1]});
            QVERIFY(found && found->count == 81 && found->meanHu == k - 0.5);
            QVERIFY(found->cut);
            QVERIFY(!regionStatistics(scan, PlaneEllipse{middle, 2.0 * axes[0], 2.0 * axes[1]})->cut);
        }
        const dvec3 last(geometry.patientFromIndex * dvec4(4, 4, 4.4, 1));  // its slice is in the scan
        QVERIFY(!regionStatistics(scan, PlaneEllipse{last, 2.0 * axes[0], 2.0 * axes[1]})->cut);
    }

    void theNoiseIsThatOfTheScanner() {
        std::mt19937 random(2);
        const Volume scan = noisyWater(kScanner, 30, random);
        const ivec3 size = scan.size();
        Residuals residuals(ivec3(0), size - 1, noiseLags(kScanner.spacingMm));
        std::size_t at = 0;
        for (int k = 0; k < size.z; ++k)
            for (int j = 0; j < size.y; ++j)
                for (int i = 0; i < size.x; ++i)
                    residuals.add({i, j, k}, scan.voxels()[at++] - 100);
        const Noise noise = residuals.noise();
        // White noise through a Gaussian of 0.7 mm is correlated by a Gaussian that is the square root of two wider.
        const double grain = 0.7 / 0.9;
        const auto expected = [grain](double i, double j) {
            return 400 * std::exp(-(i * i + j * j) / (4 * grain * grain));
        };
        for (const ivec3 lag : {ivec3(0), ivec3(1, 0, 0), ivec3(0, 1, 0), ivec3(1, -1, 0), ivec3(2, 0, 0)})
            QVERIFY2(std::abs(noise.covariance(lag) - expected(lag.x, lag.y)) < 16,
                     qPrintable(QString("%1 %2: %3").arg(lag.x).arg(lag.y).arg(noise.covariance(lag))));
        QVERIFY(std::abs(noise.covariance({0, 0, 1})) < 12);
        QCOMPARE(noise.covariance({9, 0, 0}), 0.0);
    }

    /// SD / sqrt(n) holds the truth in half of the cases: neighbours in a slice deviate together.
    void theMeanLiesInItsInterval() {
        std::mt19937 random(3);
        const PlanePolygon corner{{{-17, -17, 0}, {17, -17, 0}, {-5, -5, 0}, {-17, 17, 0}}, {0, 0, 1}};
        const std::pair<MeasuredShape, double> shapes[]{
            {Ball{dvec3(0), 6}, 6},
            {Ball{dvec3(0), 10}, 10},
            {PlaneEllipse{dvec3(0), {15, 0, 0}, {0, 12, 0}}, 15},
            {corner, 17},
        };
        for (const auto& [shape, reach] : shapes) {
            int held = 0, naive = 0;
            const int trials = 200;
            for (int trial = 0; trial < trials; ++trial) {
                const auto found = regionStatistics(noisyWater(kScanner, reach + 3, random), shape);
                QVERIFY(found && found->count >= 200 && found->meanPlusMinus);
                held += std::abs(found->meanHu - 100) <= *found->meanPlusMinus;
                naive += std::abs(found->meanHu - 100) <= 1.96 * found->sdHu / std::sqrt(double(found->count));
            }
            QVERIFY2(held >= 0.89 * trials && held <= 0.99 * trials, qPrintable(QString::number(held)));
            QVERIFY2(naive < 0.75 * trials, qPrintable(QString::number(naive)));
        }
    }
};

QTEST_APPLESS_MAIN(RegionStatisticsTest)
#include "region_statistics_test.moc"
