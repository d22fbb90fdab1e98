/// Hard cases 61 to 64: a sun in an image, light at the very place of an event, lights of next to no size, and normals
/// in voxels of unlike sides. Each naive form is written out and must fail.

#include <QTest>

#include <random>

#include "render/kernel/transport/integrator.h"
#include "tests/physics/gauss_legendre.h"
#include "tests/support/scenes/images.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

/// Cuboids of thin tissue about the origin, 0.1 mm high, seen straight from above; optical depth kDepth.
constexpr double kDepth = 0.01, kAlbedo = 0.8;

Scene speck(float g) {
    Scene scene =
        test::plainScene(test::makeVolume({4, 4, 4}, dvec3(0.025), [](int, int, int) { return 0; }), kDepth / 0.1);
    scene.transferFunction.nodes[0].albedo = vec3(float(kAlbedo));
    scene.phaseG = g;
    scene.camera = {.type = Camera::Type::orthographic,
                    .eyeMm = {0.05, 0.05, 10},
                    .targetMm = {0.05, 0.05, 0},
                    .up = {0, 1, 0},
                    .heightMm = 0.05};
    scene.film = {16, 16};
    scene.lights.clear();
    return scene;
}

/// A slab's radiance straight upwards per radiance that comes from all directions at height z (-1 ... 1), isotropic.
double slabShows(double tau, double z) {
    const double a = std::fabs(z), strength = kAlbedo / (4 * M_PI);
    if (z > 0)
        return strength * a / (1 + a) * -std::expm1(-tau * (1 + 1 / a));
    return strength * a / (1 - a) * (std::exp(-tau) - std::exp(-tau / a));
}

/// Returns slabShows() integrated over heights from `low` to `high` and `turn` radians around.
double slabShows(double tau, double low, double high, double turn) {
    double sum = 0;
    for (const test::QuadraturePoint& point : test::gaussLegendre(48))
        sum += point.weight * slabShows(tau, low + (high - low) * point.at);
    return sum * (high - low) * turn;
}

vec2 pair(std::mt19937& random) {
    std::uniform_real_distribution<float> u(0x1p-24f, 1 - 0x1p-24f);
    return {u(random), u(random)};
}

void verify(test::ImageMean got, double truth, double finds) {
    const double allowed = test::allowedZ(12);
    QVERIFY2(std::fabs(got.mean - truth) < allowed * got.standardError + 2e-6 * truth,
             qPrintable(QString("%1 +- %2, expected %3").arg(got.mean).arg(got.standardError).arg(truth)));
    QVERIFY2((allowed + 1.2816) * got.standardError < finds * truth, "the comparison has no power");
}

}  // namespace

class LightLimitsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Case 61. A sun of one texel, a million times as bright as its sky: directions that are strewn evenly meet it
    /// twice in 4096, and samples that are cut at 1000 forget it.
    void sunInAnImageIsMetByChance_data() {
        QTest::addColumn<int>("row");
        QTest::newRow("high") << 7;
        QTest::newRow("at the zenith") << 0;
        QTest::newRow("at the nadir") << 31;
    }
    void sunInAnImageIsMetByChance() {
        QFETCH(int, row);
        const ivec2 size(64, 32);
        const int column = 21;
        const double tau = 1.5, bright = 1e6, wide = 2 * M_PI / size.x;
        const auto height = [&](int border) { return std::cos(M_PI * border / size.y); };
        double sky = -slabShows(tau, height(row + 1), height(row), wide);
        for (int i = 0; i < size.y; ++i)
            sky += slabShows(tau, height(i + 1), height(i), 2 * M_PI);
        const double truth = sky + bright * slabShows(tau, height(row + 1), height(row), wide);

        std::mt19937 random(61);
        test::Sample naive, cut;
        for (int i = 0; i < 4096; ++i) {
            const vec2 u = pair(random);
            const double z = 1 - 2 * u.x;
            const bool met = z <= height(row) && z > height(row + 1) && int(u.y * size.x) == column;
            const double value = 4 * M_PI * slabShows(tau, z) * (met ? bright : 1);
            naive.add(value);
            cut.add(std::min(value, 1000.0));
        }
        QVERIFY(naive.standardError() > 0.3 * truth || naive.mean() < 0.1 * truth);
        QVERIFY(cut.mean() < 0.1 * truth);

        std::vector<vec3> texels(std::size_t(size.x) * size.y, vec3(1));
        texels[std::size_t(row) * size.x + column] = vec3(float(bright));
        Scene scene = test::slab(tau, {0, 0, -1}, float(kAlbedo));
        scene.lights.clear();
        scene.environment = {vec3(1), false, {}, std::make_shared<EnvironmentImage>(EnvironmentImage{size, texels})};
        scene.film = {8, 8};
        for (const float scale : {1.0f, 1e-6f}) {
            scene.environment.radiance = vec3(scale);
            const Film film = test::render(scene, 6144);
            QVERIFY(film.status().health.perfect());
            verify(test::imageMean(film), scale * truth, 0.02);
        }
    }

    /// Case 62. Where a light's place and an event's are the same number there is no direction between them.
    void lightOnTheEventHasNoDirection() {
        QVERIFY(std::isnan(vec3(0).x / glm::length(vec3(0))));
        FlatLight panel{.type = LightType::rectangle, .radiance = vec3(1)};
        panel.normal = {0, 0, 1};
        panel.halfU = {1, 0, 0};
        panel.halfV = {0, 1, 0};
        panel.area = 4;
        FlatLight ball{.type = LightType::sphere, .radiance = vec3(1)};
        ball.radius = 0.25f;
        std::mt19937 random(62);
        for (int i = 0; i < 2000; ++i) {
            const vec2 u = i == 0 ? vec2(0.5f) : pair(random);
            const vec3 onPanel = panel.halfU * (2 * u.x - 1) + panel.halfV * (2 * u.y - 1);
            QCOMPARE(sampleRectangle(panel, onPanel, u).radiance.x, 0.0f);
            QCOMPARE(sampleRectangle(panel, -onPanel, u).radiance.x, 0.0f);  // elsewhere in its plane
            QCOMPARE(sampleSphere(ball, vec3(0), u).radiance.x, 0.0f);
            QCOMPARE(sampleSphere(ball, {0.25f, 0, 0}, u).radiance.x, 0.0f);  // on it
            const LightSample beside = sampleSphere(ball, {std::nextafter(0.25f, 1.0f), 0, 0}, u);
            QVERIFY(std::fabs(beside.radiance.x / (2 * kPi) - 1) < 1e-3f);  // half of all directions
            QVERIFY(beside.distance >= 0 && beside.distance < 1e-3f);
        }
        Scene scene = speck(0);
        scene.lights = {SphereLight{{0.05, 0.05, 0.05}, 0.1, vec3(1)}};  // all of the speck is inside
        const Film film = test::render(scene, 1024);
        QVERIFY(film.status().health.perfect());
        QCOMPARE(test::imageMean(film).mean, 0.0);
    }

    /// Case 62. A panel in the middle of the tissue: what lies above it sees nothing else below. Points strewn over the
    /// panel are too far away, nearly all of them.
    void panelInTheTissueIsLostToItsOwnSize() {
        const float g = 0.5f;
        const double onwards = (1 - g * g) / (2 * g) * (1 / (1 - g) - 1 / std::sqrt(1 + g * g));
        const double truth = kAlbedo * onwards * -std::expm1(-kDepth / 2);
        FlatLight panel{.type = LightType::rectangle, .radiance = vec3(1)};
        panel.normal = {0, 0, 1};
        panel.halfU = {1000, 0, 0};
        panel.halfV = {0, 1000, 0};
        panel.area = 4e6;
        std::mt19937 random(63);
        test::Sample naive;
        for (int i = 0; i < 100'000; ++i) {
            const LightSample sample = sampleRectangle(panel, {0, 0, 0.05f * pair(random).x}, pair(random));
            naive.add(sample.radiance.x * phaseEval(g, {0, 0, 1}, sample.wi));
        }
        QVERIFY2(naive.mean() < 0.5 * onwards, qPrintable(QString::number(naive.mean())));
        Scene scene = speck(g);
        scene.lights = {RectangleLight{{0.05, 0.05, 0.05}, {0, 0, 1}, {0, 1, 0}, 2000, 2000, vec3(1)}};
        const Film film = test::render(scene, 16384);
        QVERIFY(film.status().health.perfect());
        verify(test::imageMean(film), truth, 0.06);
    }

    /// Case 63. Of no size: refused. Of next to none: the light of a point that sends out as much.
    void lightOfNoSizeIsBlackOrInfinite() {
        QCOMPARE(1 - std::sqrt(1 - 1e-11f * 1e-11f), 0.0f);  // the solid angle of such a ball
        for (const double size : {0.0, -0.0, -1e-9, double(NAN), double(INFINITY)}) {
            QVERIFY(!check(RectangleLight{.widthMm = size}) && !check(RectangleLight{.heightMm = size}));
            QVERIFY(!check(SphereLight{.radiusMm = size}));
        }
        const double truth = kAlbedo / (4 * M_PI) * -std::expm1(-kDepth);
        for (const double size : {1e-3, 1e-9}) {
            const float radiance = float(100 * 100 / (size * size));  // irradiance 1 from 100 mm
            Scene scene = speck(0);
            const dvec3 above(0.05, 0.05, 100.05);
            for (const Light& light :
                 {Light(SphereLight{above, size, vec3(radiance / float(M_PI))}),
                  Light(RectangleLight{above, {0, 0, -1}, {0, 1, 0}, size, size, vec3(radiance)}),
                  Light(RectangleLight{above, {0, 0, -1}, {0, 1, 0}, size * 1e3, size / 1e3, vec3(radiance)})}) {
                scene.lights = {light};
                QVERIFY(bool(scene.check()));
                const Film film = test::render(scene, 2048);
                QVERIFY(film.status().health.perfect());
                const test::ImageMean got = test::imageMean(film);
                // Half the speck lies 0.05 mm nearer than its middle; on its way light loses half of the depth.
                QVERIFY2(std::fabs(got.mean - truth) < test::allowedZ(12) * got.standardError + 0.01 * truth,
                         qPrintable(QString("%1 +- %2, expected %3").arg(got.mean).arg(got.standardError).arg(truth)));
                QVERIFY(got.standardError < 0.02 * truth);
            }
        }
    }

    /// Case 64. A matt slope in voxels of 0.3 x 0.3 x 3 mm: a normal that is made of differences alone, without the
    /// voxels' sides, leans to where the voxels are long.
    void normalForgetsTheSpacing() {
        const dvec3 spacing(0.3, 0.3, 3), normal = glm::normalize(dvec3(0.6, 0.2, 0.7));
        const dvec3 naive = glm::normalize(normal * spacing);
        const dvec3 toViewer(0, 0, 1), toLight = glm::normalize(dvec3(0.7, -0.1, 0.7)), centre(6, 6, 15);
        const auto shown = [&](dvec3 n) {  // only the cosine of the reflection is by n: shadows are the tissue's
            return kAlbedo / M_PI * std::max(0.0, glm::dot(n, toLight)) * glm::dot(normal, toLight) /
                   (glm::dot(normal, toLight) + glm::dot(normal, toViewer));
        };
        QVERIFY(glm::length(normal - naive) > 0.5 && std::fabs(shown(naive) / shown(normal) - 1) > 0.2);
        const auto hu = [&](int i, int j, int k) {
            return std::lround(1000 - 200 * glm::dot(normal, (dvec3(i, j, k) + 0.5) * spacing - centre));
        };
        Scene scene = test::plainScene(test::makeVolume({40, 40, 10}, spacing, hu), 400);
        scene.transferFunction.nodes = {{.hu = 1000, .opacity = 0},
                                        {.hu = 1000, .opacity = 1, .albedo = vec3(float(kAlbedo))}};
        scene.gradientFactor = 100;
        scene.lights = {DirectionalLight{-toLight, vec3(1)}};
        scene.camera = {.type = Camera::Type::orthographic,
                        .eyeMm = centre + toViewer * 50.0 + dvec3(0.11, 0.07, 0),
                        .targetMm = centre + dvec3(0.11, 0.07, 0),
                        .up = {0, 1, 0},
                        .heightMm = 1};
        scene.film = {8, 8};
        const test::ImageMean got = test::imageMean(test::render(scene, 4096));
        verify(got, shown(normal), 0.03);
        QVERIFY(std::fabs(got.mean - shown(naive)) > 20 * got.standardError);
    }
};

QTEST_GUILESS_MAIN(LightLimitsTest)
#include "light_limits_test.moc"
