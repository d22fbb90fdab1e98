/// Slices of a scan, however it is stored, compared with the patient himself.

#include <QTest>

#include <cmath>

#include "render/slice/reslice.h"
#include "render/slice/slice_letters.h"
#include "render/slice/slice_stack.h"
#include "render/slice/slice_step.h"
#include "tests/support/scenes/lattice.h"
#include "tests/support/scenes/stored_ways.h"

using namespace pdr;
using test::Lattice;

namespace {

/// Shorter than broad and thinner than short, so that no two axes can be exchanged.
const Lattice kPatient{{9, 7, 6}, {0.8, 1.1, 2.3}, {-3.5, 20.25, -112.75}};

/// What radiologists expect of a plane.
struct Convention {
    AnatomicalPlane plane;
    int across;  ///< axis of the patient: 0 left, 1 back, 2 head
    dvec3 right, down;
    EdgeLetters letters;
};
const Convention kConventions[] = {
    {AnatomicalPlane::axial, 2, {1, 0, 0}, {0, 1, 0}, {"R", "L", "A", "P"}},
    {AnatomicalPlane::coronal, 1, {1, 0, 0}, {0, 0, -1}, {"R", "L", "H", "F"}},
    {AnatomicalPlane::sagittal, 0, {0, 1, 0}, {0, 0, -1}, {"A", "P", "H", "F"}},
};

/// Returns how many pixels do not show the patient's HU at their place.
int wrongPixels(const Volume& volume, const SlicePlane& plane) {
    const auto image = reslice(volume, plane);
    int wrong = 0;
    for (int y = 0; y < plane.size.y; ++y)
        for (int x = 0; x < plane.size.x; ++x) {
            const double expected = kPatient.huAt(plane.mmAt({x, y})), shown = image->at({x, y});
            wrong += std::isnan(expected) != std::isnan(shown) || std::abs(expected - shown) > 0.01;
        }
    return wrong;
}

/// Returns a volume that is turned by `degrees` about an axis of the patient.
VolumeGeometry turned(double degrees, int about) {
    VolumeGeometry geometry = VolumeGeometry::aligned({20, 21, 22}, {0.7, 0.7, 1.5}, {-7, -7, -16});
    const double c = std::cos(glm::radians(degrees)), s = std::sin(glm::radians(degrees));
    dmat3 turn(1);
    const int a = (about + 1) % 3, b = (about + 2) % 3;
    turn[a][a] = turn[b][b] = c;
    turn[a][b] = s;
    turn[b][a] = -s;
    geometry.patientFromIndex = dmat4(turn) * geometry.patientFromIndex;
    return geometry;
}

/// Returns a scan with a gantry that was tilted about the rows; the table moved by 2.5 mm along the patient.
VolumeGeometry ofATiltedGantry(double degrees) {
    VolumeGeometry geometry = VolumeGeometry::aligned({24, 30, 20}, {0.5, 0.5, 2.5}, {-6, -8, 400});
    const double tilt = glm::radians(degrees);
    geometry.patientFromIndex[1] = 0.5 * dvec4(0, std::cos(tilt), -std::sin(tilt), 0);
    return geometry;
}

dvec3 indexOf(const VolumeGeometry& geometry, dvec3 mm) {
    return dvec3(glm::inverse(geometry.patientFromIndex) * dvec4(mm, 1));
}

}  // namespace

class SliceStackTest : public QObject {
    Q_OBJECT

  private slots:
    /// 48 ways to store a scan, three planes: no wrong letter, no wrong HU.
    void aSliceShowsThePatientHoweverTheScanIsStored() {
        int slices = 0;
        for (const dmat3& axes : test::signedPermutations()) {
            const Volume volume = kPatient.stored(axes);
            for (const Convention& expected : kConventions) {
                const SliceStack stack(volume.geometry(), expected.plane);
                QCOMPARE(stack.count(), kPatient.size[expected.across]);
                for (int index = 0; index < stack.count(); ++index, ++slices) {
                    const SlicePlane plane = stack.slice(index);
                    QVERIFY(plane.right == expected.right && plane.down == expected.down);
                    QVERIFY(edgeLetters(plane) == expected.letters);
                    QCOMPARE(stack.positionMm(plane.originMm),
                             kPatient.originMm[expected.across] + index * kPatient.spacingMm[expected.across]);
                    QCOMPARE(wrongPixels(volume, plane), 0);
                }
            }
        }
        QCOMPARE(slices, 48 * (9 + 7 + 6));
    }

