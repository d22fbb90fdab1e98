/// The lens of the camera: what is in focus keeps its place and size, whatever else changes.

#include <QTest>

#include <cmath>

#include "render/scene/edit/camera_edits.h"
#include "render/scene/fit_view.h"
#include "render/scene/orbit.h"

using namespace pdr;

namespace {

/// Returns an oblique view whose sharp plane is the target's, or another.
Camera obliqueCamera(double focusMm) {
    Camera camera;
    camera.eyeMm = {210, -480, 130};
    camera.targetMm = {10, 5, 20};
    camera.up = {0.1, 0, 1};
    camera.fovDegrees = 32;
    camera.focusMm = focusMm;
    return camera;
}

Camera orthographic(double focusMm) {
    return withType(obliqueCamera(focusMm), Camera::Type::orthographic);
}

/// Returns a point in the sharp plane, given in fractions of the view's height from its middle; x right, y up.
dvec3 inFocus(const Camera& camera, dvec2 place) {
    const dvec2 mm = place * camera.heightInFocusMm();
    return camera.eyeMm + camera.forward() * camera.focusDistanceMm() + camera.right() * mm.x + camera.imageUp() * mm.y;
}

/// Returns where a point of the patient is seen, in fractions of the view's height from its middle; x right, y up.
dvec2 seenAt(const Camera& camera, dvec3 point) {
    const dvec3 offset = point - camera.eyeMm;
    const double height = camera.type == Camera::Type::orthographic
                              ? camera.heightMm
                              : 2 * std::tan(glm::radians(camera.fovDegrees) / 2) * glm::dot(offset, camera.forward());
    return dvec2(glm::dot(offset, camera.right()), glm::dot(offset, camera.imageUp())) / height;
}

bool sameInFocus(const Camera& a, const Camera& b) {
    double most = 0;
    for (const dvec2 place : {dvec2(0, 0), dvec2(0.4, 0.3), dvec2(-0.45, 0.1)})
        most = std::max(most, glm::length(seenAt(b, inFocus(a, place)) - place));
    return most < 1e-9 && glm::length(inFocus(a, {0, 0}) - inFocus(b, {0, 0})) < 1e-6;
}

}  // namespace

class CameraEditsTest : public QObject {
    Q_OBJECT

  private slots:
    void switchingTheProjectionKeepsWhatIsInFocus() {
        for (const double focus : {0.0, 300.0, 700.0}) {
            const Camera camera = obliqueCamera(focus);
            const Camera flat = withType(camera, Camera::Type::orthographic);
            QVERIFY(flat.type == Camera::Type::orthographic && flat.check());
            QVERIFY(sameInFocus(camera, flat));
            const Camera back = withType(flat, Camera::Type::perspective);
            QVERIFY(sameInFocus(flat, back) && glm::length(back.eyeMm - camera.eyeMm) < 1e-6);
            QVERIFY(withType(camera, Camera::Type::perspective) == camera);
        }
    }

    void afterAZoomTheEyeStandsWhereItSeesTheSame() {
        for (const double factor : {0.01, 0.3, 7.0, 200.0}) {
            const Camera flat = zoomed(orthographic(300), factor);
            const Camera camera = withType(flat, Camera::Type::perspective);
            QVERIFY(camera.check());
            QVERIFY(glm::dot(camera.forward(), flat.forward()) > 1 - 1e-9);
            QVERIFY(sameInFocus(flat, camera));
        }
    }

    void anotherFieldOfViewKeepsWhatIsInFocus() {
        for (const double focus : {0.0, 300.0, 700.0})
            for (const double degrees : {2.0, 20.0, 60.0, 119.0}) {
                const Camera camera = withFieldOfView(obliqueCamera(focus), degrees);
                QVERIFY(camera.check() && camera.fovDegrees == degrees);
                QVERIFY(sameInFocus(obliqueCamera(focus), camera));
            }
        const Camera flat = withFieldOfView(orthographic(0), 50);
        QVERIFY(flat.fovDegrees == 50 && flat.eyeMm == orthographic(0).eyeMm);
    }

    void aPinholeGetsALensToFocusWith() {
        const Camera camera = focusedAt(obliqueCamera(0), 420);
        QCOMPARE(camera.focusDistanceMm(), 420.0);
        QVERIFY(camera.apertureMm > 0 && camera.check());
        Camera wide = camera;
        wide.apertureMm = 33;
        QCOMPARE(focusedAt(wide, 500).apertureMm, 33.0);
        QVERIFY(focusedAt(obliqueCamera(0), 1e6).check());
        QVERIFY(focusedAt(obliqueCamera(0), 1e-9).check());
    }

