/// What is painted over slices: letters and lengths of the plane itself.

#include <QTest>

#include <algorithm>
#include <vector>

#include "render/slice/slice_letters.h"
#include "render/slice/slice_stack.h"
#include "tests/support/scenes/lattice.h"
#include "tests/support/scenes/stored_ways.h"
#include "ui/annotation/annotations.h"
#include "ui/annotation/orientation_letters.h"
#include "ui/annotation/scale_bar.h"
#include "ui/annotation/slice_camera.h"

using namespace pdr;

namespace {

/// Returns whether something is painted over the upper part of the corner that a cube takes.
bool cornerIsPainted(bool cube) {
    const ivec2 size(400, 400);
    std::vector<std::uint8_t> rgba(std::size_t(4 * size.x * size.y), 0);
    const SlicePlane plane = SlicePlane::around({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1, size);
    ui::annotate({ui::cameraFacing(plane), {}, {}, cube}, size, rgba);
    bool painted = false;
    for (int y = 350; y < 366; ++y)
        for (int x = 350; x < 390; ++x)
            painted = painted || rgba[std::size_t(4 * (y * size.x + x))] != 0;
    return painted;
}

}  // namespace

class SliceCameraTest : public QObject {
    Q_OBJECT

  private slots:
    void theCameraSeesTheSliceWithItsLettersAndItsPixels() {
        const test::Lattice patient{{40, 30, 20}, {0.8, 0.8, 2}, {5, 6, 7}};
        for (const dmat3& axes : test::signedPermutations())
            for (const AnatomicalPlane direction : kAnatomicalPlanes) {
                const SlicePlane plane = SliceStack(patient.stored(axes).geometry(), direction).slice(4);
                const Camera camera = ui::cameraFacing(plane);
                QVERIFY(bool(camera.check()));
                QVERIFY(ui::edgeLetters(camera) == edgeLetters(plane));
                QVERIFY(glm::distance(camera.forward(), plane.normal()) < 1e-12);
                const auto bar = ui::scaleBar(camera, plane.size.y, 20);
                QVERIFY(bar && std::abs(bar->pixels - 10 / plane.mmPerPixel) < 1e-9);
                QCOMPARE(bar->text, QString("10 mm"));
            }
    }

    void noCubeHidesTheCornerOfASlice() {
        QVERIFY(cornerIsPainted(true));
        QVERIFY(!cornerIsPainted(false));
    }
};

QTEST_MAIN(SliceCameraTest)
#include "slice_camera_test.moc"
