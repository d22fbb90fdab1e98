/// Random distances and directions against their exact distributions. False-alarm rate 1e-6 per comparison, seeds
/// fixed.

#include <QTest>
#include <array>

#include "render/device/cpu/lane_tracker.h"
#include "render/kernel/transport/phase.h"
#include "tests/support/scenes/scenes.h"
#include "tests/support/statistics.h"

using namespace pdr;

namespace {

constexpr double kAlarm = 1e-6;
constexpr int kFlights = 1 << 18;

using Bins = std::array<double, 64>;

/// Extinction that grows evenly from `first` to `last` [1/mm] over 64 mm along x, between voxel centres.
struct Ramp {
    double first, last;

    double depth(double x) const { return first * x + (last - first) / 64 * x * x / 2; }

    Scene scene() const {
        Scene scene =
            test::plainScene(test::makeVolume({65, 20, 20}, dvec3(1), [](int i, int, int) { return 100 * i; }),
                             float(std::max(first, last)));
        const double densest = std::max(first, last);
        scene.transferFunction.nodes = {{.hu = 0, .opacity = float(first / densest)},
                                        {.hu = 6400, .opacity = float(last / densest)}};
        return scene;
    }

    /// Obliquely upwards through the ramp, so that cells are left along all axes; t counts x alone.
    Ray ray() const { return {{0, 3, 2}, {1, 0.2f, 0.25f}, 64}; }

    /// Returns which of 64 equally probable bins a flight ends in; the last one also takes what flew through.
    int bin(float t) const { return t < 0 ? 63 : std::min(63, int(64 * -std::expm1(-depth(t)))); }
};

RandomStream stream(int i) {
    return Random(99, std::uint32_t(i), 2).stream(0, BounceDimension::distance);
}

/// Cumulative distribution of the Henyey-Greenstein cosine, from 1 - cos; straight on is 1.
double cumulative(double g, double oneMinusCos) {
    if (std::fabs(g) < 1e-5)
        return 1 - oneMinusCos / 2 + g * oneMinusCos * (oneMinusCos - 2) * 0.75;  // to first order in g
    const double root = std::sqrt((1 - g) * (1 - g) + 2 * g * oneMinusCos);
    return (1 - g) * (1 + g) / (2 * g) * (1 / root - 1 / (1 + g));
}

}  // namespace

class SamplingTest : public QObject {
    Q_OBJECT

  private slots:
    void freeFlightsFollowTheClosedForm_data() {
        QTest::addColumn<double>("first");
        QTest::addColumn<double>("last");
        QTest::newRow("homogeneous") << 0.1 << 0.1;
        QTest::newRow("from nothing up") << 0.0 << 0.3;
        QTest::newRow("down to nothing") << 0.3 << 0.0;
        QTest::newRow("gently up") << 0.08 << 0.12;
        QTest::newRow("dense") << 40.0 << 20.0;
        QTest::newRow("thin") << 1e-3 << 5e-3;
    }
    void freeFlightsFollowTheClosedForm() {
        QFETCH(double, first);
        QFETCH(double, last);
        const Ramp ramp{first, last};
        const auto prepared = Flattener().prepare(ramp.scene());
        Bins single{}, lanes{};
        RayBatch batch;
        for (int i = 0; i < kFlights; ++i) {
            ++single[ramp.bin(track<DeltaTracking>(prepared->flat, ramp.ray(), stream(i)))];
            batch.add(ramp.ray(), stream(i + kFlights));
            if (!batch.full())
                continue;
            batch.track<DeltaTracking>(prepared->flat);
            for (int row = 0; row < batch.size(); ++row)
                ++lanes[ramp.bin(batch.result(row))];
            batch.clear();
        }
        // What flies through a thin ramp fills the last bins together: they are joined.
        const double through = std::exp(-ramp.depth(64));
        const int whole = std::min(63, int(64 * (1 - through)));
        for (const Bins& bins : {single, lanes}) {
            double square = 0, rest = kFlights;
            for (int i = 0; i < whole; ++i) {
                square += (bins[i] - kFlights / 64.0) * (bins[i] - kFlights / 64.0) / (kFlights / 64.0);
                rest -= bins[i];
            }
            const double expected = kFlights * (1 - whole / 64.0);
            square += (rest - expected) * (rest - expected) / expected;
            QVERIFY2(test::chiSquareP(square, whole) > kAlarm, qPrintable(QString("%1 on %2").arg(square).arg(whole)));
        }
    }

