/// The values of slices, bit by bit those of the renderer and of the voxels.

#include <QTest>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

#include "render/kernel/flat_grid.h"
#include "render/kernel/volume_sampling.h"
#include "render/slice/reslice.h"
#include "render/slice/slice_stack.h"
#include "render/slice/slice_step.h"
#include "tests/support/scenes/lattice.h"
#include "tests/support/scenes/made_volume.h"

using namespace pdr;

namespace {

/// A plane of random direction through the middle of the volume.
SlicePlane obliquePlane(const Volume& volume, ivec2 size, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const auto direction = [&] { return glm::normalize(dvec3(normal(random), normal(random), normal(random))); };
    const dvec3 right = direction(), down = glm::normalize(glm::cross(direction(), right));
    const VolumeGeometry& geometry = volume.geometry();
    return SlicePlane::around(geometry.centreMm() + normal(random) * right, right, down,
                              2 * geometry.radiusMm() / std::max(size.x, size.y), size);
}

/// Returns the slice as reslice.h describes its places, one by one.
std::vector<float> oneByOne(const Volume& volume, const SlicePlane& plane) {
    const auto rounded = [](dvec3 v, double parts) { return glm::floor(v * parts + 0.5) / parts; };
    const FlatGrid grid = flatGrid(volume.voxels().data(), volume.size());
    const dmat4 indexFromPatient = glm::inverse(volume.geometry().patientFromIndex);
    const dvec3 perX = rounded(dvec3(indexFromPatient * dvec4(plane.mmPerPixel * plane.right, 0)), 0x1p32);
    const dvec3 perY(indexFromPatient * dvec4(plane.mmPerPixel * plane.down, 0));
    const dvec3 origin(indexFromPatient * dvec4(plane.originMm, 1));
    std::vector<float> values;
    for (int y = 0; y < plane.size.y; ++y)
        for (int x = 0; x < plane.size.x; ++x) {
            const vec3 start(rounded(origin + double(x - x % 64) * perX + double(y) * perY, 0x1p20));
            const vec3 q = start + float(x % 64) * vec3(perX);
            bool inside = true;
            for (int axis = 0; axis < 3; ++axis)
                inside = inside && q[axis] >= -0.5f && q[axis] <= float(volume.size()[axis]) - 0.5f;
            values.push_back(inside ? trilinearAt<float>(grid, {q.x, q.y, q.z}) : NAN);
        }
    return values;
}

bool sameBits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (std::isnan(a) && std::isnan(b));
}

long differing(const std::vector<float>& a, const std::vector<float>& b) {
    long count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += !sameBits(a[i], b[i]);
    return count + std::abs(long(a.size()) - long(b.size()));
}

/// Returns a volume of 128 x 128 x 128 voxels of equal edges, its axes turned as those of madeVolume().
Volume cube() {
    constexpr int kEdge = 128;
    VolumeGeometry geometry{ivec3(kEdge), test::madeVolume().geometry().patientFromIndex};
    for (int axis = 0; axis < 3; ++axis)
        geometry.patientFromIndex[axis] = dvec4(0.683594 * glm::normalize(dvec3(geometry.patientFromIndex[axis])), 0);
    geometry.patientFromIndex[3] = dvec4(-174.31, 212.77, -1033.9, 1);
    Voxels voxels;
    for (int k = 0; k < kEdge; ++k)
        for (int j = 0; j < kEdge; ++j)
            for (int i = 0; i < kEdge; ++i)
                voxels.push_back(test::madeHu(i, j, k));
    return Volume(geometry, std::move(voxels));
}

/// Returns how many pixels of a slice of the cube are not the voxel at their place, bit by bit.
int wrongVoxels(const Volume& cube, const SlicePlane& plane, const dmat4& indexFromPatient) {
    const auto image = reslice(cube, plane);
    int wrong = plane.size == ivec2(cube.size()) ? 0 : 1;
    for (int y = 0; y < plane.size.y; ++y)
        for (int x = 0; x < plane.size.x; ++x) {
            const ivec3 voxel(glm::floor(dvec3(indexFromPatient * dvec4(plane.mmAt({x, y}), 1)) + 0.5));
            wrong += !sameBits(image->at({x, y}), float(test::madeHu(voxel.x, voxel.y, voxel.z)));
        }
    return wrong;
}

}  // namespace

