/// The self-test tested: its data, its verdicts, its power, and what is no image. False alarms: every comparison here
/// is at 1e-6 or by allowedZ; seeds are fixed.

#include <QTest>

#include "app/bench/commands.h"
#include "app/selftest/measure.h"
#include "app/selftest/scene.h"
#include "render/prepare/flatten.h"
#include "tests/physics/biased_march.h"
#include "tests/physics/closed_forms.h"
#include "tests/support/devices/tested_device.h"
#include "tests/support/statistics.h"

using namespace pdr;
using namespace pdr::selftest;

namespace {

constexpr double kAllowed = 5;  ///< |z|: what chance exceeds once in 1.7 million comparisons

std::vector<Case> shippedCases() {
    std::vector<Case> cases;
    const Result<std::vector<Family>> families = shippedFamilies();
    for (const Family& family : families.value())
        cases.insert(cases.end(), family.cases.begin(), family.cases.end());
    return cases;
}

/// A slab that scatters once, seen straight on.
Case plainSlab(double depth, double beam = 1) {
    Case slab{.name = "slab", .source = "closed form"};
    slab.quantity = Quantity::reflectanceFactor;
    slab.scene.depth = depth;
    slab.scene.albedo = 0.8;
    slab.scene.beam = beam;
    slab.expected = test::truth(slab);
    slab.full = {1 << 18, 0.05};
    return slab;
}

bool notCancelled() {
    return false;
}

}  // namespace

class PhysicsTest : public QObject {
    Q_OBJECT

  private slots:
    /// Every expected value follows from a formula or from adding-doubling. The data have six digits.
    void expectedValuesFollowTwice() {
        int compared = 0;
        for (const Case& one : shippedCases()) {
            const double truth = test::truth(one);
            QVERIFY2(std::fabs(one.expected - truth) <= 2e-6 * std::fabs(truth) + 1e-6,
                     qPrintable(QString("%1: %2 in the data, %3 by formula")
                                    .arg(one.name.c_str())
                                    .arg(one.expected, 0, 'g', 9)
                                    .arg(truth, 0, 'g', 9)));
            ++compared;
        }
        QVERIFY(compared > 150);
    }

    /// Published figures, by hand: so that formulas and data cannot both be wrong alike.
    void publishedValuesHold() {
        const test::AddingDoubling mcml(0.9, 0.75, 2, {1});
        QVERIFY(std::fabs(mcml.reflectance(0) - 0.09739) < 1e-5);    // van de Hulst 1980, as in Wang et al. 1995
        QVERIFY(std::fabs(mcml.transmittance(0) - 0.66096) < 1e-5);  // the same
        QVERIFY(std::fabs(test::chandrasekharH(0.9, 1) - 1.8501) < 1e-4);
        QVERIFY(std::fabs(test::chandrasekharH(0.5, 0.5) - 1.1877) < 1e-4);
    }

    void everyCaseIsSharpEnoughToMatter() {
        for (const Case& one : shippedCases()) {
            QVERIFY(one.full.samples >= one.quick.samples);
            QVERIFY(one.full.detects <= one.quick.detects);
            QVERIFY2(one.full.detects <= 0.05 && one.quick.detects <= 0.5, one.name.c_str());
            QVERIFY(10 * one.geometryBias <= one.full.detects);
        }
    }

    void everySceneKeepsToTheRanges() {
        for (const Case& one : shippedCases()) {
            const Result<void> ok = sceneOf(one).check();
            QVERIFY2(ok, ok ? "" : (one.name + ": " + ok.error().text()).c_str());
        }
    }