    /// All voxels are in the image, with their edges, and no pixel has nothing to show.
    void thePixelsCoverTheVoxels() {
        const Volume volume = kPatient.stored(dmat3(1));
        for (const Convention& each : kConventions) {
            const SlicePlane plane = SliceStack(volume.geometry(), each.plane).slice(1);
            for (const auto& [along, pixels] :
                 {std::pair(each.right, plane.size.x), std::pair(each.down, plane.size.y)}) {
                const double voxelsMm = glm::dot(glm::abs(along), dvec3(kPatient.size) * kPatient.spacingMm);
                QVERIFY(pixels * plane.mmPerPixel > voxelsMm - plane.mmPerPixel);
                QVERIFY((pixels - 1) * plane.mmPerPixel <= voxelsMm);
            }
            const auto image = reslice(volume, plane);
            QVERIFY(std::ranges::none_of(image->hu, [](float hu) { return std::isnan(hu); }));
        }
        const SlicePlane axial =
            SliceStack(VolumeGeometry::aligned({512, 300, 9}, {0.9, 0.9, 3}, {0, 0, 0}), AnatomicalPlane::axial)
                .slice(4);
        QVERIFY(axial.size == ivec2(512, 300) && axial.mmPerPixel == 0.9 && axial.originMm == dvec3(0, 0, 12));
    }

    void slicesLieWhereTheyAreAskedFor() {
        const Volume volume = kPatient.stored(test::signedPermutations()[29]);
        for (const Convention& each : kConventions) {
            const SliceStack stack(volume.geometry(), each.plane);
            const double first = kPatient.originMm[each.across], step = kPatient.spacingMm[each.across];
            QCOMPARE(stack.rangeMm().x, first - step / 2);
            QCOMPARE(stack.rangeMm().y, first + (stack.count() - 0.5) * step);
            const SlicePlane between = stack.at(first + 1.3 * step);
            QCOMPARE(stack.positionMm(between.originMm), first + 1.3 * step);
            QCOMPARE(wrongPixels(volume, between), 0);
        }
    }

    /// A head that was tilted in the scanner: slices are those that were taken, up to half of a right angle.
    void theSlicesOfATurnedVolumeFollowIt() {
        for (int about = 0; about < 3; ++about)
            for (const double degrees : {-44.0, -12.5, 7.0, 44.0}) {
                const VolumeGeometry geometry = turned(degrees, about);
                for (const Convention& each : kConventions) {
                    const SlicePlane plane = SliceStack(geometry, each.plane).slice(3);
                    QCOMPARE(edgeLetters(plane).right.substr(0, 1), each.letters.right);
                    QCOMPARE(edgeLetters(plane).bottom.substr(0, 1), each.letters.bottom);
                    dvec3 index = dvec3(glm::inverse(geometry.patientFromIndex) * dvec4(plane.mmAt({5, 4}), 1));
                    QVERIFY(std::abs(index[each.across] - 3) < 1e-9);
                    QVERIFY(std::abs(glm::dot(plane.right, plane.down)) < 1e-12);
                }
            }
        // Beyond that, another axis of the volume is nearer.
        QCOMPARE(SliceStack(turned(46, 0), AnatomicalPlane::axial).count(), 21);
        QCOMPARE(SliceStack(turned(44, 0), AnatomicalPlane::axial).count(), 22);
    }

    /// Axial slices are those that were taken, pixel by pixel; the others are true to the patient, and stay in place.
    void slicesOfATiltedGantryAreThoseThatWereTakenAndUprightOnes() {
        for (const double degrees : {18.5, -30.0}) {
            const VolumeGeometry geometry = ofATiltedGantry(degrees);
            const dvec3 column = glm::normalize(dvec3(geometry.patientFromIndex[1]));
            const SliceStack axial(geometry, AnatomicalPlane::axial), coronal(geometry, AnatomicalPlane::coronal),
                sagittal(geometry, AnatomicalPlane::sagittal);
            QCOMPARE(axial.count(), 20);
            for (int k = 0; k < 20; ++k) {
                const SlicePlane plane = axial.slice(k);
                QVERIFY(plane.size == ivec2(24, 30) && plane.mmPerPixel == 0.5);
                QVERIFY(glm::distance(indexOf(geometry, plane.mmAt({7, 11})), dvec3(7, 11, k)) < 1e-9);
            }
            QVERIFY(glm::distance(axial.slice(0).down, column) < 1e-12);
            QVERIFY(std::abs(axial.rangeMm().y - axial.rangeMm().x - 20 * 2.5 * std::cos(glm::radians(degrees))) <
                    1e-9);
            for (int j = 0; j < coronal.count(); ++j) {
                const SlicePlane plane = coronal.slice(j);
                QVERIFY(glm::distance(plane.right, dvec3(1, 0, 0)) < 1e-12 &&
                        glm::distance(plane.down, dvec3(0, 0, -1)) < 1e-12);
                QVERIFY(std::abs(indexOf(geometry, plane.mmAt({9, 30})).y - j) < 1e-9);
                QVERIFY(glm::length(dvec2(plane.originMm.x, plane.originMm.z) -
                                    dvec2(coronal.slice(0).originMm.x, coronal.slice(0).originMm.z)) < 1e-9);
            }
            for (int i = 0; i < sagittal.count(); ++i) {
                const SlicePlane plane = sagittal.slice(i);
                QVERIFY(glm::distance(plane.right, dvec3(0, 1, 0)) < 1e-12 &&
                        glm::distance(plane.down, dvec3(0, 0, -1)) < 1e-12);
                QVERIFY(std::abs(indexOf(geometry, plane.mmAt({9, 30})).x - i) < 1e-9);
            }
        }
    }

