/// Exact free flight: it ends where brute force finds that the optical depth has been passed, and returns the depth
/// that a ray has passed when it leaves the volume; on lanes as on a single ray.

#include <QTest>
#include <random>

#include "render/device/cpu/flight_batch.h"
#include "render/kernel/quadrature/projection.h"
#include "render/kernel/transport/tracking.h"
#include "tests/support/scenes/random_scenes.h"
#include "tests/support/scenes/ray_reference.h"

using namespace pdr;

namespace {

float anyDepth(std::mt19937& random) {
    return freePathDepth(std::uint32_t(random()));
}

}  // namespace

class FreeFlightTest : public QObject {
    Q_OBJECT

  private slots:
    /// Checks the optical depth of the distance that was flown against the requested one, in steps of 0.002 mm in
    /// double precision.
    void flightsEndWhereBruteForceSays() {
        std::mt19937 random(3);
        int ended = 0;
        double worst = 0;
        for (unsigned seed = 1; seed <= 30;
             seed += seed % 3 == 2 ? 2 : 1) {  // not the speckled: their air lies on a node
            const Scene scene = test::anyScene(seed);
            const auto prepared = Flattener().prepare(scene);
            for (Ray ray : test::raysThrough(*scene.volume, 20, seed)) {
                const float wanted = anyDepth(random);
                const Flight flight = freeFlight(prepared->flat, ray, wanted);
                ray.length = flight.distance >= 0 ? flight.distance : ray.length;
                const double expected = flight.distance >= 0 ? double(wanted) : double(flight.passed);
                const double truth = test::rayTruth(scene, ray, 0.002).depth;
                worst = std::max(worst, std::fabs(truth - expected) / (1e-3 + expected));
                QVERIFY(flight.distance >= 0 || flight.passed <= wanted);
                ended += flight.distance >= 0;
            }
        }
        QVERIFY2(worst < 3e-3, qPrintable(QString::number(worst)));  // the steps' own error
        QVERIFY(ended > 100 && ended < 395);
    }

    /// Checks to rounding the exact integral along the distance that was flown.
    void flightsInvertTheExactIntegral() {
        std::mt19937 random(4);
        double worst = 0;
        for (unsigned seed = 1; seed <= 200; ++seed) {
            const Scene scene = test::anyScene(seed);
            const auto prepared = Flattener().prepare(scene);
            for (Ray ray : test::raysThrough(*scene.volume, 50, seed)) {
                const float wanted = anyDepth(random);
                const Flight flight = freeFlight(prepared->flat, ray, wanted);
                const float whole = project<FlatModel::absorption>(prepared->flat, ray, vec3(1)).radiance.x;
                if (flight.distance < 0) {
                    QVERIFY(std::fabs(attenuation(flight.passed).left - whole) <= 1e-6f);
                    continue;
                }
                ray.length = flight.distance;
                const float left = project<FlatModel::absorption>(prepared->flat, ray, vec3(1)).radiance.x;
                // A distance is a float: at 100 mm it is off by 4e-6 mm, in tissue of 3 / mm.
                worst = std::max(worst, std::fabs(double(left) * std::exp(double(wanted)) - 1) / (1 + double(wanted)));
            }
        }
        QVERIFY2(worst < 1e-4, qPrintable(QString::number(worst)));
    }

    /// A larger depth leads farther, without a jump back, as low-discrepancy numbers require.
    void flightsGrowWithTheirDepth() {
        for (unsigned seed = 1; seed <= 20; ++seed) {
            const Scene scene = test::anyScene(seed);
            const auto prepared = Flattener().prepare(scene);
            const Ray ray = test::raysThrough(*scene.volume, 1, seed)[0];
            float last = 0;
            for (float depth = 1e-4f; depth < 20; depth *= 1.01f) {
                const float distance = freeFlight(prepared->flat, ray, depth).distance;
                if (distance < 0)
                    break;
                QVERIFY2(distance >= last * (1 - 1e-6f), qPrintable(QString("%1 after %2").arg(distance).arg(last)));
                last = distance;
            }
        }
    }