    /// Rays from the rim of the lens through a point meet the sharp plane a 500th of the height apart.
    void sharpnessEndsWhereBlurBegins() {
        for (Camera camera : {obliqueCamera(300), orthographic(300)}) {
            camera.apertureMm = 12;
            const SharpDepths depths = sharpDepths(camera);
            const double focus = camera.focusDistanceMm();
            QVERIFY(depths.nearMm < focus && depths.farMm > focus);
            for (const double depth : {depths.nearMm, depths.farMm}) {
                const double slope = camera.type == Camera::Type::perspective ? 1 / depth : 1 / focus;
                const double blur = camera.apertureMm * std::abs(depth - focus) * slope;
                QVERIFY(std::abs(blur / (camera.heightInFocusMm() / 500) - 1) < 1e-9);
            }
        }
        Camera tiny = obliqueCamera(300);
        tiny.apertureMm = 0.01;
        QVERIFY(std::isinf(sharpDepths(tiny).farMm));
        QVERIFY(sharpDepths(obliqueCamera(0)).nearMm == 0 && std::isinf(sharpDepths(obliqueCamera(0)).farMm));
    }

    void aZoomLeavesTheSharpPlaneWhereItIs() {
        const Camera camera = obliqueCamera(300);
        for (const double factor : {0.5, 1.2, 1.6}) {
            const Camera near = zoomed(camera, factor);
            QVERIFY(glm::length(inFocus(camera, {0, 0}) - inFocus(near, {0, 0})) < 1e-9);
        }
        QVERIFY(zoomed(camera, 50).check());  // past it
        QVERIFY(zoomed(orthographic(300), 3).focusMm == orthographic(300).focusMm);
    }

    void dragsMoveAParallelViewAsTheyDoAnother() {
        const Camera flat = orthographic(0);
        const dvec3 point = flat.targetMm + 40.0 * flat.right() - 25.0 * flat.imageUp() + 60.0 * flat.forward();
        const Camera moved = panned(flat, {0.2, -0.1});
        QVERIFY(glm::length(seenAt(moved, point) - seenAt(flat, point) - dvec2(0.2, 0.1)) < 1e-9);
        const Camera larger = zoomed(flat, 2);
        QVERIFY(glm::length(seenAt(larger, point) - 2.0 * seenAt(flat, point)) < 1e-9);
        const Camera turnedOne = orbited(flat, {0.5, 0});
        QVERIFY(turnedOne.heightMm == flat.heightMm && turnedOne.type == flat.type);
        QVERIFY(glm::dot(turnedOne.forward(), flat.forward()) < 1e-9);
        QVERIFY(glm::length(seenAt(turnedOne, flat.targetMm)) < 1e-9);
        const Camera both = panned(zoomed(flat, 1.5), dvec2(0.3, 0.2) * (1 - 1.5));  // as the wheel does there
        const dvec3 under = flat.targetMm + (0.3 * flat.right() - 0.2 * flat.imageUp()) * flat.heightMm;
        QVERIFY(glm::length(seenAt(both, under) - dvec2(0.3, -0.2)) < 1e-9);
    }

    void standardViewsKeepTheLens() {
        const VolumeGeometry box = VolumeGeometry::aligned({100, 80, 60}, dvec3(1, 1, 2), dvec3(5, 6, 7));
        Camera lens = withFieldOfView(orthographic(300), 20);
        lens.apertureMm = 7;
        for (const StandardView view : {StandardView::anterior, StandardView::left, StandardView::inferior}) {
            const Camera flat = fittedView(view, {box, nullptr}, 1.5, 0.9, lens);
            QVERIFY(flat.type == Camera::Type::orthographic && flat.fovDegrees == 20 && flat.apertureMm == 7);
            QCOMPARE(flat.focusMm, 0.0);
            const Camera plain = fittedView(view, {box, nullptr}, 1.5, 0.9);
            QVERIFY(plain.type == Camera::Type::perspective && plain.apertureMm == 0);
            QVERIFY(glm::dot(flat.forward(), plain.forward()) > 1 - 1e-9);
            for (int corner = 0; corner < 8; ++corner) {
                const dvec3 end(corner & 1, corner >> 1 & 1, corner >> 2);
                const dvec3 place(box.patientFromIndex * dvec4(end * dvec3(box.size) - 0.5, 1));
                QVERIFY(std::abs(seenAt(flat, place).y) < 0.4501 && std::abs(seenAt(flat, place).x) < 0.6751);
            }
        }
    }
};

QTEST_APPLESS_MAIN(CameraEditsTest)
#include "camera_edits_test.moc"
