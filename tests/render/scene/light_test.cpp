/// Lights of every kind against their known irradiance, with every way of sampling them.

#include <QTest>

#include "render/kernel/transport/environment.h"
#include "tests/support/scenes/images.h"

using namespace pdr;

namespace {

constexpr int kComparisons = 24;  ///< comparisons in this file: one false alarm in 1e4 runs of all of it

/// A speck of thin isotropic tissue (0.1 mm, optical depth 0.001) about the origin, seen straight on. In light whose
/// radiance, integrated over all directions, is 1 it shows kSpeck.
constexpr double kDepth = 1e-3;
constexpr double kSpeck = 0.8 / (4 * M_PI) * kDepth;

Scene speck() {
    Scene scene =
        test::plainScene(test::makeVolume({3, 3, 3}, dvec3(0.1 / 3), [](int, int, int) { return 0; }), kDepth / 0.1);
    scene.transferFunction.nodes[0].albedo = vec3(0.8f);
    scene.camera = {.type = Camera::Type::orthographic,
                    .eyeMm = {0.05, 0.05, 10},
                    .targetMm = {0.05, 0.05, 0},
                    .up = {0, 1, 0},
                    .heightMm = 0.05};
    scene.film = {16, 16};
    scene.lights.clear();
    return scene;
}

/// Returns the speck's brightness in units of kSpeck. Nearly all samples miss it, so one that hits counts 1 / kDepth.
test::ImageMean lightOn(const Scene& scene) {
    const test::ImageMean got = test::imageMean(test::render(scene, 16384));
    return {got.mean / kSpeck, got.standardError / kSpeck};
}

std::shared_ptr<const EnvironmentImage> image(ivec2 size, std::vector<vec3> texels) {
    return std::make_shared<EnvironmentImage>(EnvironmentImage{size, std::move(texels)});
}

/// Returns rough tissue with shiny surfaces between two large lights: every way of sampling light matters here.
Scene shinyScene() {
    Scene scene = test::plainScene(test::bumpyVolume({40, 30, 30}, dvec3(2), 5), 1);
    scene.transferFunction.nodes = {
        {.hu = 0, .opacity = 0, .albedo = vec3(0.8f)},
        {.hu = 300, .opacity = 1, .albedo = vec3(0.8f), .specular = vec3(0.2f), .roughness = 0.3f}};
    scene.gradientFactor = 1;
    scene.phaseG = 0.6f;
    const dvec3 centre = scene.volume->geometry().centreMm();
    scene.lights = {RectangleLight{centre + dvec3(0, -90, 40), {0, 1, -0.4}, {0, 0, 1}, 150, 100, vec3(3)},
                    SphereLight{centre + dvec3(70, -60, 0), 40, vec3(2)}};
    return scene;
}

test::ImageMean searched(const Scene& scene, bool alongScatter) {
    const auto prepared = test::prepared(scene);
    prepared->flat.sampleDirections = alongScatter;
    return test::imageMean(test::sampled(prepared, 2048));
}

test::ImageMean collected(const Scene& scene, bool alongPath) {
    const auto prepared = test::prepared(scene);
    prepared->flat.lightAlongPath = alongPath;
    return test::imageMean(test::sampled(prepared, 2048));
}

void verifyEqual(test::ImageMean a, test::ImageMean b) {
    const double error = std::hypot(a.standardError, b.standardError);
    QVERIFY2(std::fabs(a.mean - b.mean) < test::allowedZ(kComparisons) * error,
             qPrintable(QString("%1 against %2 +- %3").arg(a.mean).arg(b.mean).arg(error)));
    QVERIFY2(error < 0.01 * a.mean, "the comparison has no power");
}

}  // namespace

class LightTest : public QObject {
    Q_OBJECT

  private slots:
    /// A ball fills the solid angle 2 pi (1 - cos) of its half angle.
    void ballBringsItsSolidAngle() {
        Scene scene = speck();
        scene.lights = {SphereLight{{100, 0.05, 0.05}, 60, vec3(2)}};
        const test::ImageMean got = lightOn(scene);
        const double truth = 2 * 2 * M_PI * (1 - 0.8);
        QVERIFY2(std::fabs(got.mean - truth) < test::allowedZ(kComparisons) * got.standardError + 3e-3 * truth,
                 qPrintable(QString("%1 +- %2, expected %3").arg(got.mean).arg(got.standardError).arg(truth)));
    }

    void insideABallItIsDark() {
        Scene scene = speck();
        scene.lights = {SphereLight{{1, 0, 0}, 60, vec3(2)}};
        QCOMPARE(lightOn(scene).mean, 0.0);
    }