    /// Checks the mean and the mean square distance of collisions against delta tracking.
    void flightsAreDistributedAsTrackingFindsThem() {
        std::mt19937 random(6);
        for (unsigned seed = 1; seed <= 6; ++seed) {
            const Scene scene = test::anyScene(seed);
            const auto prepared = Flattener().prepare(scene);
            const Ray ray = test::raysThrough(*scene.volume, 1, seed)[0];
            test::Sample exact[3], tracked[3];
            const auto add = [](test::Sample* to, double distance) {
                to[0].add(distance < 0);
                to[1].add(distance < 0 ? 0 : distance);
                to[2].add(distance < 0 ? 0 : distance * distance);
            };
            for (std::uint64_t i = 0; i < 20'000; ++i) {
                add(exact, double(freeFlight(prepared->flat, ray, anyDepth(random)).distance));
                add(tracked, double(track<DeltaTracking>(prepared->flat, ray,
                                                         Random(seed, 0, i).stream(0, BounceDimension::distance))));
            }
            for (int moment = 0; moment < 3; ++moment) {
                const double error = std::hypot(exact[moment].standardError(), tracked[moment].standardError());
                QVERIFY(std::fabs(exact[moment].mean() - tracked[moment].mean()) <= test::allowedZ(18) * error + 1e-9);
            }
        }
    }

    void lanesFlyAsOneRayDoes() {
        std::mt19937 random(7);
        for (unsigned seed = 1; seed <= 12; ++seed) {
            const Scene scene = test::anyScene(seed);
            const auto prepared = Flattener().prepare(scene);
            FlightBatch batch;
            const std::vector<Ray> rays = test::raysThrough(*scene.volume, 333, seed);
            std::vector<float> depths;
            for (const Ray& ray : rays) {
                depths.push_back(anyDepth(random));
                batch.add(ray, depths.back());
            }
            batch.fly(prepared->flat);
            for (int i = 0; i < batch.size(); ++i) {
                const Flight one = freeFlight(prepared->flat, rays[std::size_t(i)], depths[std::size_t(i)]);
                QCOMPARE(batch.distance(i), one.distance);
                if (one.distance < 0)
                    QCOMPARE(batch.passed(i), one.passed);
            }
        }
    }

    /// A flight to two depths finds both places, on lanes as on a single ray, to the bit; on one segment or on several.
    void aFlightPassesTwoDepths() {
        std::mt19937 random(9);
        for (unsigned seed = 1; seed <= 12; ++seed) {
            const Scene scene = test::anyScene(seed);
            const auto prepared = Flattener().prepare(scene);
            FlightBatch batch;
            const std::vector<Ray> rays = test::raysThrough(*scene.volume, 333, seed);
            std::vector<std::pair<float, float>> depths;
            for (const Ray& ray : rays) {
                const float one = anyDepth(random), other = random() % 2 == 0 ? one * 1.01f : anyDepth(random);
                depths.push_back(std::minmax({one, other}));
                batch.add(ray, depths.back().first, depths.back().second, {});
            }
            batch.fly(prepared->flat);
            for (int i = 0; i < batch.size(); ++i) {
                const auto [nearer, further] = depths[std::size_t(i)];
                const Ray& ray = rays[std::size_t(i)];
                const Flight both = freeFlight<FlightEnd::places>(prepared->flat, ray, nearer, further);
                QCOMPARE(both.distance, freeFlight(prepared->flat, ray, nearer).distance);
                QCOMPARE(both.further, freeFlight(prepared->flat, ray, further).distance);
                QCOMPARE(batch.distance(i), both.distance);
                QCOMPARE(batch.further(i), both.further);
            }
        }
    }

