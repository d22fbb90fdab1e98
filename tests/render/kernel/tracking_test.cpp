#include <QTest>
#include <array>
#include <random>

#include "render/device/cpu/lane_tracker.h"
#include "render/kernel/pixel.h"
#include "tests/support/scenes/scenes.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

RandomStream stream(int i) {
    return Random(17, unsigned(i), 1).stream(0, BounceDimension::distance);
}

/// A ray along +x through the middle of a volume of unit voxels, from the box's border.
Ray alongX(const PreparedScene& prepared, float length) {
    const vec3 size(prepared.volume->size());
    return {{-0.5f, size.y / 2, size.z / 2}, {1, 0, 0}, length};
}

/// Delta tracking behind one bound, in the fewest words.
float plainTracking(const FlatScene& scene, const Ray& ray, RandomStream random, float majorant) {
    for (float t = 0;;) {
        const vec2 u = random.pair();
        t += negativeLog(u.x) / majorant;
        if (t >= ray.length)
            return -1;
        if (u.y * majorant < extinction(scene, ray.origin + ray.direction * t))
            return t;
    }
}

}  // namespace

class TrackingTest : public QObject {
    Q_OBJECT

  private slots:
    void freeFlightsAreExponential() {
        const auto prepared = Flattener().prepare(
            test::plainScene(test::makeVolume({400, 8, 8}, dvec3(1), [](int, int, int) { return 100; }), 0.1f));
        std::array<double, 64> bins{};
        for (int i = 0; i < 200000; ++i) {
            const float t = track<DeltaTracking>(prepared->flat, alongX(*prepared, 400), stream(i));
            QVERIFY(t >= 0);  // optical depth 40
            ++bins[std::min(int(64 * -std::expm1(-0.1 * t)), 63)];
        }
        QVERIFY(test::uniformP(bins) > 1e-6);
    }

    void transmittanceOfASlabIsBeersLaw_data() {
        QTest::addColumn<float>("extinction");
        for (const float extinction : {1e-6f, 1e-3f, 0.05f, 0.5f, 1.0f})
            QTest::addRow("%g per mm", extinction) << extinction;
    }
    void transmittanceOfASlabIsBeersLaw() {
        QFETCH(float, extinction);
        const auto prepared = Flattener().prepare(
            test::plainScene(test::makeVolume({9, 7, 5}, dvec3(1), [](int, int, int) { return 3; }), extinction));
        test::Sample ratio, delta;
        for (int i = 0; i < 200000; ++i) {
            ratio.add(track<RatioTracking>(prepared->flat, alongX(*prepared, 1e30f), stream(i)));
            delta.add(track<DeltaTracking>(prepared->flat, alongX(*prepared, 1e30f), stream(i)) < 0);
        }
        const double truth = std::exp(-9.0 * extinction);
        QVERIFY(std::fabs(ratio.mean() - truth) <= test::allowedZ(5) * ratio.standardError() + 1e-5 * truth);
        QVERIFY(std::fabs(delta.mean() - truth) <= test::allowedZ(5) * std::sqrt(truth * (1 - truth) / 200000) + 1e-12);
    }