    void dataWithUnknownWordsAreRefused() {
        const auto read = [](const std::string& scene) {
            return readFamily(R"({"family": "f", "note": "n", "cases": [{"name": "c", "source": "s", "expected": 1,
                "quick": {"samples": 1, "detects": 1}, "full": {"samples": 1, "detects": 1}, "scene": )" +
                                  scene + "}]}",
                              "file");
        };
        QVERIFY(read(R"({"shape": "slab", "depth": 2})"));
        QVERIFY(!read(R"({"shape": "cube"})"));
        QVERIFY(!read(R"({"dept": 2})"));
        QVERIFY(!read(R"({"depth": "2"})"));
        QVERIFY(!readFamily("{", "file"));
    }

    void anUnknownDeviceIsAnError() {
        QCOMPARE(bench::selftest({"--device", "abacus"}), bench::kExplained);
        QCOMPARE(bench::selftest({"--slow"}), 2);
    }

    void verdictsAreWhatTheySay() {
        Case one{.expected = 2};
        const Sharpness sharpness{1000, 0.01};
        const auto verdict = [&](double value, double error, bool cut = false) {
            Measurement got{value, error};
            if (cut)
                got.health.add(Fault::cutPath, 0, 0);
            return judge(one, got, sharpness, 4).verdict;
        };
        QCOMPARE(verdict(2.011, 0.003), Verdict::agrees);
        QCOMPARE(verdict(2.013, 0.003), Verdict::deviates);
        QCOMPARE(verdict(1.987, 0.003), Verdict::deviates);
        QCOMPARE(verdict(2, 0.01), Verdict::tooBlunt);
        QCOMPARE(verdict(2, 0.003, true), Verdict::faulty);
        QCOMPARE(verdict(std::nan(""), 0.003), Verdict::deviates);
        QCOMPARE(verdict(2, std::nan("")), Verdict::deviates);
        QCOMPARE(verdict(2 + 1e-6, 0), Verdict::agrees);  // rounding
        QCOMPARE(verdict(2.0001, 0), Verdict::deviates);
        one.geometryBias = 1e-3;
        QCOMPARE(verdict(2.013, 0.003), Verdict::agrees);
        QCOMPARE(verdict(2.015, 0.003), Verdict::deviates);
    }

    void chiSquareOfFreeFlightsIsJudgedFromAboveOnly() {
        const Case flights{.quantity = Quantity::freeFlights, .expected = 64};
        const Sharpness sharpness{1'000'000, 0.02};
        QCOMPARE(judge(flights, {20, 11}, sharpness, 4).verdict, Verdict::agrees);
        QCOMPARE(judge(flights, {100, 11}, sharpness, 4).verdict, Verdict::agrees);
        QCOMPARE(judge(flights, {130, 11}, sharpness, 4).verdict, Verdict::deviates);
        QCOMPARE(judge(flights, {64, 11}, {1000, 0.02}, 4).verdict, Verdict::tooBlunt);
    }

    /// Faultless runs on 20 seeds: z is a standard normal number, neither wider nor narrower.
    void faultlessRunsDeviateByChanceOnly() {
        const auto device = test::testedDevice();
        double squares = 0;
        int runs = 0, alarms = 0;
        for (const Case& one : shippedCases()) {
            if (one.scene.multiple || one.geometryBias > 0 || one.quantity == Quantity::freeFlights ||
                std::fabs(one.scene.g) > 0.9)  // too rarely thrown aside: 16384 samples are no normal mean
                continue;
            for (std::uint64_t seed = 1; seed <= 20; ++seed) {
                const Measurement got = measure(*device, one, 16384, seed * 1009, notCancelled).value();
                const Judgement judgement = judge(one, got, {16384, 10}, kAllowed);
                alarms += judgement.verdict != Verdict::agrees;
                squares += judgement.z * judgement.z;
                ++runs;
            }
        }
        QVERIFY(runs >= 500);
        QCOMPARE(alarms, 0);
        QVERIFY2(test::chiSquareP(squares, runs) > 1e-6 && test::chiSquareP(squares, runs) < 1 - 1e-6,
                 qPrintable(QString("%1 on %2").arg(squares).arg(runs)));
    }

    /// A bias of just the size that a case is said to detect is found nine times out of ten, on 20 seeds each.
    void theStatedBiasIsFound() {
        const auto device = test::testedDevice();
        const double allowed = allowedZ(int(shippedCases().size()));
        int runs = 0, found = 0;
        for (Case one : {plainSlab(1), plainSlab(4), plainSlab(0.3)})
            for (std::uint64_t seed = 1; seed <= 20; ++seed) {
                const Measurement got = measure(*device, one, 65536, seed * 17, notCancelled).value();
                const double detects = judge(one, got, {65536, 1}, allowed).detects;
                Case shifted = one;
                shifted.expected *= 1 + (seed % 2 ? detects : -detects);
                found += judge(shifted, got, {65536, 1}, allowed).verdict == Verdict::deviates;
                ++runs;
            }
        // 54 of 60 on average; fewer than 43 once in 10^5.
        QVERIFY2(found >= 43, qPrintable(QString("%1 of %2").arg(found).arg(runs)));
    }

    /// Little throughput goes on by roulette, wherever it goes to: light through dark tissue, most of it scattered more
    /// than once straight on, would miss directions that the roulette's number had chosen too.
    void rouletteChoosesNoDirection() {
        Case dark = plainSlab(4);
        dark.scene.albedo = 0.2;
        dark.scene.g = 0.5;
        dark.scene.view = -0.8;
        dark.scene.multiple = true;
        dark.expected = test::truth(dark);
        const Measurement got = measure(*test::testedDevice(), dark, 1 << 20, 7, notCancelled).value();
        const Judgement judgement = judge(dark, got, {1 << 20, 0.03}, kAllowed);
        QVERIFY2(judgement.verdict == Verdict::agrees, qPrintable(QString("%1 +- %2, expected %3: finds %4")
                                                                      .arg(got.value)
                                                                      .arg(got.standardError)
                                                                      .arg(dark.expected)
                                                                      .arg(judgement.detects)));
    }

    /// Exposure Render's march through the same slabs must be found wrong.
    void aBiasedMarchIsFound() {
        for (const double stepDepth : {0.5, 1.0, 2.0}) {
            const double depth = 2.5 * stepDepth;
            Case reflected = plainSlab(depth, 0.5), through = reflected;
            through.quantity = Quantity::radiance;
            through.expected = std::exp(-depth);
            const auto prepared = Flattener().prepare(sceneOf(reflected));
            const float thickness = float(extentMm(reflected.scene)), step = float(stepDepth);
            const Measurement back = test::marchedReflectance(reflected, prepared->flat, thickness, step, 1 << 20);
            QCOMPARE(judge(reflected, back, {1 << 20, 0.05}, kAllowed).verdict, Verdict::deviates);
            const Measurement on = test::marchedTransmittance(prepared->flat, thickness, step, 1 << 20);
            QCOMPARE(judge(through, on, {1 << 20, 0.05}, kAllowed).verdict, Verdict::deviates);
            // cosh(x / 2) - 1 is what such a march is known to be wrong by at 2.5 steps.
            const double error = std::cosh(stepDepth / 2) - 1;
            QVERIFY2(
                std::fabs(on.value / through.expected - 1 - error) < kAllowed * on.standardError / through.expected,
                qPrintable(QString("%1 instead of %2").arg(on.value / through.expected - 1).arg(error)));
        }
        const auto device = test::testedDevice();
        const Case fair = plainSlab(5);
        const Measurement got = measure(*device, fair, 1 << 20, 1, notCancelled).value();
        QCOMPARE(judge(fair, got, {1 << 20, 0.05}, kAllowed).verdict, Verdict::agrees);
    }
};

QTEST_GUILESS_MAIN(PhysicsTest)
#include "physics_test.moc"