class ResliceTest : public QObject {
    Q_OBJECT

  private slots:
    void everyValueIsTheRenderersBitByBit() {
        const Volume made = test::madeVolume();
        for (std::uint32_t seed = 1; seed <= 40; ++seed) {
            const SlicePlane plane = obliquePlane(made, {131, 77}, seed);
            const std::vector<float> expected = oneByOne(made, plane);
            QCOMPARE(differing(reslice(made, plane)->hu, expected), 0);
            const long inside = std::ranges::count_if(expected, [](float hu) { return !std::isnan(hu); });
            QVERIFY(inside > 500 && inside < long(expected.size()));
        }
    }

    /// 2,097,152 centres, each in a slice along every axis.
    void aVoxelsCentreShowsTheVoxelBitByBit() {
        const Volume volume = cube();
        const dmat4 indexFromPatient = glm::inverse(volume.geometry().patientFromIndex);
        for (const AnatomicalPlane plane : kAnatomicalPlanes) {
            const SliceStack stack(volume.geometry(), plane);
            for (int index = 0; index < stack.count(); ++index)
                QCOMPARE(wrongVoxels(volume, stack.slice(index), indexFromPatient), 0);
        }
    }

    /// Interpolated in double at places in double, over 200,000 places.
    void aValueIsWithinAFractionOfAHuOfTheTruth() {
        const test::Lattice patient{{61, 47, 53}, {0.8, 1.1, 2.3}, {-30, 12, -200}};
        const Volume volume = patient.stored(dmat3(1));
        long compared = 0;
        double worst = 0;
        for (std::uint32_t seed = 1; seed <= 25; ++seed) {
            const SlicePlane plane = obliquePlane(volume, {200, 190}, seed);
            const auto image = reslice(volume, plane);
            for (int y = 0; y < plane.size.y; ++y)
                for (int x = 0; x < plane.size.x; ++x) {
                    const double expected = patient.huAt(plane.mmAt({x, y})), shown = image->at({x, y});
                    if (std::isnan(expected) || std::isnan(shown))
                        continue;
                    worst = std::max(worst, std::abs(expected - shown));
                    ++compared;
                }
        }
        QVERIFY2(compared >= 200'000, qPrintable(QString::number(compared)));
        QVERIFY2(worst < 0.05, qPrintable(QString::number(worst)));
    }

    /// A voxel reaches half a step to either side of its centre.
    void thereAreHuUpToTheEdgeOfTheOutermostVoxelsAndNotBeyond() {
        const Volume made(VolumeGeometry::aligned({8, 6, 4}, {1, 1, 1}, {0, 0, 0}), Voxels(8 * 6 * 4, 77));
        const dvec3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (int axis = 0; axis < 3; ++axis)
            for (const double out : {-1.0, 1.0}) {
                const double face = out < 0 ? -0.5 : made.size()[axis] - 0.5;
                dvec3 at(2, 2, 2);
                const auto shown = [&](double place) {
                    at[axis] = place;
                    return reslice(made, SlicePlane::around(at, axes[axis], axes[(axis + 1) % 3], 1, {1, 1}))->hu[0];
                };
                QCOMPARE(shown(face - 0.001 * out), 77.0f);
                QVERIFY(std::isnan(shown(face + 0.001 * out)));
            }
        SlicePlane nowhere = obliquePlane(made, {20, 20}, 1);
        nowhere.originMm.x = NAN;
        QVERIFY(std::ranges::all_of(reslice(made, nowhere)->hu, [](float hu) { return std::isnan(hu); }));
    }

    /// Lanes cannot read a volume of one column; a slice of it is made one by one.
    void aVolumeOfOneColumnHasSlices() {
        for (const ivec3 size : {ivec3(1, 9, 7), ivec3(9, 1, 7), ivec3(9, 7, 1), ivec3(1, 1, 1)}) {
            const test::Lattice patient{size, {1.5, 1, 2}, {3, 4, 5}};
            const Volume volume = patient.stored(dmat3(1));
            for (std::uint32_t seed = 1; seed <= 5; ++seed) {
                const SlicePlane plane = obliquePlane(volume, {40, 40}, seed);
                QCOMPARE(differing(reslice(volume, plane)->hu, oneByOne(volume, plane)), 0);
            }
        }
    }

    /// Against slices that lie half a step or less apart, from face to face.
    void aSlabIsTheLargestSmallestOrMeanOfItsSlices() {
        const Volume made = test::madeVolume();
        const SlicePlane plane = obliquePlane(made, {70, 40}, 3);
        constexpr double kThickMm = 6;
        const int steps = int(std::ceil(kThickMm / (sliceStepMm(made.geometry(), plane.normal()) / 2)));
        std::vector<std::vector<float>> slices;
        for (int s = 0; s <= steps; ++s)
            slices.push_back(reslice(made, plane.behind(kThickMm * (double(s) / steps - 0.5)))->hu);
        const auto highest = reslice(made, plane, {kThickMm, SlabKind::maximum});
        const auto lowest = reslice(made, plane, {kThickMm, SlabKind::minimum});
        const auto mean = reslice(made, plane, {kThickMm, SlabKind::mean});
        int whole = 0;
        for (std::size_t i = 0; i < highest->hu.size(); ++i) {
            double low = INFINITY, high = -INFINITY, sum = 0, weights = 0;
            for (int s = 0; s <= steps; ++s) {
                const double hu = slices[std::size_t(s)][i];
                if (std::isnan(hu))
                    continue;
                const double weight = s == 0 || s == steps ? 0.5 : 1;
                low = std::min(low, hu);
                high = std::max(high, hu);
                sum += weight * hu;
                weights += weight;
            }
            QCOMPARE(std::isnan(highest->hu[i]), weights == 0);
            if (weights == 0)
                continue;
            whole += weights == steps;
            QVERIFY(std::abs(highest->hu[i] - high) < 0.1);
            QVERIFY(std::abs(lowest->hu[i] - low) < 0.1);
            QVERIFY(std::abs(mean->hu[i] - sum / weights) < 0.1);
        }
        QVERIFY(whole > 100);
    }

    /// The whole width, not half of it: a sheet at 2.9 mm is in a slab of 6 mm, one at 3.1 mm is not.
    void aSlabIsAsThickAsItSays() {
        Voxels voxels(9 * 9 * 201, 0);
        for (int k = 0; k < 201; ++k)
            if (k == 71 || k == 131)  // 2.9 mm before the middle, 3.1 mm behind it
                std::fill_n(voxels.begin() + k * 81, 81, std::int16_t(k));
        const Volume sheets(VolumeGeometry::aligned({9, 9, 201}, {1, 1, 0.1}, {0, 0, 0}), std::move(voxels));
        const SlicePlane axial = SlicePlane::around({4, 4, 10}, {1, 0, 0}, {0, 1, 0}, 1, {5, 5});
        QCOMPARE(reslice(sheets, axial, {6.0, SlabKind::maximum})->at({2, 2}), 71.0f);
        QCOMPARE(reslice(sheets, axial, {6.4, SlabKind::maximum})->at({2, 2}), 131.0f);
        QCOMPARE(reslice(sheets, axial, {5.6, SlabKind::maximum})->at({2, 2}), 0.0f);
    }

    void memoryThatIsUsedAgainLeavesNoTrace() {
        const Volume made = test::madeVolume();
        const SlicePlane plane = obliquePlane(made, {90, 50}, 5);
        for (const std::size_t before : {10u, 100'000u})
            QCOMPARE(differing(reslice(made, plane, {}, {}, std::vector<float>(before, 7))->hu, oneByOne(made, plane)),
                     0);
    }

    void aSliceThatNobodyWaitsForIsNotMade() {
        std::stop_source stop;
        stop.request_stop();
        const Volume made = test::madeVolume();
        QVERIFY(!reslice(made, obliquePlane(made, {64, 64}, 1), {}, stop.get_token()));
    }
};

QTEST_APPLESS_MAIN(ResliceTest)
#include "reslice_test.moc"
