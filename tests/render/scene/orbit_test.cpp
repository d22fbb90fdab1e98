/// The effect of a drag on the camera.

#include <QTest>
#include <cmath>

#include "render/scene/orbit.h"

namespace pdr {

/// Returns a view from the front: the patient's left (+x) is on the right of the image, the head (+z) on top.
static Camera frontView() {
    Camera camera;
    camera.eyeMm = {10, -500, 20};
    camera.targetMm = {10, 0, 20};
    camera.up = {0, 0, 1};
    return camera;
}

/// Returns where `point` appears, in fractions of the view's height from the centre; x right, y down.
static dvec2 seenAt(const Camera& camera, dvec3 point) {
    const dvec3 ray = point - camera.eyeMm;
    const double depth = glm::dot(ray, camera.forward());
    const double height = camera.type == Camera::Type::orthographic
                              ? camera.heightMm
                              : 2 * depth * std::tan(glm::radians(camera.fovDegrees) / 2);
    return dvec2(glm::dot(ray, camera.right()), -glm::dot(ray, camera.imageUp())) / height;
}

static double distance(const Camera& camera) {
    return glm::length(camera.targetMm - camera.eyeMm);
}

class TestOrbit : public QObject {
    Q_OBJECT

  private slots:
    void noDragChangesNothing();
    void halfAViewHeightIsAQuarterTurn();
    void theNearSideFollowsTheHand_data();
    void theNearSideFollowsTheHand();
    void theWayOverThePolesHasNoJump();
    void afterTenThousandDragsTheCameraIsStillSquare();
    void thePointUnderTheHandStaysThereWhenPanned_data();
    void thePointUnderTheHandStaysThereWhenPanned();
    void zoomingMagnifiesByItsFactor();
    void theEyeNeverReachesTheTarget();
    void zoomingOutEndsBeforeNumbersDo();
};

void TestOrbit::noDragChangesNothing() {
    QVERIFY(orbited(frontView(), {0, 0}) == frontView());
    QVERIFY(panned(frontView(), {0, 0}) == frontView());
}

void TestOrbit::halfAViewHeightIsAQuarterTurn() {
    const Camera turned = orbited(frontView(), {0.5, 0});
    // The front goes to the right, so the eye comes from the patient's right (-x).
    QVERIFY(glm::length(turned.forward() - dvec3(1, 0, 0)) < 1e-12);
    QVERIFY(glm::length(turned.imageUp() - dvec3(0, 0, 1)) < 1e-12);
    QVERIFY(std::abs(distance(turned) - 500) < 1e-9);
}

void TestOrbit::theNearSideFollowsTheHand_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::newRow("right") << 0.01 << 0.0;
    QTest::newRow("down") << 0.0 << 0.01;
    QTest::newRow("up and left") << -0.01 << -0.01;
}

void TestOrbit::theNearSideFollowsTheHand() {
    QFETCH(double, x);
    QFETCH(double, y);
    const dvec3 nose = frontView().targetMm - frontView().forward() * 100.0;
    const dvec2 moved = seenAt(orbited(frontView(), {x, y}), nose);
    QVERIFY(glm::dot(glm::normalize(moved), glm::normalize(dvec2(x, y))) > 0.999);
}

void TestOrbit::theWayOverThePolesHasNoJump() {
    Camera camera = frontView();
    for (int step = 0; step < 400; ++step) {
        const Camera next = orbited(camera, {0, 0.005});
        QVERIFY(glm::dot(next.forward(), camera.forward()) > 0.9998);
        QVERIFY(glm::dot(next.imageUp(), camera.imageUp()) > 0.9998);
        QVERIFY(glm::dot(next.right(), camera.right()) > 1 - 1e-12);
        camera = next;
    }
    // 400 * 0.005 view heights are a whole turn.
    QVERIFY(glm::length(camera.eyeMm - frontView().eyeMm) < 1e-6);
}

void TestOrbit::afterTenThousandDragsTheCameraIsStillSquare() {
    Camera camera = frontView();
    for (int i = 0; i < 10000; ++i)
        camera = orbited(camera, {0.031 * std::sin(i * 0.7), 0.027 * std::cos(i * 1.3)});
    QVERIFY(std::abs(glm::length(camera.up) - 1) < 1e-12);
    QVERIFY(std::abs(glm::dot(camera.up, camera.forward())) < 1e-12);
    QVERIFY(std::abs(distance(camera) - 500) < 1e-8);
    QVERIFY(camera.targetMm == frontView().targetMm);
}

void TestOrbit::thePointUnderTheHandStaysThereWhenPanned_data() {
    QTest::addColumn<int>("type");
    QTest::newRow("perspective") << int(Camera::Type::perspective);
    QTest::newRow("orthographic") << int(Camera::Type::orthographic);
}

void TestOrbit::thePointUnderTheHandStaysThereWhenPanned() {
    QFETCH(int, type);
    Camera camera = orbited(frontView(), {0.2, 0.1});
    camera.type = Camera::Type(type);
    const dvec3 point = camera.targetMm + camera.right() * 30.0 - camera.imageUp() * 12.0;
    const dvec2 drag{0.17, -0.08};
    const dvec2 expected = seenAt(camera, point) + drag;
    QVERIFY(glm::length(seenAt(panned(camera, drag), point) - expected) < 1e-12);
}

void TestOrbit::zoomingMagnifiesByItsFactor() {
    Camera camera = frontView();
    const dvec3 point = camera.targetMm + camera.right() * 30.0;
    QVERIFY(std::abs(seenAt(zoomed(camera, 1.5), point).x / seenAt(camera, point).x - 1.5) < 1e-12);
    camera.type = Camera::Type::orthographic;
    QVERIFY(std::abs(seenAt(zoomed(camera, 1.5), point).x / seenAt(camera, point).x - 1.5) < 1e-12);
}

void TestOrbit::theEyeNeverReachesTheTarget() {
    Camera camera = frontView();
    for (int i = 0; i < 1000; ++i)
        camera = zoomed(camera, 4);
    QVERIFY(distance(camera) > 0.5);
    QVERIFY(camera.targetMm == frontView().targetMm);
    QVERIFY(glm::length(camera.forward() - frontView().forward()) < 1e-9);
}

void TestOrbit::zoomingOutEndsBeforeNumbersDo() {
    Camera camera = frontView();
    for (int i = 0; i < 1000; ++i)
        camera = zoomed(camera, 0.1);
    QVERIFY(std::isfinite(distance(camera)));
    QVERIFY(glm::length(camera.forward() - frontView().forward()) < 1e-9);
}

}  // namespace pdr

QTEST_GUILESS_MAIN(pdr::TestOrbit)
#include "orbit_test.moc"
