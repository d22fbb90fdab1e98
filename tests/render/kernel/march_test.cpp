/// The biased march is wrong in exactly the way that is known of it, and right in the limit of small steps.

#include <QTest>

#include "render/kernel/baseline/march.h"
#include "render/kernel/transport/tracking.h"
#include "tests/support/scenes/scenes.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

constexpr float kFar = 1e30f;

RandomStream stream(int i) {
    return Random(23, unsigned(i), 1).stream(0, BounceDimension::distance);
}

/// A slab of 10 mm with its face at t = 0, met straight on.
std::shared_ptr<const PreparedScene> slab(float extinction) {
    return Flattener().prepare(
        test::plainScene(test::makeVolume({10, 8, 8}, dvec3(1), [](int, int, int) { return 5; }), extinction));
}
const Ray kThroughSlab{{-0.5f, 4, 4}, {1, 0, 0}, kFar};

test::Sample marchedTransmittance(const FlatScene& scene, const Ray& ray, float step, int rays) {
    test::Sample result;
    for (int i = 0; i < rays; ++i)
        result.add(marchTransmittance(scene, ray, stream(i), step));
    return result;
}

}  // namespace

class MarchTest : public QObject {
    Q_OBJECT

  private slots:
    /// A slab 2.5 steps thick is met by 2 or 3 samples: T = (exp(-2 s) + exp(-3 s)) / 2 instead of exp(-2.5 s).
    void slabIsTooTransparentByTheKnownPercentage_data() {
        QTest::addColumn<float>("perStep");
        QTest::addColumn<int>("percent");
        QTest::addColumn<int>("rays");
        QTest::newRow("0.5 per step") << 0.5f << 3 << 1000000;
        QTest::newRow("1 per step") << 1.0f << 13 << 1000000;
        QTest::newRow("2 per step") << 2.0f << 54 << 1000000;
        QTest::newRow("5 per step") << 5.0f << 513 << 20000000;
    }
    void slabIsTooTransparentByTheKnownPercentage() {
        QFETCH(float, perStep);
        QFETCH(int, percent);
        QFETCH(int, rays);
        const float step = 4;
        const double wrong = (std::exp(-2.0 * perStep) + std::exp(-3.0 * perStep)) / 2;
        const double truth = std::exp(-2.5 * perStep);
        QCOMPARE(int(std::lround(100 * (wrong / truth - 1))), percent);
        const test::Sample got = marchedTransmittance(slab(perStep / step)->flat, kThroughSlab, step, rays);
        qInfo("%g per step: %+.1f %% (z = %.2f)", double(perStep), 100 * (got.mean() / truth - 1), got.z(wrong));
        QVERIFY(std::fabs(got.z(wrong)) < test::allowedZ(4));
        // The negative control: the test that the unbiased trackers pass must fail here.
        QVERIFY(std::fabs(got.z(truth)) > test::allowedZ(4));
    }

    void smallStepsComeToTheTruth() {
        const auto prepared = slab(0.2f);
        const test::Sample got = marchedTransmittance(prepared->flat, kThroughSlab, 0.05f, 200000);
        QVERIFY2(std::fabs(got.z(std::exp(-2.0))) < test::allowedZ(2),
                 qPrintable(QString::number(got.z(std::exp(-2)))));

        Scene scene = test::plainScene(test::bumpyVolume({41, 33, 29}, {0.7, 1.1, 2.3}, 3), 0.15f);
        scene.transferFunction.nodes = {{.hu = -500, .opacity = 0}, {.hu = 800, .opacity = 1}};
        const auto bumpy = Flattener().prepare(scene);
        const Ray ray{{3, -0.5f, 20}, {0.4f, 0.5f, -0.1f}, kFar};  // leaves by another side, far from its end
        const test::Sample fine = marchedTransmittance(bumpy->flat, ray, 0.03f, 20000);
        test::Sample unbiased;
        for (int i = 0; i < 200000; ++i)
            unbiased.add(track<RatioTracking>(bumpy->flat, ray, stream(i)));
        const double z = (fine.mean() - unbiased.mean()) / std::hypot(fine.standardError(), unbiased.standardError());
        QVERIFY2(std::fabs(z) < test::allowedZ(2), qPrintable(QString::number(z)));
    }

