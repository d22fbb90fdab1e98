/// Hard cases 44 to 51: lights and shadows. Each naive form is written out and must fail.

#include <QTest>

#include <random>

#include "render/kernel/transport/integrator.h"
#include "render/prepare/environment_tables.h"
#include "tests/support/scenes/images.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

/// The middle of tests' slab: 10 mm thick, its faces at z = 0 and 10.
const dvec3 kMiddle(200.5, 200.5, 5);

std::shared_ptr<const EnvironmentImage> image(ivec2 size, std::vector<vec3> texels) {
    return std::make_shared<EnvironmentImage>(EnvironmentImage{size, std::move(texels)});
}

FlatLight panelLight(float width, float height, vec3 radiance) {
    FlatLight light{.type = LightType::rectangle, .radiance = radiance};
    light.normal = {0, 0, 1};
    light.halfU = {width / 2, 0, 0};
    light.halfV = {0, height / 2, 0};
    light.area = width * height;
    return light;
}

vec2 pair(std::mt19937& random) {
    std::uniform_real_distribution<float> u(0x1p-24f, 1 - 0x1p-24f);
    return {u(random), u(random)};
}

/// Mean of what samples of the light bring, from `place` (from its centre); all must be finite and not negative.
double brought(const FlatLight& light, vec3 place) {
    std::mt19937 random(5);
    double sum = 0;
    for (int i = 0; i < 4000; ++i) {
        const LightSample sample = light.type == LightType::sphere ? sampleSphere(light, place, pair(random))
                                                                   : sampleRectangle(light, place, pair(random));
        if (!(sample.radiance.x >= 0 && std::isfinite(sample.radiance.x)))
            return NAN;
        sum += sample.radiance.x / 4000;
    }
    return sum;
}

/// Hill's estimate of the tail index from the 1 % largest: below 2 the variance is infinite.
double tailIndex(std::vector<double> values) {
    std::sort(values.begin(), values.end(), std::greater<>());
    const std::size_t k = values.size() / 100;
    double sum = 0;
    for (std::size_t i = 0; i < k; ++i)
        sum += std::log(values[i] / values[k]);
    return double(k) / sum;
}

}  // namespace

class LightsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 44. A light seen through the tissue before it: not through all of it, and not through none.
    void lightInsideTheMediumIsComposedBehindIt() {
        const auto naive = [](double tau) { return 3 * std::exp(-tau); };
        for (const auto& [z, depth] : {std::pair{60.0, 0.0}, {9.0, 0.12}, {5.0, 0.6}, {1.0, 1.08}, {-60.0, 1.2}})
            for (const bool ball : {false, true}) {
                Scene scene = test::slab(1.2, {0, 0, -1}, 0);
                const dvec3 centre(200.5, 200.5, z);
                scene.lights = {RectangleLight{centre, {0, 0, 1}, {0, 1, 0}, 5, 5, vec3(3), true}};
                if (ball)  // its nearest point is there; the film sees 0.01 mm about it
                    scene.lights = {SphereLight{centre - dvec3(0, 0, 40), 40, vec3(3), true}};
                scene.camera.heightMm = 0.01;
                const Film film = test::render(scene, 4096);
                const double truth = 3 * std::exp(-depth);
                const test::ImageMean got = test::imageMean(film);
                QVERIFY2(std::fabs(got.mean - truth) <= test::allowedZ(10) * got.standardError + 1e-6,
                         qPrintable(QString("%1 +- %2 at %3").arg(got.mean).arg(got.standardError).arg(z)));
                QVERIFY(z < 0 || std::fabs(got.mean - naive(1.2)) > 5 * got.standardError);
            }
    }

    /// Case 45. d^2 / (cos A) edge-on, behind, and exactly in the panel's plane.
    void panelSeenEdgeOnHasInfiniteDensity() {
        QVERIFY(std::isinf(25.0f / (0.0f * 100.0f)));
        const FlatLight panel = panelLight(10, 10, vec3(1));
        QCOMPARE(brought(panel, {20, 0, 0}), 0.0);   // in its plane
        QCOMPARE(brought(panel, {0, 0, 0}), 0.0);    // on it
        QCOMPARE(brought(panel, {0, 0, -20}), 0.0);  // behind
        QVERIFY(brought(panel, {20, 0, 1e-30f}) < 1e-20);
        for (const float facing : {0.0f, -0.0f, 1e-45f, 1e-38f, 1e-20f, -1e-20f}) {
            const LightHit hit = intersectRectangle(panel, vec3(20, 0, 1), vec3(-1, 0, -facing));
            // Met or not, what is found along such a ray counts for nothing beside the panel's own samples.
            QVERIFY(!hit.met || powerHeuristic(1.0f, hit.pdf) < 1e-12f);
        }
        Scene scene = test::slab(1, {0, 0, -1}, 1);
        for (const dvec3 centre : {kMiddle, dvec3(200.5, 200.5, 60), dvec3(260, 200.5, 5)}) {
            scene.lights = {RectangleLight{centre, {0, 0, 1}, {0, 1, 0}, 20, 20, vec3(1)}};
            QVERIFY(test::render(scene, 64).status().health.perfect());
        }
        scene.lights = {RectangleLight{kMiddle, {0, 0, 1}, {0, 1, 0}, 20, 20, vec3(1)}};
        QVERIFY(test::imageMean(test::render(scene, 64)).mean > 0);  // it lights what lies above its plane
        scene.lights = {RectangleLight{{200.5, 200.5, 60}, {0, 0, 1}, {0, 1, 0}, 20, 20, vec3(1)}};
        QCOMPARE(test::imageMean(test::render(scene, 64)).mean, 0.0);  // shines away from it
        for (const double size : {0.0, -1.0, double(NAN)})
            QVERIFY(!check(RectangleLight{.widthMm = size}) && !check(SphereLight{.radiusMm = size}));
    }

    /// Case 46. A point of light in the tissue: 1 / r^2 has infinite variance. Lights here have a size, and no sample
    /// brings more than all directions full of them.
    void pointLightInTheMediumHasInfiniteVariance() {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> place(-3, 3);
        std::vector<double> naive;
        FlatLight ball{.type = LightType::sphere, .radiance = vec3(1)};
        ball.radius = 0.05f;
        const FlatLight panel = panelLight(0.1f, 0.1f, vec3(1));
        double most = 0;
        for (int i = 0; i < 200'000; ++i) {
            const vec3 p(place(random), place(random), place(random));
            naive.push_back(1 / double(glm::dot(p, p)));
            const float bright = sampleSphere(ball, p, pair(random)).radiance.x;
            QVERIFY(std::isfinite(bright) && std::isfinite(sampleRectangle(panel, p, pair(random)).radiance.x));
            most = std::max(most, double(bright));
        }
        QVERIFY2(tailIndex(naive) < 1.8, qPrintable(QString::number(tailIndex(naive))));
        QVERIFY(most <= 2 * M_PI * 1.000001);
        // In the image: of two halves of the samples each knows the other's error.
        Scene scene = test::slab(2, {0, 0, -1}, 1);
        scene.lights = {SphereLight{kMiddle, 0.05, vec3(1e4)}};
        const auto device = test::testedDevice();
        scene.film = {8, 8};
        const Film one = test::render(scene, 4096, *device);
        scene.seed = 2;
        const Film two = test::render(scene, 4096, *device);
        const double ratio = one.status().relativeError / two.status().relativeError;
        QVERIFY2(ratio > 0.8 && ratio < 1.25, qPrintable(QString::number(ratio)));
        QVERIFY(one.status().health.perfect() && one.status().meanLuminance > 0);
    }

    /// Case 47. Far away, next to the tissue, dark, blinding: 1 - sqrt(1 - sin^2) of a small or far ball is 0.
    void farBallHasNoSolidAngle() {
        QCOMPARE(1 - std::sqrt(1 - 1e-18f), 0.0f);
        for (const float distance : {2.0f, 1e3f, 1e9f})
            for (const float radius : {1.0f, 1e-3f}) {
                FlatLight ball{.type = LightType::sphere, .radiance = vec3(1)};
                ball.radius = radius;
                const double sine = double(radius) / distance;
                const double solidAngle = 2 * M_PI * sine * sine / (1 + std::sqrt(1 - sine * sine));
                QVERIFY(std::fabs(brought(ball, {0, 0, distance}) / solidAngle - 1) < 1e-5);
            }
        QVERIFY(std::fabs(brought(panelLight(2, 3, vec3(1)), {0, 0, 1e9f}) / 6e-18 - 1) < 1e-5);
        // Over the middle of a square of side 20: 4 asin(100 / (100 + h^2)), all below it where it is touched.
        for (const float height : {20.0f, 5.0f}) {
            const double solidAngle = 4 * std::asin(100 / (100 + double(height) * height));
            QVERIFY(std::fabs(brought(panelLight(20, 20, vec3(1)), {0, 0, height}) / solidAngle - 1) < 0.05);
        }
        const double touching = brought(panelLight(20, 20, vec3(1)), {0, 0, 1e-6f});
        QVERIFY(touching >= 0 && touching < 2 * M_PI);  // points so near are hardly ever met: never too much
        QCOMPARE(glm::length(dvec3(1e-200)), 0.0);
        for (const double length : {1e-300, 1e-200, 1e-160, 1e-90, 1.0, 1e90, 1e200}) {
            const bool usable = length >= 1e-90 && length <= 1e90;
            QCOMPARE(bool(check(DirectionalLight{.direction = dvec3(1, -2, 3) * length})), usable);
        }
        for (const float radiance : {0.0f, 1e-30f, 1e30f}) {
            Scene scene = test::slab(1, {0, 0, -1}, 1);
            scene.lights = {DirectionalLight{{0, 0, -1}, vec3(radiance)},
                            SphereLight{{200.5, 200.5, 1e9}, 1e8, vec3(radiance)}};
            QVERIFY(bool(scene.check()));
            const Film film = test::render(scene, 1024);
            QVERIFY(film.status().health.perfect());
            // Straight light and a ball that fills the cosines 1 ... sqrt(0.99), as good as straight.
            const double straight = 1 + 2 * M_PI * (1 - std::sqrt(0.99));
            const double truth = radiance * straight / (4 * M_PI) * 0.5 * -std::expm1(-2.0);
            const test::ImageMean got = test::imageMean(film);
            QVERIFY(std::fabs(got.mean - truth) <= test::allowedZ(3) * got.standardError + 1e-3 * truth);
            QVERIFY(got.standardError <= 0.02 * truth);
        }
    }

    /// Case 47. No light at all, and ten thousand that together are one.
    void tenThousandLightsAreOneTooFew() {
        Scene scene = test::slab(1, {0, 0, -1}, 0.8f);
        scene.lights.clear();
        QCOMPARE(test::imageMean(test::render(scene, 16)).mean, 0.0);
        for (int i = 0; i < 10'000; ++i)  // each another brightness; the sum is 2
            scene.lights.push_back(DirectionalLight{{0, 0, -1}, vec3(float((i % 100 + 0.5) * 4e-6))});
        const Film film = test::render(scene, 256);
        QVERIFY(std::fabs(test::z(film, 0.8 / (4 * M_PI) * -std::expm1(-2.0))) < test::allowedZ(1));
    }

    /// Case 48. Black, one texel, all light in one texel at a pole; texels that are no light are refused.
    void blackSurroundingsDivideByZero_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        QTest::addColumn<int>("bright");
        QTest::newRow("black") << 8 << 4 << -1;
        QTest::newRow("one texel") << 1 << 1 << 0;
        QTest::newRow("at the zenith") << 16 << 64 << 3;
        QTest::newRow("at the nadir") << 16 << 64 << 16 * 64 - 1;
    }
    void blackSurroundingsDivideByZero() {
        QFETCH(int, width);
        QFETCH(int, height);
        QFETCH(int, bright);
        QVERIFY(std::isnan(0.0f / 0.0f));       // a black table's share
        QCOMPARE(std::sin(0.0f) * 1e6f, 0.0f);  // a pole's weight by its sine
        std::vector<vec3> texels(std::size_t(width) * height, vec3(bright < 0 ? 0 : 1));
        if (bright >= 0)
            texels[std::size_t(bright)] = vec3(1e6f);
        Scene scene = test::slab(1, {0, 0, -1}, 0.8f);
        scene.lights.clear();
        scene.environment = {vec3(1), true, {}, image({width, height}, texels)};
        QVERIFY(bool(scene.environment.image->check()));
        const auto prepared = test::prepared(scene);
        const FlatEnvironment& flat = prepared->flat.environment;
        double whole = 0, expectedBright = 0;
        for (int i = 0; i < width * height; ++i) {
            const int row = i / width;
            const double fraction =
                flat.pdf[i] * 2 * M_PI / width * (std::cos(M_PI * row / height) - std::cos(M_PI * (row + 1) / height));
            whole += fraction;
            expectedBright += i == bright ? fraction : 0;
        }
        QVERIFY(std::fabs(whole - (bright < 0 ? 0 : 1)) < 1e-4);
        std::mt19937 random(9);
        double found = 0;
        for (int i = 0; i < 20'000; ++i) {
            const LightSample sample = sampleEnvironment(flat, pair(random), pair(random));
            QVERIFY(std::isfinite(sample.radiance.x) && std::fabs(glm::length(sample.wi) - 1) < 1e-5f);
            QCOMPARE(sample.radiance == vec3(0), bright < 0);
            found += bright >= 0 && sample.pdf == flat.pdf[bright];
        }
        const double spread = std::sqrt(20'000 * expectedBright * (1 - expectedBright));
        QVERIFY(std::fabs(found - 20'000 * expectedBright) <= test::allowedZ(4) * spread + 1e-9);
        QVERIFY(test::render(scene, 64).status().health.perfect());
        QVERIFY(!image({2, 1}, {vec3(1), vec3(NAN)})->check() && !image({1, 1}, {vec3(-1)})->check());
    }

    /// Case 48. An image turned by very many turns: as a float the angle is infinite, and its texel lies nowhere.
    void turnedImageIsReadBesideItsTexels() {
        QVERIFY(std::isinf(float(glm::radians(1e300))));
        std::vector<vec3> texels;
        for (int i = 0; i < 32; ++i)
            texels.push_back(vec3(float(i + 1)));
        Scene scene = test::slab(1, {0, 0, -1}, 0.8f);
        const auto seen = [&](double degrees) {
            scene.environment = {vec3(1), true, {}, image({8, 4}, texels), degrees};
            const auto prepared = test::prepared(scene);
            return environmentRadiance(prepared->flat.environment, glm::normalize(vec3(0.3f, 0.8f, 0.2f))).x;
        };
        for (const double turns : {1.0, -7.0, 1e6, -1e12})
            QCOMPARE(seen(45 + 360 * turns), seen(45));
        QVERIFY(seen(45) != seen(0));
        for (const double degrees : {1e300, -1e300, 1e17})
            QVERIFY(seen(degrees) >= 1 && seen(degrees) <= 32);
    }

    /// Case 49. Squares of densities overflow; shares of two ways must still add up to 1.
    void squaredDensitiesOverflow() {
        const auto naive = [](float own, float other) { return own * own / (own * own + other * other); };
        QVERIFY(std::isnan(naive(1e38f, 1e38f)) && std::isnan(naive(0, 0)) && std::isnan(naive(1e-30f, 1e-30f)));
        for (const float own : {1e-38f, 1e-30f, 1e-3f, 1.0f, 1e3f, 1e30f, 1e38f})
            for (const float other : {1e-38f, 1e-30f, 1e-3f, 1.0f, 1e3f, 1e30f, 1e38f})
                QVERIFY(std::fabs(powerHeuristic(own, other) + powerHeuristic(other, own) - 1) < 1e-6f);
        QCOMPARE(powerHeuristic(0.0f, 0.0f), 1.0f);  // light that nobody else can find
        QCOMPARE(powerHeuristic(5.0f, 0.0f), 1.0f);
        QCOMPARE(powerHeuristic(5.0f, INFINITY), 0.0f);
    }

    /// Case 50. A shadow march that begins one step of 3 voxels away, so as not to shadow itself, misses that much.
    void shadowThatSkipsItsFirstStepIsTooBright() {
        const double tau = 3, step = 0.6, mu0 = 0.6;  // the step is 3 of 50 voxels of the slab
        std::mt19937 random(3);
        std::exponential_distribution<double> depth(1);
        test::Sample naive;
        for (int i = 0; i < 100'000; ++i) {
            const double d = depth(random);
            naive.add(d < tau ? 0.8 / (4 * M_PI) * 2 * std::exp(-std::max(0.0, d / mu0 - tau * step / 10)) : 0);
        }
        const double truth = 0.8 / (4 * M_PI) * 2 * mu0 / (1 + mu0) * -std::expm1(-tau * (1 + 1 / mu0));
        QVERIFY(naive.mean() / truth > 1.1 && naive.z(truth) > 20);
        const Film film = test::render(test::slab(tau, {0.8, 0, -0.6}, 0.8f), 8192);
        QVERIFY2(std::fabs(test::z(film, truth)) < 4, qPrintable(QString::number(test::z(film, truth))));
    }

    /// Case 51. A ray that stops where 99 % are extinguished lets 1 % of a bright background through, or none.
    void opaqueEnoughLeaksTheBackground() {
        Scene scene = test::slab(6, {0, 0, -1}, 0);
        scene.lights.clear();
        scene.environment = {vec3(1e4f), true};
        const Film film = test::render(scene, 32768);
        const double truth = 1e4 * std::exp(-6.0), leaking = 1e4 * 0.01, opaque = 0;
        QVERIFY(std::fabs(test::z(film, truth)) < test::allowedZ(1));
        QVERIFY(test::z(film, leaking) < -20 && test::z(film, opaque) > 20);
    }
};

QTEST_GUILESS_MAIN(LightsTest)
#include "lights_test.moc"
