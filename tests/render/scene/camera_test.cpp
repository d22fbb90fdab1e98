/// The rays of a camera: its field of view is vertical, pixels are square, and the lens has the stated diameter.

#include <QTest>

#include "render/kernel/transport/integrator.h"
#include "render/prepare/layers_under.h"
#include "tests/support/scenes/scenes.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

constexpr ivec2 kFilm(200, 80);
constexpr double kAspect = 200.0 / 80;

/// Returns a scene whose camera looks along +y at the middle of a volume.
Scene view(Camera::Type type) {
    Scene scene = test::plainScene(test::makeVolume({20, 20, 20}, dvec3(5), [](int, int, int) { return 0; }), 1);
    scene.camera = {.type = type, .eyeMm = {50, -400, 50}, .targetMm = {50, 50, 50}, .fovDegrees = 40, .heightMm = 60};
    scene.film = kFilm;
    return scene;
}

PathSegment through(const Scene& scene, vec2 place, vec2 lens = vec2(0)) {
    return generateCameraRay(test::prepared(scene)->flat, place, lens, vec2(0, 1e30f));
}

}  // namespace

class CameraTest : public QObject {
    Q_OBJECT

  private slots:
    /// The ray through the middle of the upper edge has risen by half of it when it meets the sharp plane.
    void theHeightInFocusIsWhatTheEdgesSee() {
        Scene scene = view(Camera::Type::perspective);
        scene.camera.focusMm = 300;
        const vec3 edge = through(scene, vec2(100, 0)).direction;
        QVERIFY(std::fabs(2 * 300 * double(edge.z / edge.y) / scene.camera.heightInFocusMm() - 1) < 1e-5);
        QCOMPARE(view(Camera::Type::orthographic).camera.heightInFocusMm(), 60.0);
    }
    /// The image's middle looks at the target; a ray through the middle of the upper edge rises by half the field of
    /// view, and one through the right edge goes as much further aside as the film is wider than high.
    void fieldOfViewIsVertical() {
        const Scene scene = view(Camera::Type::perspective);
        const double slope = std::tan(glm::radians(20.0));
        for (const auto& [place, across, up] : {std::tuple(vec2(100, 40), 0.0, 0.0),
                                                {vec2(100, 0), 0.0, slope},
                                                {vec2(200, 40), slope * kAspect, 0.0},
                                                {vec2(0, 80), -slope * kAspect, -slope}}) {
            const dvec3 direction(through(scene, place).direction);
            QVERIFY(std::fabs(direction.x / direction.y - across) < 1e-6);
            QVERIFY(std::fabs(direction.z / direction.y - up) < 1e-6);
        }
    }

    void heightOfAnOrthographicViewIsInMillimetres() {
        const Scene scene = view(Camera::Type::orthographic);
        const VolumeGeometry& geometry = scene.volume->geometry();
        for (const auto& [place, across, up] :
             {std::tuple(vec2(100, 40), 50.0, 50.0), {vec2(100, 4), 50.0, 77.0}, {vec2(150, 76), 87.5, 23.0}}) {
            const PathSegment segment = through(scene, place);
            const dvec3 entry(geometry.patientFromIndex * dvec4(dvec3(segment.ray.origin), 1));
            QVERIFY(std::fabs(entry.x - across) < 1e-4 && std::fabs(entry.z - up) < 1e-4);
            QVERIFY(glm::length(segment.direction - vec3(0, 1, 0)) < 1e-6f);
        }
    }

    /// Out of focus a point spreads over a disc of the diameter aperture |1 - depth / focus|: here the rays enter the
    /// volume at a depth of 400 mm, half as far as the sharp plane.
    void lensIsAsWideAsItsDiameter() {
        Scene scene = view(Camera::Type::perspective);
        scene.camera.apertureMm = 12;
        scene.camera.focusMm = 800;
        const VolumeGeometry& geometry = scene.volume->geometry();
        for (const vec2 lens : {vec2(1, 0), vec2(0, 1), vec2(-0.6f, 0.8f)}) {
            const PathSegment segment = through(scene, vec2(100, 40), lens);
            const dvec3 entry(geometry.patientFromIndex * dvec4(dvec3(segment.ray.origin), 1));
            QVERIFY(std::fabs(entry.y) < 1e-3);
            QVERIFY(glm::length(dvec2(entry.x, entry.z) - dvec2(50) - dvec2(lens) * 3.0) < 1e-3);
        }
    }

    /// The depth of tissue under a pixel is measured along the view, as the sharp plane's is, also at the film's edge.
    void depthUnderAPixelIsAlongTheView() {
        Scene scene = view(Camera::Type::perspective);
        scene.transferFunction.extinctionPerMm = 1e4f;
        scene.camera.fovDegrees = 10;  // all of the film shows the volume's face
        for (const ivec2 pixel : {ivec2(100, 40), ivec2(70, 2), ivec2(130, 78)}) {
            const LayersUnder under = layersUnder(*test::prepared(scene), vec2(pixel) + 0.5f);
            QVERIFY(under.seen == SeenAt::place && std::fabs(under.layers[0].depthMm - 400) < 0.01);
        }
    }

    /// A disc: half of its points lie beyond 1 / sqrt(2) of its radius, evenly around.
    void pointsOfALensAreEvenOverTheDisc() {
        test::Sample squared, fourth, across, up;
        for (std::uint64_t i = 0; i < 200'000; ++i) {
            const vec2 point = sampleUniformDisk(Random(3, 1, i).stream(Dimension::lens).pair());
            const double square = glm::dot(dvec2(point), dvec2(point));
            squared.add(square);
            fourth.add(square * square);
            across.add(point.x);
            up.add(point.y);
        }
        const double allowed = test::allowedZ(4);
        QVERIFY(std::fabs(squared.z(1.0 / 2)) < allowed && std::fabs(fourth.z(1.0 / 3)) < allowed);
        QVERIFY(std::fabs(across.z(0)) < allowed && std::fabs(up.z(0)) < allowed);
    }
};

QTEST_GUILESS_MAIN(CameraTest)
#include "camera_test.moc"