    /// In opaque matter the first sample collides: on average half a step behind the face, where the truth is 0.
    void collisionsInOpaqueMatterAreHalfAStepTooDeep() {
        const auto prepared = slab(1000);
        test::Sample depth;
        for (int i = 0; i < 100000; ++i) {
            const float t = marchToCollision(prepared->flat, kThroughSlab, stream(i), 4);
            QVERIFY(t >= 0 && t < 4);
            depth.add(t);
        }
        QVERIFY(std::fabs(depth.z(2)) < test::allowedZ(1));
    }

    void nothingIsMetOutsideTheBoxOrBeyondTheRaysEnd() {
        const auto prepared = slab(1000);
        const auto meets = [&](vec3 origin, vec3 direction, float length) {
            return marchToCollision(prepared->flat, {origin, direction, length}, stream(1), 0.01f) >= 0;
        };
        QVERIFY(meets({5, 4, 4}, {0, 0, -1}, kFar));
        QVERIFY(!meets({5, 4, 9}, {1, 0, 0}, kFar));
        QVERIFY(!meets({-3, 4, 4}, {1, 0, 0}, 2));
        QVERIFY(!meets({5, 4, 4}, {0, 0, -1}, 0));
    }

    void emptyVolumeCostsChordOverStep() {
        Scene scene = test::plainScene(test::makeVolume({100, 8, 8}, dvec3(1), [](int, int, int) { return 0; }), 1);
        scene.transferFunction.nodes = {{.hu = 100, .opacity = 0}, {.hu = 200, .opacity = 1}};
        const auto prepared = Flattener().prepare(scene);
        QCOMPARE(march(prepared->flat, kThroughSlab, stream(1), 2).samples, 50);
    }

    /// Voxels that lie closer than single precision can tell: no step, no place, and no way into memory.
    void aWayThatIsNotFiniteIsNoNumber() {
        for (const double spacing : {1e-300, 1e-45, 1e-25}) {
            Scene scene =
                test::plainScene(test::makeVolume({8, 8, 8}, dvec3(spacing), [](int, int, int) { return 5; }), 1);
            const auto prepared = Flattener().prepare(scene);
            const FlatVolume& volume = prepared->flat.volume;
            const Ray ray{{4, 4, 4}, vec3(volume.exactIndexFromLocal * dvec3(0.6, 0.8, 0)), kFar};
            QVERIFY(std::isnan(marchToCollision(prepared->flat, ray, stream(1), marchStep(volume, 3))));
            QVERIFY(std::isnan(marchTransmittance(prepared->flat, ray, stream(1), marchStep(volume, 3))));
        }
    }

    /// A march that would take for ever ends, and is no number either.
    void aMarchHasABound() {
        const auto prepared = slab(0);
        QVERIFY(std::isnan(marchToCollision(prepared->flat, kThroughSlab, stream(1), 1e-6f)));
        QVERIFY(std::isnan(marchToCollision(prepared->flat, kThroughSlab, stream(1), 0)));
        QCOMPARE(marchToCollision(prepared->flat, kThroughSlab, stream(1), 1e-4f), -1.0f);
    }

    /// What has no end is counted and left out, in the image too.
    void samplesWithoutAnEndAreCounted() {
        Scene scene = test::plainScene(test::makeVolume({8, 8, 8}, dvec3(1e-25), [](int, int, int) { return 5; }), 1);
        scene.estimator = Estimator::kroesMarch;
        scene.film = {4, 4};
        scene.camera.eyeMm = {0, -1, 0};
        scene.camera.targetMm = {0, 0, 0};
        auto prepared = std::const_pointer_cast<PreparedScene>(Flattener().prepare(scene));
        prepared->viewDepths.assign(prepared->viewDepths.size(), vec2(0, 1e30f));
        prepared->flat.camera.eye = {4, 4, 4};  // in the middle of what no float can tell apart
        const Film film = test::sampled(prepared, 2);
        QCOMPARE(film.status().health.of(Fault::notANumber).count, 2u * 16);
    }

    void stepFollowsTheLongestSide() {
        const Scene even =
            test::plainScene(test::makeVolume({10, 8, 8}, dvec3(0.5), [](int, int, int) { return 0; }), 1);
        QCOMPARE(marchStep(Flattener().prepare(even)->flat.volume, 3), 1.5f);
        const Scene uneven =
            test::plainScene(test::makeVolume({10, 4, 4}, {1, 10, 2}, [](int, int, int) { return 0; }), 1);
        QCOMPARE(marchStep(Flattener().prepare(uneven)->flat.volume, kExposureRenderStep), 12.0f);
    }
};

QTEST_APPLESS_MAIN(MarchTest)
#include "march_test.moc"