    /// A gradient gives an isotropic speck its mean over the sphere.
    void gradientBringsItsMean() {
        Scene scene = speck();
        scene.environment = {vec3(3), false, vec3(1)};
        const test::ImageMean got = lightOn(scene);
        QVERIFY(std::fabs(got.mean - 4 * M_PI * 2) <
                test::allowedZ(kComparisons) * got.standardError + 3e-3 * 4 * M_PI * 2);
    }

    void imageBringsTheLightOfItsTexels() {
        Scene scene = speck();
        std::vector<vec3> texels(8 * 4, vec3(0));
        texels[1 * 8 + 5] = vec3(30);
        texels[3 * 8 + 2] = vec3(7);
        scene.environment = {vec3(1), false, {}, image({8, 4}, texels), 25};
        const double upper = 2 * M_PI / 8 * (std::cos(M_PI / 4) - 0),
                     lower = 2 * M_PI / 8 * (std::cos(3 * M_PI / 4) + 1);
        const double truth = 30 * upper + 7 * lower;
        const test::ImageMean got = lightOn(scene);
        QVERIFY2(std::fabs(got.mean - truth) < test::allowedZ(kComparisons) * got.standardError + 3e-3 * truth,
                 qPrintable(QString("%1 +- %2, expected %3").arg(got.mean).arg(got.standardError).arg(truth)));
    }

    /// The image's middle lies towards the back, its right half on the patient's left, row 0 towards the head.
    void imageLiesAboutThePatientAsDocumented() {
        std::vector<vec3> texels;
        for (int i = 0; i < 16; ++i)
            texels.push_back(vec3(float(i)));
        Scene scene = speck();
        scene.environment = {vec3(1), true, {}, image({4, 4}, texels)};
        const auto at = [&](vec3 direction) {
            return environmentRadiance(test::prepared(scene)->flat.environment, glm::normalize(direction)).x;
        };
        QCOMPARE(at({0, 0, 1}) < 4, true);       // the first row
        QCOMPARE(at({0.1f, 1, 0.2f}), 6.0f);     // row 1, just right of the middle
        QCOMPARE(at({-0.1f, 1, -0.2f}), 9.0f);   // row 2, just left of it
        QCOMPARE(at({-0.1f, -1, 0.2f}), 4.0f);   // straight ahead of the patient: the left edge
        QCOMPARE(at({0.1f, -1, 0.2f}), 7.0f);    // and the right edge
        scene.environment.rotationDegrees = 90;  // what lay at the back now lies at the left
        QCOMPARE(at({1, -0.1f, 0.2f}), 6.0f);
    }

    void samplesOfAnImageHaveTheDensityThatIsSaid() {
        std::mt19937 random(3);
        std::uniform_real_distribution<float> u(0, 1);
        std::vector<vec3> texels(24 * 12);
        for (vec3& texel : texels)
            texel = vec3(u(random) < 0.3f ? 0 : std::exp(4 * u(random)));
        Scene scene = speck();
        scene.environment = {vec3(1), true, {}, image({24, 12}, texels), 10};
        const auto prepared = test::prepared(scene);
        const FlatEnvironment& flat = prepared->flat.environment;
        // Every found direction lies in its texel and has its density; the mean of 1 / density is the lit solid angle.
        test::Sample solidAngle;
        double lit = 0;
        for (int row = 0; row < 12; ++row)
            for (int column = 0; column < 24; ++column)
                if (texels[row * 24 + column].x > 0)
                    lit += 2 * M_PI / 24 * (std::cos(M_PI * row / 12) - std::cos(M_PI * (row + 1) / 12));
        int elsewhere = 0;
        for (int i = 0; i < 200000; ++i) {
            const LightSample sample = sampleEnvironment(flat, {u(random), u(random)}, {u(random), u(random)});
            elsewhere += environmentPdf(flat, sample.wi) != sample.pdf;
            solidAngle.add(1 / sample.pdf);
        }
        QVERIFY(elsewhere < 20);  // rounding at a texel's edge
        QVERIFY(std::fabs(solidAngle.z(lit)) < test::allowedZ(kComparisons));
    }

    /// Each way of sampling light alone, and both together, give the same image.
    void searchAlongScatteringDoesNotChangeTheImage() {
        const Scene scene = shinyScene();
        verifyEqual(searched(scene, true), searched(scene, false));
    }

    void searchForAnImageDoesNotChangeTheImage() {
        Scene scene = shinyScene();
        std::vector<vec3> texels(16 * 8, vec3(0.2f));
        texels[2 * 16 + 2] = vec3(20);
        scene.environment = {vec3(1), false, {}, image({16, 8}, texels)};
        verifyEqual(searched(scene, true), searched(scene, false));
    }

