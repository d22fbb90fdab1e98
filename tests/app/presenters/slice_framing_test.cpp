/// Slices in their views: which plane is shown, and what zooming and scrolling do to it.

#include <QTest>

#include <cmath>

#include "app/presenters/slice_framing.h"

namespace pdr::app {
namespace {

VolumeGeometry geometry() {
    return VolumeGeometry::aligned({40, 30, 20}, {1, 1, 2.5}, {-20, -10, 100});
}

/// The grid of a gantry that was tilted by 20 degrees.
VolumeGeometry tilted() {
    VolumeGeometry turned = geometry();
    const double tilt = glm::radians(20.0);
    turned.patientFromIndex[1] = dvec4(0, std::cos(tilt), -std::sin(tilt), 0);
    return turned;
}

}  // namespace

class SliceFramingTest : public QObject {
    Q_OBJECT

  private slots:
    void aWholeSliceFitsItsView() {
        const SlicePlane slice = SliceStack(geometry(), AnatomicalPlane::axial).slice(7);
        for (const ivec2 pixels : {ivec2(400, 400), ivec2(900, 200), ivec2(80, 600), ivec2(1, 1)}) {
            const SlicePlane shown = framed(slice, {}, pixels);
            QVERIFY(shown.size == pixels);
            QVERIFY(glm::length(shown.middleMm() - slice.middleMm()) < 1e-9);
            const dvec2 mm = shown.mmPerPixel * dvec2(pixels), whole = slice.mmPerPixel * dvec2(slice.size);
            QVERIFY(mm.x >= whole.x - 1e-9 && mm.y >= whole.y - 1e-9);
            QVERIFY(std::abs(mm.x - whole.x) < 1e-9 || std::abs(mm.y - whole.y) < 1e-9);
        }
    }

    void zoomingKeepsThePlaceUnderThePointer() {
        const SlicePlane slice = SliceStack(geometry(), AnatomicalPlane::coronal).slice(3);
        SliceFraming framing{1.5, {3, -4}};
        const dvec2 pointer(70.25, 130.5);
        const dvec3 place = framed(slice, framing, {300, 200}).mmAt(pointer);
        for (const double factor : {1.2, 2.0, 1 / 1.2, 0.3, 5.0}) {
            framing = zoomed(framing, slice, factor, place);
            const dvec2 now = framed(slice, framing, {300, 200}).pixelAt(place);
            QVERIFY(glm::length(now - pointer) < 1e-6);
        }
    }

    void magnificationStaysInItsRange() {
        const SlicePlane slice = SliceStack(geometry(), AnatomicalPlane::sagittal).slice(0);
        QCOMPARE(zoomed({}, slice, 1e9, slice.middleMm()).zoom, SliceFraming::kGreatestZoom);
        QCOMPARE(zoomed({}, slice, 1e-9, slice.middleMm()).zoom, SliceFraming::kLeastZoom);
    }

    /// A step leads to the centres of the next slice's voxels, from anywhere in a slice; the rest of the place stays.
    void stepsLeadFromSliceToSlice() {
        const SliceStack stack(geometry(), AnatomicalPlane::axial);
        const dvec3 inSlice5{1.5, 2.25, 100 + 5 * 2.5 + 1.1};
        QCOMPARE(nearestSlice(stack, inSlice5), 5);
        QVERIFY(glm::length(stepped(stack, inSlice5, 1) - dvec3(1.5, 2.25, 115)) < 1e-9);
        QVERIFY(glm::length(stepped(stack, inSlice5, -3) - dvec3(1.5, 2.25, 105)) < 1e-9);
        QVERIFY(glm::length(stepped(stack, inSlice5, 1000) - dvec3(1.5, 2.25, 147.5)) < 1e-9);
        QVERIFY(glm::length(stepped(stack, inSlice5, -1000) - dvec3(1.5, 2.25, 100)) < 1e-9);
        QCOMPARE(nearestSlice(stack, {0, 0, -1e6}), 0);
        QCOMPARE(nearestSlice(stack, {0, 0, 1e6}), 19);
    }

    /// However far one scrolls, the crosshair is in the scan, and the other views show the slices that they showed.
    void stepsThroughATiltedScanStayInIt() {
        const dvec3 first(tilted().patientFromIndex * dvec4(12, 1, 3, 1));
        for (const AnatomicalPlane each : kAnatomicalPlanes) {
            const SliceStack stack(tilted(), each);
            for (const int count : {-1000, -2, 1, 7, 1000}) {
                const dvec3 to = stepped(stack, first, count);
                const dvec3 index(glm::inverse(tilted().patientFromIndex) * dvec4(to, 1));
                QVERIFY(glm::all(glm::greaterThan(index, dvec3(-1e-9))) &&
                        glm::all(glm::lessThan(index, dvec3(39, 29, 19) + 1e-9)));
                for (const AnatomicalPlane other : kAnatomicalPlanes) {
                    const SliceStack others(tilted(), other);
                    if (other != each)
                        QCOMPARE(nearestSlice(others, to), nearestSlice(others, first));
                }
            }
        }
    }

    /// In a sagittal slice the slices that were taken run at the angle of the gantry, towards the feet and the back.
    void linesOfOtherSlicesRunAsTheyCut() {
        const SliceStack axial(tilted(), AnatomicalPlane::axial), coronal(tilted(), AnatomicalPlane::coronal),
            sagittal(tilted(), AnatomicalPlane::sagittal);
        const auto near = [](dvec2 a, dvec2 b) { return glm::length(a - b) < 1e-9; };
        QVERIFY(near(lineOf(axial, sagittal.slice(0)), {1, std::tan(glm::radians(20.0))}));
        QVERIFY(near(lineOf(coronal, sagittal.slice(0)), {0, 1}));
        QVERIFY(near(lineOf(axial, coronal.slice(0)), {1, 0}) && near(lineOf(sagittal, coronal.slice(0)), {0, 1}));
        QVERIFY(near(lineOf(coronal, axial.slice(0)), {1, 0}) && near(lineOf(sagittal, axial.slice(0)), {0, 1}));
    }

    /// A voxel along each axis of the slice, on the display: down in an axial slice is towards the back.
    void aNudgeIsAVoxelAndStaysInTheScan() {
        const SliceStack axial(geometry(), AnatomicalPlane::axial), coronal(geometry(), AnatomicalPlane::coronal);
        const dvec3 place{1.5, 2.25, 110};
        QVERIFY(glm::length(nudged(axial, geometry(), place, {2, 0}) - dvec3(3.5, 2.25, 110)) < 1e-9);
        QVERIFY(glm::length(nudged(axial, geometry(), place, {0, 1}) - dvec3(1.5, 3.25, 110)) < 1e-9);
        QVERIFY(glm::length(nudged(coronal, geometry(), place, {0, 1}) - dvec3(1.5, 2.25, 107.5)) < 1e-9);
        QVERIFY(glm::length(nudged(axial, geometry(), place, {1000, 0}) - dvec3(19, 2.25, 110)) < 1e-9);
        QVERIFY(glm::length(nudged(axial, geometry(), place, {-1000, 0}) - dvec3(-20, 2.25, 110)) < 1e-9);
    }
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::SliceFramingTest)
#include "slice_framing_test.moc"
