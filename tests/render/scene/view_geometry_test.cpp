/// Places and image points: conversion in both directions, in agreement with the renderer.

#include "render/scene/edit/view_geometry.h"

#include <QTest>

#include "render/kernel/transport/camera_ray.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

Camera aslant(Camera::Type type) {
    return {.type = type,
            .eyeMm = {120, -300, 80},
            .targetMm = {10, 20, -30},
            .up = {0.1, 0.2, 1},
            .fovDegrees = 30,
            .heightMm = 210};
}

}  // namespace

class ViewGeometryTest : public QObject {
    Q_OBJECT

  private slots:
    void aPlaceIsUnderThePointWhereItIsSeen_data() {
        QTest::addColumn<int>("type");
        QTest::newRow("perspective") << int(Camera::Type::perspective);
        QTest::newRow("orthographic") << int(Camera::Type::orthographic);
    }
    void aPlaceIsUnderThePointWhereItIsSeen() {
        QFETCH(int, type);
        const ViewGeometry view(aslant(Camera::Type(type)), 1.6);
        const std::optional<dvec2> middle = view.at({10, 20, -30});
        QVERIFY(middle && glm::distance(*middle, dvec2(0.5)) < 1e-12);
        for (const dvec3 place : {dvec3(0, 0, 0), dvec3(60, -20, 10), dvec3(-150, 200, -90)}) {
            const SightLine line = view.under(*view.at(place));
            QVERIFY(std::fabs(glm::length(line.direction) - 1) < 1e-12);
            const dvec3 along = place - line.originMm;
            QVERIFY(glm::length(along - line.direction * glm::dot(along, line.direction)) < 1e-9);
        }
    }

    /// A pixel's ray meets the place that is seen at the pixel's middle.
    void theImageIsTheRenderers() {
        for (const Camera::Type type : {Camera::Type::perspective, Camera::Type::orthographic}) {
            Scene scene = test::plainScene(test::bumpyVolume({40, 30, 30}, {3, 4, 5}, 7), 0.3f);
            scene.camera = aslant(type);
            scene.camera.targetMm = scene.volume->geometry().centreMm();
            scene.film = {320, 200};
            const auto prepared = test::prepared(scene);
            const ViewGeometry view(scene.camera, 1.6);
            for (const ivec2 pixel : {ivec2(160, 100), ivec2(150, 80), ivec2(175, 117)}) {
                const PathSegment segment =
                    generateCameraRay(prepared->flat, vec2(pixel) + 0.5f, vec2(0), vec2(0, 1e30f));
                QVERIFY(segment.ray.length > 0);
                const dvec3 place(scene.volume->geometry().patientFromIndex * dvec4(dvec3(segment.ray.origin), 1));
                const dvec2 expected = (dvec2(pixel) + 0.5) / dvec2(scene.film);
                QVERIFY(glm::distance(*view.at(place), expected) < 1e-5);
            }
        }
    }

    void behindTheEyeNothingIsSeen() {
        const Camera camera{.eyeMm = {0, -100, 0}, .targetMm = {0, 0, 0}, .fovDegrees = 90};
        const ViewGeometry view(camera, 1);
        QVERIFY(!view.at({0, -101, 0}) && !view.at({3, -100, 5}));
        QVERIFY(!view.lineAt({0, -101, 0}, {5, -200, 3}));
        const auto line = view.lineAt({0, 0, 50}, {0, -200, 50});
        QVERIFY(line && std::fabs(line->first.y - 0.25) < 1e-12 && line->second.y < -1000);
        QVERIFY(std::fabs(view.heightMm({7, 0, 9}) - 200) < 1e-9);
        Camera parallel = camera;
        parallel.type = Camera::Type::orthographic;
        QVERIFY(!ViewGeometry(parallel, 1).at({3, -101, 5}) && ViewGeometry(parallel, 1).at({3, -99, 5}));
    }
};

QTEST_APPLESS_MAIN(ViewGeometryTest)
#include "view_geometry_test.moc"
