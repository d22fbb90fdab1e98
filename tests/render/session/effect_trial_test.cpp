/// The costs of effects: the statistics with made-up clocks, the images with a small scene.

#include <QTest>

#include <random>

#include "render/session/effect_trial.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

/// A machine with a made-up clock: an iteration takes `seconds`, more with every measurement by `drift`, each off by up
/// to `noise` of itself.
struct Machine {
    double drift = 0, noise = 0;
    double spent = 0;
    int measurements = 0;
    std::mt19937 random{7};

    Iterate image(double seconds) {
        return [this, seconds](std::uint32_t n, const std::stop_token&) -> Result<double> {
            const double off = noise * std::uniform_real_distribution<double>(-1, 1)(random);
            const double took = n * seconds * (1 + drift * measurements++ + off);
            spent += took;
            return took;
        };
    }
};

/// Takes all steps of the measurement; returns false if one failed.
bool finish(CostsInTurn& costs) {
    while (!costs.isDone())
        if (!costs.step())
            return false;
    return true;
}

CostBand addedCost(Iterate with, Iterate without, double budgetSeconds) {
    CostsInTurn costs({std::move(with), std::move(without)}, budgetSeconds);
    return finish(costs) ? costs.added() : CostBand();
}

}  // namespace

class EffectTrialTest : public QObject {
    Q_OBJECT

  private slots:
    void aBandHoldsItsMedian() {
        const CostBand band = bandOf({3, -1, 2, 7, 0, 1});
        QCOMPARE(band.low, -1.0);
        QCOMPARE(band.middle, 1.5);
        QCOMPARE(band.high, 7.0);
        QCOMPARE(bandOf({4, 1, 9}).middle, 4.0);
    }

    void noCostIsEverNegative() {
        QCOMPARE(costText({2.02, 2.19, 2.304}), std::string("2.19 (2.02 to 2.30)"));
        QCOMPARE(costText({-1.33, -1.2, -1.01}), std::string("saves 1.20 (1.01 to 1.33)"));
        QCOMPARE(costText({-2.66, -0.2, 0.31}), std::string("< 0.31"));
        QCOMPARE(costText({-2, -1, 0}), std::string("< 0.01"));
        QCOMPARE(costText({0, 0, 0}), std::string("< 0.01"));
        QVERIFY(verdictOf({0.1, 0.2, 0.3}) == CostVerdict::costs);
        QVERIFY(verdictOf({-0.1, 0.2, 0.3}) == CostVerdict::withinNoise);
    }

    void whatCostsMoreThanTheNoiseIsTold() {
        Machine machine{.noise = 0.05};
        const auto cost = addedCost(machine.image(0.012), machine.image(0.010), 1);
        QVERIFY(verdictOf(cost) == CostVerdict::costs);
        QVERIFY(cost.low < 2 && cost.high > 2 && cost.low > 1 && cost.high < 3);
    }

    /// A machine that slows down all the time, or noise, must not look like the cost of an effect that costs nothing.
    void nothingCostsNothing() {
        int told = 0;
        for (unsigned seed = 0; seed < 400; ++seed) {
            Machine machine{.drift = 0.01, .noise = 0.1, .random = std::mt19937(seed)};
            const auto cost = addedCost(machine.image(0.01), machine.image(0.01), 1);
            told += verdictOf(cost) != CostVerdict::withinNoise;
        }
        QVERIFY2(told < 400 * 0.06, qPrintable(QString::number(told)));  // 3 of 100 are to be expected
        Machine drifting{.drift = 0.05};
        QVERIFY(verdictOf(addedCost(drifting.image(0.01), drifting.image(0.01), 1)) == CostVerdict::withinNoise);
    }

    void theBudgetIsKept() {
        for (const double seconds : {1e-7, 1e-4, 1e-3, 0.03}) {
            Machine machine;
            addedCost(machine.image(2 * seconds), machine.image(seconds), 1);
            QVERIFY2(machine.spent <= 1.001, qPrintable(QString::number(machine.spent)));
            QCOMPARE(machine.measurements, 2 + 2 * kBandMeasurements);
        }
        Machine slow;  // one iteration each, however slow
        addedCost(slow.image(1), slow.image(1), 1);
        QVERIFY(slow.spent < 2 + 2 * kBandMeasurements + 0.001);
        Machine many;
        CostsInTurn costs({many.image(0.001), many.image(0.02), many.image(0.005)}, 2);
        QVERIFY(finish(costs) && many.spent <= 2.001);
        QVERIFY(std::fabs(costs.bands()[1].middle - 20) < 1e-9 && std::fabs(costs.bands()[2].low - 5) < 1e-9);
        QVERIFY(std::fabs(costs.share().middle + 19) < 1e-9);  // an effect that saves time may be left out, too
    }

    void aFailureIsPassedOn() {
        const Iterate broken = [](std::uint32_t, const std::stop_token&) -> Result<double> {
            return Error{"gone", "device", ""};
        };
        Machine machine;
        CostsInTurn costs({machine.image(0.1), broken}, 1);
        QVERIFY(bool(costs.step()));
        QCOMPARE(costs.step().error().what, std::string("gone"));
    }

    void withoutItsShareAnIterationTakesTheRest() {
        Machine machine;
        CostsInTurn costs({machine.image(0.02), machine.image(0.005)}, 1);
        QVERIFY(finish(costs));
        QVERIFY(std::fabs(costs.share().middle - 0.75) < 1e-9 && std::fabs(costs.added().middle - 15) < 1e-9);
    }

    /// Three times the samples, each at a quarter of the cost; both are uncertain.
    void priceAndNoiseMakeTheTime() {
        const Foretold time = timeWithout({3, 2, 4.5}, {0.7, 0.75, 0.8});
        QVERIFY(std::fabs(time.value - 0.75) < 1e-9);
        QVERIFY(time.low < 0.5 && time.low > 0.4 && time.high > 1.125 && time.high < 1.35);
        const Foretold sure = timeWithout({1, 1, 1}, {0, 0, 0});
        QVERIFY(sure.value == 1 && sure.low == 1 && sure.high == 1);
    }

    void aTrialsFilmIsAsSmallAsTheBudgetAsks() {
        Scene scene = test::plainScene(test::bumpyVolume({30, 30, 30}, dvec3(1), 1), 0.3f);
        scene.film = {1000, 500};
        const auto device = makeCpuDevice(1);
        const auto film = [&](double seconds) { return *trialFilm(scene, *device, 200, seconds); };
        QVERIFY(film(1e3) == ivec2(200, 100));
        QVERIFY(film(1e-9) == ivec2(16, 8));
        scene.film = {20, 40};
        QVERIFY(film(1e3) == ivec2(20, 40));
    }
};

QTEST_APPLESS_MAIN(EffectTrialTest)
#include "effect_trial_test.moc"