    /// Where nothing but real collisions happen, the first number of a ray's stream alone says how far it flies:
    /// -ln(u) free paths, ray by ray.
    void firstFlightIsTheLogarithmOfItsNumber_data() {
        QTest::addColumn<double>("extinction");
        for (const double extinction : {1e-3, 0.1, 1.0, 40.0, 1e3})
            QTest::addRow("%g / mm", extinction) << extinction;
    }
    void firstFlightIsTheLogarithmOfItsNumber() {
        QFETCH(double, extinction);
        const Ramp even{extinction, extinction};
        const auto prepared = Flattener().prepare(even.scene());
        RayBatch batch;
        std::vector<double> depths;
        int other = 0;
        for (int i = 0; i < kFlights; ++i) {
            batch.add(even.ray(), stream(i));
            if (!batch.full())
                continue;
            batch.track<DeltaTracking>(prepared->flat);
            for (int row = 0; row < batch.size(); ++row) {
                const int number = i - batch.size() + 1 + row;
                const double depth = -std::log(double(stream(number).pair().x)), flown = batch.result(row);
                const bool through = depth > extinction * 64;
                other += through ? flown >= 0 : !(std::fabs(flown * extinction / depth - 1) < 2e-5);
                depths.push_back(through ? depth : flown * extinction);
            }
            batch.clear();
        }
        // Bounds are a little wider than the tissue: one collision in a million is none.
        QVERIFY2(other <= 20, qPrintable(QString("%1 of %2 flights").arg(other).arg(kFlights)));
        // The numbers are what they should be: mean, mean square, and the largest distance from the distribution.
        test::Sample first, second;
        std::sort(depths.begin(), depths.end());
        double farthest = 0;
        for (std::size_t i = 0; i < depths.size(); ++i) {
            first.add(depths[i]);
            second.add(depths[i] * depths[i]);
            farthest = std::max(farthest, std::fabs(-std::expm1(-depths[i]) - (i + 0.5) / depths.size()));
        }
        const double allowed = test::allowedZ(10);
        QVERIFY2(std::fabs(first.z(1)) < allowed, qPrintable(QString::number(first.mean())));
        QVERIFY2(std::fabs(second.z(2)) < allowed, qPrintable(QString::number(second.mean())));
        QVERIFY(2 * std::exp(-2 * farthest * farthest * depths.size()) > kAlarm);  // Kolmogorov and Smirnov
    }

    /// Light through optical depth 2 under bounds that are too high by far: what roulette takes from most it gives back
    /// to some. Finds 0.6 % nine times out of ten.
    void rouletteLeavesTheMeanTransmittance_data() {
        QTest::addColumn<double>("excess");
        for (const double excess : {1.3, 2.0, 5.0})
            QTest::addRow("bound times %g", excess) << excess;
    }
    void rouletteLeavesTheMeanTransmittance() {
        QFETCH(double, excess);
        const auto volume = test::makeVolume({65, 4, 4}, dvec3(1), [](int i, int, int) { return i == 64 ? 1000 : 0; });
        Scene scene = test::plainScene(volume, 0.03125f * float(excess));
        scene.transferFunction.nodes = {{.hu = 0, .opacity = float(1 / excess)},
                                        {.hu = 1, .opacity = float(1 / excess)},
                                        {.hu = 1000, .opacity = 1}};
        const auto prepared = test::withGlobalMajorant(scene);
        const Ray ray{{-0.5f, 1.3f, 1.6f}, {1, 0, 0}, 63.5f};  // up to the last even voxel
        test::Sample got;
        RayBatch batch;
        for (int i = 0; i < 3 << 20; ++i) {
            batch.add(ray, stream(i));
            if (!batch.full())
                continue;
            batch.track<RatioTracking>(prepared->flat);
            for (int row = 0; row < batch.size(); ++row)
                got.add(batch.result(row));
            batch.clear();
        }
        const double truth = std::exp(-0.03125 * 63.5), allowed = test::allowedZ(3);
        QVERIFY2(std::fabs(got.z(truth)) < allowed, qPrintable(QString("%1 instead of %2").arg(got.mean()).arg(truth)));
        QVERIFY2((allowed + 1.2816) * got.standardError() < 0.006 * truth,
                 qPrintable(QString("finds %1").arg((allowed + 1.2816) * got.standardError() / truth)));
    }

    /// 64 equally probable bins, for g of all sizes, and moments.
    void directionsFollowHenyeyAndGreenstein_data() {
        QTest::addColumn<double>("g");
        for (const double size : {0.0, 1e-8, 1e-6, 1e-4, 0.01, 0.1, 0.3, 0.5, 0.75, 0.9, 0.99, 0.999, 0.9999})
            for (const double sign : {1.0, -1.0})
                QTest::addRow("%g", sign * size) << sign * size;
    }
    void directionsFollowHenyeyAndGreenstein() {
        QFETCH(double, g);
        const double exact = float(g);  // what the kernel is given
        const vec3 travel = glm::normalize(vec3(-0.2f, 0.9f, 0.4f));
        RandomStream random = Random(7, 1, 2).stream(0, BounceDimension::direction);
        Bins bins{};
        test::Sample first, second, around;
        for (int i = 0; i < 200000; ++i) {
            const vec3 onward = phaseSample(float(g), -travel, random.pair());
            const dvec3 difference = dvec3(onward) - dvec3(travel);
            QVERIFY(std::fabs(glm::length(dvec3(onward)) - 1) < 1e-5);
            const double oneMinusCos = 0.5 * glm::dot(difference, difference);
            const double onePlusCos = 0.5 * glm::dot(dvec3(onward) + dvec3(travel), dvec3(onward) + dvec3(travel));
            const double cosine = 0.5 * (onePlusCos - oneMinusCos);
            first.add(cosine);
            second.add(cosine * cosine);
            around.add(onward.x - cosine * travel.x);
            // From the side where directions crowd, so that 1 - cos keeps its digits.
            const double u = g >= 0 ? cumulative(exact, oneMinusCos) : cumulative(-exact, onePlusCos);
            ++bins[std::clamp(int(64 * u), 0, 63)];
        }
        QVERIFY2(test::uniformP(bins) > kAlarm, qPrintable(QString::number(test::uniformP(bins))));
        if (std::fabs(g) > 0.99)  // directions are thrown aside too rarely for a normal mean
            return;
        const double allowed = test::allowedZ(26 * 3);
        QVERIFY(std::fabs(first.z(exact)) < allowed);
        QVERIFY(std::fabs(second.z((1 + 2 * exact * exact) / 3)) < allowed);
        QVERIFY(std::fabs(around.z(0)) < allowed);  // no side is preferred
    }
};

QTEST_GUILESS_MAIN(SamplingTest)
#include "sampling_test.moc"