    void lightAlongThePathIsWhatEventsWouldLookFor_data() {
        QTest::addColumn<int>("maxBounces");
        QTest::addColumn<bool>("skyImage");
        QTest::addColumn<bool>("cut");
        QTest::addColumn<RayOrigin>("rayOrigin");
        QTest::newRow("2 events") << 2 << false << false << RayOrigin::event;
        QTest::newRow("3 events, image of a sky") << 3 << true << false << RayOrigin::event;
        QTest::newRow("many events") << 1000 << false << false << RayOrigin::event;
        QTest::newRow("many events, image of a sky, cut") << 1000 << true << true << RayOrigin::event;
        QTest::newRow("4 events from outside the edge") << 4 << false << false << RayOrigin::outsideEdge;
    }
    /// Events sample light along their scattering, or the path collects it there: both give the same image. One of the
    /// lights stands in the tissue: paths meet it on their way to an event, or end before it.
    void lightAlongThePathIsWhatEventsWouldLookFor() {
        QFETCH(int, maxBounces);
        QFETCH(bool, skyImage);
        QFETCH(bool, cut);
        QFETCH(RayOrigin, rayOrigin);
        Scene scene = shinyScene();
        scene.rayOrigin = rayOrigin;
        const dvec3 centre = scene.volume->geometry().centreMm();
        scene.model = Model::multipleScattering;
        scene.maxBounces = maxBounces;
        scene.film = {16, 16};
        scene.transferFunction.extinctionPerMm = 0.1f;
        scene.lights.push_back(SphereLight{centre + dvec3(10, 5, 0), 6, vec3(4)});
        scene.environment = {vec3(0.5f), false, vec3(0.1f)};
        if (skyImage) {
            std::vector<vec3> texels(16 * 8, vec3(0.2f));
            texels[2 * 16 + 2] = vec3(20);
            scene.environment = {vec3(1), false, {}, image({16, 8}, texels)};
        }
        if (cut)
            scene.clip.planes = {{centre + dvec3(0, 0, 12), {0, 0.3, 1}}};
        verifyEqual(collected(scene, true), collected(scene, false));
    }

    /// Tissue that was cut away may still cast its shadow, which paths do not meet: there events sample light
    /// themselves.
    void lightAlongThePathIsNotCollectedThroughShadowsOfWhatWasCutAway() {
        Scene scene = shinyScene();
        scene.model = Model::multipleScattering;
        scene.clip.planes = {{scene.volume->geometry().centreMm(), {0, 0.3, 1}}};
        QVERIFY(test::prepared(scene)->flat.lightAlongPath);
        scene.clip.shadows = true;
        QVERIFY(!test::prepared(scene)->flat.lightAlongPath);
        scene.clip = {};
        scene.unshadowed = true;
        QVERIFY(!test::prepared(scene)->flat.lightAlongPath);
    }

    /// Lights in view in front of the tissue, behind it, and inside it: the tissue takes exp(-depth) of their light.
    void lightInViewIsSeenThroughWhatLiesBeforeIt() {
        for (const auto& [z, depth] : {std::pair{60.0, 0.0}, {-60.0, 1.2}, {5.0, 0.6}}) {
            Scene scene = test::slab(1.2, {0, 0, -1}, 0);
            scene.film = {16, 16};
            scene.lights = {RectangleLight{{200.5, 200.5, z}, {0, 0, 1}, {0, 1, 0}, 5, 5, vec3(3), true}};
            const Film film = test::render(scene, 1024);
            const test::ImageMean got = test::imageMean(film);
            QVERIFY2(std::fabs(got.mean - 3 * std::exp(-depth)) <= test::allowedZ(kComparisons) * got.standardError,
                     qPrintable(QString("%1 +- %2 at %3").arg(got.mean).arg(got.standardError).arg(z)));
        }
    }

    /// A light that fills half the width of the image at 1e7 mm is seen where it is.
    void lightInViewIsSeenFromFarAway() {
        Scene scene = test::slab(1, {0, 0, -1}, 0);
        scene.camera.eyeMm.z = 1e7;
        scene.camera.heightMm = 40;
        scene.film = {40, 40};
        scene.lights = {SphereLight{{200.5, 200.5, 100}, 10, vec3(1), true}};
        const test::ImageMean got = test::imageMean(test::render(scene, 64));
        QVERIFY2(std::fabs(got.mean - M_PI * 100 / 1600) < 5 * got.standardError,
                 qPrintable(QString("%1 +- %2").arg(got.mean).arg(got.standardError)));
    }
};

QTEST_GUILESS_MAIN(LightTest)
#include "light_test.moc"