    /// No voxel of any slice lies beside the pixels, and they end less than a pixel beside the last.
    void thePixelsCoverTheVoxelsOfATiltedGantry() {
        for (const double degrees : {18.5, -30.0}) {
            const VolumeGeometry geometry = ofATiltedGantry(degrees);
            for (const AnatomicalPlane each : kAnatomicalPlanes) {
                const SliceStack stack(geometry, each);
                dvec2 low(1e9), high(-1e9);
                const int across = each == AnatomicalPlane::axial ? 2 : each == AnatomicalPlane::coronal ? 1 : 0;
                for (int corner = 0; corner < 8; ++corner) {
                    const dvec3 end(corner & 1, corner >> 1 & 1, corner >> 2);
                    dvec3 voxel = end * dvec3(geometry.size) - 0.5;
                    if (each == AnatomicalPlane::axial)
                        voxel.z = end.z * (geometry.size.z - 1);  // each has its own pixels
                    const SlicePlane plane = stack.slice(end[across] > 0 ? stack.count() - 1 : 0);
                    const dvec2 pixel = plane.pixelAt(dvec3(geometry.patientFromIndex * dvec4(voxel, 1)));
                    low = glm::min(low, pixel);
                    high = glm::max(high, pixel);
                }
                const dvec2 size(stack.slice(0).size);
                QVERIFY(glm::all(glm::greaterThan(low, dvec2(-1))) && glm::all(glm::lessThan(low, dvec2(1e-9))));
                QVERIFY(glm::all(glm::lessThan(high, size)) && glm::all(glm::greaterThan(high, size - 1.0 - 1e-9)));
            }
        }
    }

    void whereASliceLiesIsAcrossIt() {
        const VolumeGeometry geometry = ofATiltedGantry(18.5);
        for (const AnatomicalPlane each : kAnatomicalPlanes) {
            const SliceStack stack(geometry, each);
            const SlicePlane between = stack.at(0.3 * stack.rangeMm().x + 0.7 * stack.rangeMm().y);
            QVERIFY(std::abs(between.depthMm(stack.slice(0).originMm)) > 1);
            const double position = stack.positionMm(between.originMm);
            QVERIFY(std::abs(position - 0.3 * stack.rangeMm().x - 0.7 * stack.rangeMm().y) < 1e-9);
            const int across = each == AnatomicalPlane::axial ? 2 : each == AnatomicalPlane::coronal ? 1 : 0;
            const double expected = 0.7 * stack.count() - 0.5;
            const double found = indexOf(geometry, between.mmAt({5, 6}))[across];
            const double fromBehind = stack.count() - 1 - expected;
            QVERIFY(std::abs(found - expected) < 1e-9 || std::abs(found - fromBehind) < 1e-9);
        }
    }

    void aStepIsTheSpacingAlongAnAxisAndLessThanTheLongestElsewhere() {
        const VolumeGeometry geometry = turned(30, 1);
        for (int axis = 0; axis < 3; ++axis)
            QCOMPARE(sliceStepMm(geometry, glm::normalize(dvec3(geometry.patientFromIndex[axis]))),
                     geometry.spacingMm()[axis]);
        const dvec3 normal = glm::normalize(dvec3(1, 2, 3));
        const VolumeGeometry aligned = VolumeGeometry::aligned({3, 3, 3}, {0.5, 1, 2}, {0, 0, 0});
        const dvec3 parts = normal / dvec3(0.5, 1, 2);
        QCOMPARE(sliceStepMm(aligned, normal), 1 / std::sqrt(glm::dot(parts, parts)));
    }

    void pixelsAndPlacesAreOneAnothersInverse() {
        const dvec3 right = glm::normalize(dvec3(3, 1, -2)), down = glm::normalize(glm::cross(right, dvec3(1, 1, 1)));
        const SlicePlane plane = SlicePlane::around({10, -20, 300}, right, down, 0.37, {101, 64});
        QVERIFY(glm::distance(plane.middleMm(), dvec3(10, -20, 300)) < 1e-9);
        QVERIFY(glm::distance(plane.mmAt({50, 31.5}), dvec3(10, -20, 300)) < 1e-9);
        for (const dvec2 pixel : {dvec2(0, 0), dvec2(100, 63), dvec2(12.25, -7)}) {
            const dvec3 beside = plane.mmAt(pixel) + 4.5 * plane.normal();
            QVERIFY(glm::distance(plane.pixelAt(beside), pixel) < 1e-9);
            QVERIFY(std::abs(plane.depthMm(beside) - 4.5) < 1e-9);
            QVERIFY(std::abs(plane.behind(4.5).depthMm(beside)) < 1e-9);
        }
    }
};

QTEST_APPLESS_MAIN(SliceStackTest)
#include "slice_stack_test.moc"
