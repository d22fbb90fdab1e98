/// The face that a cut leaves in tissue is a plane, whatever noise the scan has.

#include <QTest>
#include <random>

#include "render/kernel/transport/event.h"
#include "render/prepare/needs.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

/// Even tissue of 1000 HU in voxels of 1 mm, with noise, cut at z = 15 mm and seen and lit from above.
Scene block(double noiseHu) {
    std::mt19937 random(11);
    std::normal_distribution<double> noise(0, 1);
    Scene scene = test::plainScene(
        test::makeVolume({24, 24, 24}, dvec3(1), [&](int, int, int) { return 1000 + noiseHu * noise(random); }), 20);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 1, .albedo = vec3(0.8f)}};
    scene.gradientFactor = 4;
    scene.clip.planes = {{{0, 0, 15}, {0, 0, 1}}};
    scene.camera = {.type = Camera::Type::orthographic,
                    .eyeMm = {12, 12, 100},
                    .targetMm = {12, 12, 0},
                    .up = {0, 1, 0},
                    .heightMm = 16};
    scene.lights = {DirectionalLight{{0.6, 0, -0.8}, vec3(2)}};
    return scene;
}

double darkest(const Film& film) {
    double least = 1e30;
    for (int y = 0; y < film.size().y; ++y)
        for (int x = 0; x < film.size().x; ++x)
            least = std::min(least, film.pixel(x, y).mean.x);
    return least;
}

/// A ball of tissue in air, in voxels of 1 mm; its middle is at 15.
Scene ball() {
    return test::plainScene(
        test::makeVolume({30, 30, 30}, dvec3(1),
                         [](int i, int j, int k) { return 1500 - 250 * glm::length(dvec3(i, j, k) - 14.5); }),
        1);
}

bool surfacesNeeded(const Scene& scene) {
    return has(neededFeatures(needs(scene)), kSurface);
}

}  // namespace

class CutFaceTest : public QObject {
    Q_OBJECT

  private slots:
    /// Extinction is so high that only the outermost 0.2 mm are seen: with noise or without, each pixel is lit alike.
    void noiseDoesNotShowInACutFace() {
        const Film noisy = test::render(block(40), 512), even = test::render(block(0), 512);
        const test::ImageMean a = test::imageMean(noisy), b = test::imageMean(even);
        QVERIFY(b.standardError < 0.01 * b.mean);
        QVERIFY(std::fabs(a.mean - b.mean) < test::allowedZ(2) * std::hypot(a.standardError, b.standardError));
        QVERIFY2(darkest(noisy) > 0.6 * b.mean, qPrintable(QString::number(darkest(noisy) / b.mean)));
    }

    /// An optically thick Lambert face in a medium: a/pi E mu0 mu / (mu0 + mu) per unit of irradiance across the beam.
    void aCutFaceIsAsBrightAsASurface() {
        const double cosLight = 0.8, truth = 0.8 / M_PI * 2 * cosLight * cosLight / (cosLight + 1);
        QVERIFY(std::fabs(test::z(test::render(block(0), 512), truth)) < test::allowedZ(1));
    }

    void nearACutTissueFacesWhereThePlaneDoes() {
        Scene scene = block(40);
        scene.clip.planes = {{{0, 0, 15}, {1, 0, 2}}};  // through (0, 0, 15) and (12, 12, 9)
        const auto prepared = test::prepared(scene);
        const auto normal = [&](double z) {
            return normalAt(prepared->flat, prepared->flat.transferFunction, vec3(dvec3(12, 12, z) - 0.5),
                            vec3(0, 0, 1), 1000, 0.5f);
        };
        const vec3 across(glm::normalize(dvec3(1, 0, 2)));
        QVERIFY(glm::length(normal(8.5) - across) < 1e-6f);
        QVERIFY(glm::length(normal(7.9) - across) < 1e-6f);  // 1.1 mm below, 0.98 mm from the plane
        QVERIFY(glm::length(normal(7.5) - across) > 1e-2f);
    }

    /// The plane runs through air: the ball beside it is not cut there.
    void aPlaneInAirTurnsNoSurface() {
        Scene scene = ball();
        scene.transferFunction.nodes = {{.hu = -100, .opacity = 0}, {.hu = 0, .opacity = 1}};
        scene.gradientFactor = 4;
        const vec3 rim(14.5f + 4.0f, 14.5f, 14.5f + 4.4f), up(0, 0, 1);  // 14 HU
        scene.clip.planes = {{{0, 0, 20.3}, {0, 0, 1}}};                 // 0.9 mm above, where it has -160 HU
        const auto near = test::prepared(scene);
        const vec3 normal = normalAt(near->flat, near->flat.transferFunction, rim, up, 14, 0.01f);
        QVERIFY(normal != vec3(0));
        QVERIFY(normal == surfaceNormal(near->flat, near->flat.transferFunction, rim, up, 14, 0.01f));
        scene.clip.planes = {{{0, 0, 19.5}, {0, 0, 1}}};  // 0.1 mm above
        const auto close = test::prepared(scene);
        QVERIFY(normalAt(close->flat, close->flat.transferFunction, rim, up, 14, 0.01f) == up);
    }

    /// Even tissue has no edge but that of the cut.
    void aCutNeedsSurfacesWhereNothingElseDoes() {
        Scene scene = block(0);
        QVERIFY(surfacesNeeded(scene));
        scene.clip = {};
        QVERIFY(!surfacesNeeded(scene));
    }
};

QTEST_APPLESS_MAIN(CutFaceTest)
#include "cut_face_test.moc"