    /// Between two voxel centres trilinear interpolation is an exact ramp: T = exp(-(a L + b L^2 / 2)).
    void transmittanceOfARampIsExact_data() {
        QTest::addColumn<float>("length");
        QTest::newRow("much is left") << 20.0f;
        QTest::newRow("little is left, roulette decides") << 50.0f;
    }
    void transmittanceOfARampIsExact() {
        QFETCH(float, length);
        Scene scene =
            test::plainScene(test::makeVolume({64, 4, 4}, dvec3(1), [](int i, int, int) { return 10 * i; }), 0.2f);
        scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 630, .opacity = 1}};
        const auto prepared = Flattener().prepare(scene);
        test::Sample ratio;
        for (int i = 0; i < 300000; ++i)
            ratio.add(track<RatioTracking>(prepared->flat, {{0, 1, 1}, {1, 0, 0}, length}, stream(i)));
        QVERIFY(std::fabs(ratio.z(std::exp(-0.2 * length * length / (2 * 63.0)))) < test::allowedZ(2));
    }

    /// Directions along axes, in planes and oblique, from all sides: what is walked is the chord of the box.
    void everyRayMeetsItsWholeChord() {
        const auto volume = test::makeVolume({37, 18, 50}, dvec3(1), [](int, int, int) { return 1; });
        const auto prepared = Flattener().prepare(test::plainScene(volume, 3.0f));
        std::mt19937 random(2);
        std::uniform_real_distribution<float> unit(-1, 1);
        const vec3 low(-0.5f), high = vec3(37, 18, 50) - 0.5f;
        for (int i = 0; i < 3000; ++i) {
            vec3 direction(unit(random), unit(random), unit(random));
            for (int axis = 0; axis < 3; ++axis)
                if (random() % 4 == 0)
                    direction[axis] = random() % 2 ? 0.0f : -0.0f;
            if (glm::length(direction) < 0.1f)
                continue;
            direction = glm::normalize(direction);
            vec3 origin = low + (high - low) * (0.5f + 0.5f * vec3(unit(random), unit(random), unit(random)));
            if (random() % 2)  // on borders between cells and voxels
                origin = glm::clamp(glm::floor(origin), low, high - 0.01f);
            const Interval<float> inside = clipped(origin, direction, low, high, Interval<float>{0, 1e30f});
            MajorantTraversal<float, true> flight;
            flight.start(prepared->flat.majorants, {origin.x, origin.y, origin.z},
                         {direction.x, direction.y, direction.z}, 1e30f, stream(i));
            int steps = 0, collisions = 0;
            float last = 0;
            while (flight.isActive() && ++steps < 10000) {
                collisions += flight.step(prepared->flat).happened;
                QVERIFY(flight.t >= last);
                last = flight.t;
            }
            QVERIFY(steps - collisions <= 37 + 18 + 50 + 12);
            QVERIFY2(std::fabs(last - inside.leave) <= 1e-4f * (1 + inside.leave),
                     qPrintable(QString("%1 instead of %2").arg(last).arg(inside.leave)));
        }
    }

    void lanesAndSinglePathsAgreeBitByBit_data() {
        QTest::addColumn<float>("extinction");
        QTest::newRow("cells are walked") << 2.0f;
        QTest::newRow("voxels are walked") << 31.0f;
    }
    void lanesAndSinglePathsAgreeBitByBit() {
        QFETCH(float, extinction);
        Scene scene = test::plainScene(test::bumpyVolume({61, 45, 38}, {0.7, 1.1, 2.3}, 1), extinction);
        scene.transferFunction.nodes = {{.hu = -200, .opacity = 0},
                                        {.hu = 300, .opacity = 0.3f},
                                        {.hu = 300, .opacity = 0},
                                        {.hu = 900, .opacity = 1}};
        const auto prepared = Flattener().prepare(scene);
        std::mt19937 random(5);
        std::uniform_real_distribution<float> unit(-1, 1);
        RayBatch forDelta, forRatio;
        std::vector<Ray> rays;
        for (int i = 0; i < RayBatch::kCapacity - 3; ++i) {
            const vec3 origin = vec3(30, 22, 19) + 15.0f * vec3(unit(random), unit(random), unit(random));
            rays.push_back({origin, glm::normalize(vec3(unit(random), unit(random), unit(random))), i % 7 ? 1e30f : 9});
            forDelta.add(rays.back(), stream(i));
            forRatio.add(rays.back(), stream(i));
        }
        forDelta.track<DeltaTracking>(prepared->flat);
        forRatio.track<RatioTracking>(prepared->flat);
        for (int i = 0; i < int(rays.size()); ++i) {
            QCOMPARE(forDelta.result(i), track<DeltaTracking>(prepared->flat, rays[i], stream(i)));
            QCOMPARE(forRatio.result(i), track<RatioTracking>(prepared->flat, rays[i], stream(i)));
        }
    }

    /// A voxel in which 16 million free paths of one side's bound lie beside nothing at all: rays that are tracked
    /// through it end, as no number, and the image counts them.
    void aRayThatWouldNeverEndIsCounted() {
        Scene scene = test::plainScene(
            test::makeVolume({2, 2, 2}, dvec3(1e6), [](int i, int, int) { return i == 0 ? 0 : 1000; }), 16);
        scene.transferFunction.nodes = {{.hu = 1000, .opacity = 0}, {.hu = 1000, .opacity = 1}};
        scene.model = Model::multipleScattering;  // the first flight is exact and ends; later ones are tracked
        scene.film = {1, 1};
        scene.camera = {Camera::Type::orthographic, {-1e7, 5e5, 5e5}, {1e6, 5e5, 5e5}, {0, 0, 1}, 35, 1e3};
        const auto prepared = Flattener().prepare(scene);
        QVERIFY(prepared->flat.majorants.dense);
        const Ray ray{{0.5f, -0.5f, 0.5f}, prepared->flat.volume.indexFromLocal * vec3(0, 1, 0), 2e6f};
        QVERIFY(std::isnan(track<RatioTracking>(prepared->flat, ray, stream(1))));
        const Film film = test::sampled(prepared, 4);
        const std::uint64_t endless = film.status().health.of(Fault::notANumber).count;
        QVERIFY(endless > 0);
        QCOMPARE(film.pixel(0, 0).count, 4 - endless);
    }

    /// Where voxels are walked, collisions lie where a tracker behind one bound finds them, and no bound is broken.
    void denseTissueIsMetWhereAPlainTrackerMeetsIt() {
        Scene scene = test::plainScene(test::bumpyVolume({61, 45, 38}, {0.7, 1.1, 2.3}, 1), 31);
        scene.transferFunction.nodes = {{.hu = 300, .opacity = 0},     {.hu = 500, .opacity = 0.004f},
                                        {.hu = 500, .opacity = 0.02f}, {.hu = 700, .opacity = 0},
                                        {.hu = 1000, .opacity = 0},    {.hu = 1000, .opacity = 1}};
        const auto prepared = Flattener().prepare(scene);
        constexpr int kRays = 40000, kBins = 40;
        std::mt19937 random(8);
        std::uniform_real_distribution<float> unit(-1, 1);
        std::vector<float> fast, plain;
        bool overMajorant = false;
        for (int i = 0; i < kRays; ++i) {
            const vec3 direction(0.9f, 0.2f * unit(random), 0.2f * unit(random));
            const Ray ray{{-0.5f, 22 + 10 * unit(random), 19 + 10 * unit(random)}, direction, 60};
            fast.push_back(track<DeltaTracking>(prepared->flat, ray, stream(i), overMajorant));
            plain.push_back(plainTracking(prepared->flat, ray, stream(kRays + i), 32));
        }
        QVERIFY(!overMajorant);
        std::vector<float> all = fast;
        all.insert(all.end(), plain.begin(), plain.end());
        std::ranges::sort(all);
        double square = 0;
        for (int bin = 0; bin < kBins; ++bin) {  // (from, to] between quantiles of both together
            const float from = bin == 0 ? -2 : all[std::size_t(bin) * all.size() / kBins];
            const float to = bin + 1 == kBins ? 1e9f : all[std::size_t(bin + 1) * all.size() / kBins];
            const auto inside = [&](float t) { return t > from && t <= to; };
            const double a = double(std::ranges::count_if(fast, inside)),
                         b = double(std::ranges::count_if(plain, inside));
            square += a + b > 0 ? (a - b) * (a - b) / (a + b) : 0;
        }
        QVERIFY2(test::chiSquareP(square, kBins) > 1e-4, qPrintable(QString::number(square)));
    }

    void nothingToMeetCostsNothing() {
        Scene scene = test::plainScene(test::makeVolume({40, 40, 40}, dvec3(1), [](int, int, int) { return 0; }), 1e6f);
        scene.transferFunction.nodes = {{.hu = 100, .opacity = 0}, {.hu = 200, .opacity = 1}};
        const auto prepared = Flattener().prepare(scene);
        QCOMPARE(track<RatioTracking>(prepared->flat, alongX(*prepared, 40), stream(1)), 1.0f);
        QVERIFY(isBackgroundOnly(prepared->flat, depthBounds(prepared->flat, {16, 16})));
    }
};

QTEST_GUILESS_MAIN(TrackingTest)
#include "tracking_test.moc"