    /// Where nobody asks for the place, the same flights end, and the others pass the same.
    void flightsThatOnlySayWhetherTheyEnd() {
        std::mt19937 random(8);
        for (unsigned seed = 1; seed <= 12; ++seed) {
            const Scene scene = test::anyScene(seed);
            const auto prepared = Flattener().prepare(scene);
            FlightBatch batch;
            const std::vector<Ray> rays = test::raysThrough(*scene.volume, 333, seed);
            std::vector<Flight> whole;
            for (const Ray& ray : rays) {
                const float depth = anyDepth(random);
                batch.add(ray, depth);
                whole.push_back(freeFlight(prepared->flat, ray, depth));
                const Flight one = freeFlight<FlightEnd::whether>(prepared->flat, ray, depth);
                QCOMPARE(one.distance, whole.back().distance < 0 ? -1.0f : 0.0f);
                QCOMPARE(one.passed, whole.back().passed);
            }
            batch.fly(prepared->flat, FlightEnd::whether);
            for (int i = 0; i < batch.size(); ++i) {
                QCOMPARE(batch.distance(i), whole[std::size_t(i)].distance < 0 ? -1.0f : 0.0f);
                QCOMPARE(batch.passed(i), whole[std::size_t(i)].passed);
            }
        }
    }

    /// A cell is met and passed in one step, where one piece of the curve holds for it: no lane waits for others to
    /// meet theirs.
    void aCellTakesOneStep() {
        constexpr int kCells = 40;
        Scene scene;
        scene.volume = std::make_shared<Volume>(VolumeGeometry::aligned(ivec3(kCells + 1), dvec3(1), dvec3(0)),
                                                Voxels(std::size_t(kCells + 1) * (kCells + 1) * (kCells + 1), 500));
        scene.transferFunction = {0.001f, {{.hu = 0, .opacity = 0}, {.hu = 1000, .opacity = 1}}};
        const auto prepared = Flattener().prepare(scene);
        FreeFlight<float> flight;
        flight.start(prepared->flat, {-10, 20.3f, 20.4f}, {1, 0, 0}, 100, 5);
        int steps = 0;
        for (; flight.going(); ++steps)
            flight.step(prepared->flat);
        QVERIFY(flight.passed > 0);
        QCOMPARE(steps, kCells + 2);  // the half voxels outside the first and the last centres are cells as well
    }

    /// The densest and the thinnest tissue, a ray that misses, and one that is in nothing.
    void flightsInExtremesEnd() {
        const auto flight = [](float extinction, float depth, const Ray& ray) {
            const Scene scene =
                test::plainScene(test::makeVolume({8, 8, 8}, dvec3(1), [](int, int, int) { return 5; }), extinction);
            return freeFlight(Flattener().prepare(scene)->flat, ray, depth);
        };
        const Ray ray{{-0.5f, 3, 3}, {1, 0, 0}, 8};
        QVERIFY(std::fabs(flight(1e6f, 1, ray).distance / 1e-6f - 1) < 1e-5f);
        QVERIFY(std::fabs(flight(1e-9f, 7e-9f, ray).distance / 7 - 1) < 1e-5f);
        QVERIFY(std::fabs(flight(1e-9f, 1e-10f, ray).distance / 0.1f - 1) < 1e-5f);
        QVERIFY(flight(1e-9f, 1, ray).distance < 0);
        QVERIFY(std::fabs(flight(1e-9f, 1, ray).passed / 8e-9f - 1) < 1e-5f);
        QVERIFY(flight(1, 1, {{0, 0, 0}, {1, 0, 0}, -1}).distance < 0);
        QCOMPARE(flight(1, 1, {{0, 0, 0}, {1, 0, 0}, -1}).passed, 0.0f);
        QCOMPARE(flight(0, 1e-10f, ray).passed, 0.0f);
    }
};

QTEST_GUILESS_MAIN(FreeFlightTest)
#include "free_flight_test.moc"
