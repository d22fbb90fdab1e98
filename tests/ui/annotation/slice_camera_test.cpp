/// What is painted over slices: letters and lengths of the plane itself.

#include <QTest>

#include "render/slice/slice_letters.h"
#include "render/slice/slice_stack.h"
#include "tests/support/scenes/lattice.h"
#include "tests/support/scenes/stored_ways.h"
#include "ui/annotation/orientation_letters.h"
#include "ui/annotation/scale_bar.h"
#include "ui/annotation/slice_camera.h"

using namespace pdr;

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
};

QTEST_APPLESS_MAIN(SliceCameraTest)
#include "slice_camera_test.moc"
