/// Hard cases 24 to 28: cameras and image sizes. Each naive form is written out and must fail.

#include <QTest>

#include "render/kernel/camera_ray.h"
#include "tests/support/pictures.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

std::shared_ptr<const Volume> cube() {
    return test::makeVolume({24, 24, 24}, dvec3(1), [](int, int, int) { return 0; });
}

}  // namespace

class CamerasTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 24. The slab test alone begins behind the camera.
    void cameraInsideSeesWhatLiesBehindIt_data() {
        QTest::addColumn<double>("eyeX");
        QTest::addColumn<double>("lookX");
        QTest::addColumn<double>("crossed");
        QTest::newRow("middle") << 12.0 << 1.0 << 12.0;
        QTest::newRow("between voxels, to the other side") << 10.5 << -1.0 << 10.5;
        QTest::newRow("on a face, inwards") << 0.0 << 1.0 << 24.0;
        QTest::newRow("on a face, outwards") << 24.0 << 1.0 << 0.0;
        QTest::newRow("before the box, outwards") << -5.0 << -1.0 << 0.0;
    }
    void cameraInsideSeesWhatLiesBehindIt() {
        QFETCH(double, eyeX);
        QFETCH(double, lookX);
        QFETCH(double, crossed);
        Scene scene = test::plainScene(cube(), 0.1f);
        scene.environment = {vec3(1), true};
        scene.transferFunction.nodes[0].albedo = vec3(0);
        scene.film = {8, 8};
        for (const Camera::Type type : {Camera::Type::perspective, Camera::Type::orthographic}) {
            scene.camera = {.type = type,
                            .eyeMm = {eyeX, 12, 12},
                            .targetMm = {eyeX + lookX, 12, 12},
                            .up = {0, 0, 1},
                            .fovDegrees = 1e-3,
                            .heightMm = 1};
            const test::ImageMean got = test::imageMean(test::render(scene, 512));
            const double truth = std::exp(-0.1 * crossed), naive = std::exp(-0.1 * 24);
            QVERIFY(std::fabs(got.mean - truth) <= test::allowedZ(10) * got.standardError);
            QVERIFY(crossed == 24 || std::fabs(got.mean - naive) > 20 * got.standardError);
        }
    }

    /// Case 25. A perspective camera 10 km away: single precision knows places to 1 mm there.
    void farCameraQuantisesPlaces() {
        Scene scene = test::plainScene(cube(), 1);
        const dvec3 centre(12), away = glm::normalize(dvec3(1, 2, 3));
        double worst = 0, naiveWorst = 0;
        for (const double distance : {1e3, 1e7}) {
            scene.camera = {.eyeMm = centre + away * distance,
                            .targetMm = centre,
                            .fovDegrees = glm::degrees(2 * std::atan(15 / distance))};
            const auto prepared = Flattener().prepare(scene);
            const FlatCamera& camera = prepared->flat.camera;
            for (int i = 0; i < 100; ++i) {
                const vec2 place(float(i % 10) * 3 + 1.5f, float(i / 10) * 3 + 1.5f);
                const dvec3 towards = glm::normalize(camera.forward + camera.right * (place.x / 32.0 - 0.5) -
                                                     camera.up * (place.y / 32.0 - 0.5));
                const Ray ray = cameraLeg(prepared->flat, place, vec2(0), {0, 1e30f}).ray;
                if (!(ray.length > 0))
                    continue;
                const auto offLine = [&](dvec3 p) { return glm::length(glm::cross(p - camera.eye, towards)); };
                worst = std::max(
                    {worst, offLine(dvec3(ray.origin)), offLine(dvec3(ray.origin + ray.direction * ray.length))});
                const float depth = float(glm::dot(dvec3(ray.origin) - camera.eye, towards));
                naiveWorst = std::max(naiveWorst, offLine(dvec3(vec3(camera.eye) + vec3(towards) * depth)));
            }
        }
        QVERIFY2(worst < 1e-5 && naiveWorst > 0.1, qPrintable(QString("%1, %2").arg(worst).arg(naiveWorst)));
    }

    /// Case 26. tan(90 degrees) in single precision is a large negative number: the picture is turned round.
    void extremeFieldsOfViewOverflow() {
        QVERIFY(std::tan(float(M_PI) / 2) < 0);
        Scene scene = test::plainScene(cube(), 1);
        scene.camera.up = glm::normalize(dvec3(0.3, 0.2, 1));
        for (const double fov : {1e-4, 179.9, 179.99999}) {
            scene.camera.fovDegrees = fov;
            QVERIFY(bool(scene.check()));
            const auto prepared = Flattener().prepare(scene);
            for (const vec2 place : {vec2(0), vec2(32), vec2(0, 32), vec2(16), vec2(16, 16.001f)}) {
                const Leg leg = cameraLeg(prepared->flat, place, vec2(0), {0, 1e30f});
                QVERIFY(std::fabs(glm::length(leg.direction) - 1) < 1e-6);
                QVERIFY(!std::isnan(leg.ray.length) && glm::dot(dvec3(leg.direction), scene.camera.forward()) > 0);
            }
            QCOMPARE(test::render(scene, 4).status().rejectedSamples, std::uint64_t(0));
        }
        for (const double fov : {0.0, 180.0, -10.0, 360.0, double(NAN), double(INFINITY)}) {
            scene.camera.fovDegrees = fov;
            QVERIFY(!scene.check());
        }
    }
};

QTEST_GUILESS_MAIN(CamerasTest)
#include "cameras_test.moc"
