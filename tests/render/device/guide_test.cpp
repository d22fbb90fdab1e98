/// A guide shows the scene without shadows and without noise, and where its surfaces are.

#include <QTest>
#include <cmath>

#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

constexpr int kFiner = 4;

/// Returns a scene seen from the front, with one film pixel for four voxels.
Scene seenFromTheFront(std::shared_ptr<const Volume> volume) {
    Scene scene = test::plainScene(std::move(volume), 0.5f);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0, .albedo = vec3(0.8f, 0.5f, 0.2f)},
                                    {.hu = 1000, .opacity = 1, .albedo = vec3(0.8f, 0.5f, 0.2f)}};
    const dvec3 centre = scene.volume->geometry().centreMm();
    scene.camera = {.type = Camera::Type::orthographic,
                    .eyeMm = centre - dvec3(0, 200, 0),
                    .targetMm = centre,
                    .up = {0, 0, 1},
                    .heightMm = 32};
    scene.film = {8, 8};
    return scene;
}

/// Optical depth of the fog from clear on one side to opaque on the other: at column i a ray passes i / kThin.
constexpr double kThin = 15.625;
Scene fog() {
    Scene scene = seenFromTheFront(test::makeVolume({32, 32, 32}, dvec3(1), [](int i, int, int) { return 4 * i; }));
    scene.unshadowed = true;
    return scene;
}

constexpr double kRadius = 13;

Scene ball() {
    return seenFromTheFront(test::makeVolume({32, 32, 32}, dvec3(1), [](int i, int j, int k) {
        const double distance = glm::length(dvec3(i, j, k) - 15.5);
        return std::clamp(1000 * (kRadius - distance), -1000.0, 3000.0);
    }));
}

std::shared_ptr<const denoise::Guide> guideOf(const Scene& scene, int threads = 2) {
    const std::unique_ptr<Device> device = makeCpuDevice(threads);
    (void)device->upload(scene);
    return device->guide({kFiner}, {});
}

}  // namespace

class GuideTest : public QObject {
    Q_OBJECT

  private slots:
    /// The guide and the image agree except for one factor: the brightness of the light does not matter.
    void fogInAGuideIsFogWithoutShadows() {
        Scene fine = fog();
        fine.film *= kFiner;
        const std::unique_ptr<Device> device = makeCpuDevice(2);
        const Film film = test::render(fine, 512, *device);
        const auto guide = guideOf(fog());
        QVERIFY(guide && guide->finer == kFiner && guide->depth.size() == fine.film);
        double sum = 0, squares = 0, pixels = 0;
        for (int y = 4; y < 28; ++y)
            for (int x = 3; x < 11; ++x)
                for (int c = 0; c < 3; ++c) {
                    const double quotient = double(guide->radiance[c].row(y)[x]) / film.pixel(x, y).mean[c];
                    sum += quotient, squares += quotient * quotient, ++pixels;
                }
        const double mean = sum / pixels, spread = std::sqrt(squares / pixels - mean * mean);
        QVERIFY2(spread < 0.03 * mean, qPrintable(QString("%1 of %2").arg(spread).arg(mean)));
    }

    /// Tissue that holds back more than half of the light counts as opaque.
    void opacityIsThatOfTheWholeRay() {
        const auto guide = guideOf(fog());
        for (int x = 2; x < 32; ++x) {
            const double passed = x / kThin, opacity = double(guide->opacity.row(16)[x]);
            QVERIFY2(std::fabs(opacity - (passed > std::log(2.0) ? 1 : -std::expm1(-passed))) < 0.02,
                     qPrintable(QString("%1: %2").arg(x).arg(opacity)));
        }
    }

    void aBallIsSeenWhereItIs() {
        const auto guide = guideOf(ball());
        const float nearest = guide->depth.row(16)[16];
        for (int x = 7; x < 25; ++x) {
            const double aside = x + 0.5 - 16, behind = kRadius - std::sqrt(kRadius * kRadius - aside * aside);
            const double widths = double(guide->depth.row(16)[x] - nearest);
            QVERIFY2(std::fabs(widths - behind / 4) < 0.4, qPrintable(QString("%1 %2").arg(x).arg(widths)));
            const vec3 normal(guide->normal[0].row(16)[x], guide->normal[1].row(16)[x], guide->normal[2].row(16)[x]);
            QVERIFY(glm::length(normal) > 0.9f && normal.y < -0.4f);
            QVERIFY(std::fabs(double(normal.x) - aside / kRadius) < 0.15);
        }
        QCOMPARE(guide->opacity.row(1)[1], 0.0f);
        QCOMPARE(guide->radiance[0].row(1)[1], 0.0f);
    }

    void whatIsBehindTheTissueIsSeenThroughIt() {
        Scene scene = fog();
        scene.environment.radiance = vec3(3);
        scene.environment.visible = true;
        const auto guide = guideOf(scene);
        QVERIFY(std::fabs(guide->radiance[1].row(16)[0] - 3) < 0.1f);
    }

    /// A guide twice as fine has rays through the middles of the quarters of a pixel.
    void raysGoThroughTheirPlaces() {
        const std::unique_ptr<Device> device = makeCpuDevice(2);
        (void)device->upload(ball());
        const auto fine = device->guide({2}, {}), place = device->guide({1, {0.75f, 0.25f}}, {});
        for (int y = 0; y < place->depth.size().y; ++y)
            for (int x = 0; x < place->depth.size().x; ++x) {
                QCOMPARE(place->depth.row(y)[x], fine->depth.row(2 * y)[2 * x + 1]);
                QCOMPARE(place->normal[0].row(y)[x], fine->normal[0].row(2 * y)[2 * x + 1]);
            }
    }

    void threadsChangeNoBit() {
        const auto one = guideOf(ball(), 1), three = guideOf(ball(), 3);
        for (int y = 0; y < one->depth.size().y; ++y) {
            QVERIFY(std::equal(one->depth.row(y), one->depth.row(y) + one->depth.size().x, three->depth.row(y)));
            QVERIFY(std::equal(one->radiance[0].row(y), one->radiance[0].row(y) + one->depth.size().x,
                               three->radiance[0].row(y)));
        }
    }

    void whatAGuideWouldNotShowHasNone() {
        QVERIFY(guideOf(ball()));
        Scene lens = ball();
        lens.camera.apertureMm = 5;
        QVERIFY(!guideOf(lens));
        Scene sum = ball();
        sum.model = Model::emissionAbsorption;
        QVERIFY(!guideOf(sum));
        Scene marched = ball();
        marched.estimator = Estimator::kroesMarch;
        QVERIFY(!guideOf(marched));
        const std::unique_ptr<Device> device = makeCpuDevice(2);
        (void)device->upload(ball());
        std::stop_source stop;
        stop.request_stop();
        QVERIFY(!device->guide({kFiner}, stop.get_token()));
    }
};

QTEST_GUILESS_MAIN(GuideTest)
#include "guide_test.moc"
