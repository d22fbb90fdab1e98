/// The statement of an image's bias: its size, from pixels whose bias and noise are given, and its causes.

#include <QTest>

#include <cmath>
#include <random>
#include <set>

#include "render/accuracy/bias.h"
#include "render/film/tone_curve.h"

using namespace pdr;

namespace {

/// Pixels from dark to bright, `factor` times too bright when rendered with the bias. Both halves of both ways are off
/// by `noise` of the truth.
struct Lattice {
    double factor, noise;
    unsigned seed = 1;
    int tiles = 200;

    std::vector<BiasTile> made() const {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal;
        std::vector<BiasTile> all;
        for (int t = 0; t < tiles; ++t) {
            const double truth = brightness(t);
            const auto draw = [&](double mean) { return dvec3(mean * (1 + noise * normal(random))); };
            BiasTile& tile = all.emplace_back();
            for (int i = 0; i < 16; ++i)
                tile.push_back({{draw(factor * truth), draw(factor * truth)}, {draw(truth), draw(truth)}});
        }
        return all;
    }
    double brightness(int tile) const { return 0.05 + 0.9 * tile / tiles; }
    /// Returns twice the root mean square bias over the pixels.
    double levels() const {
        const auto level = [](double radiance) { return double(exactLevelOf(displayCurve(), float(radiance))); };
        double squares = 0;
        for (int t = 0; t < tiles; ++t)
            squares += std::pow(level(factor * brightness(t)) - level(brightness(t)), 2);
        return 2 * std::sqrt(squares / tiles);
    }
    MeasuredBias measured() const { return *measuredBias(made(), 1); }
};

bool holds(const Between& between, double truth) {
    return between.low <= truth && truth <= between.high;
}

std::set<std::string> namesOf(const BiasFacts& facts) {
    std::set<std::string> names;
    for (const Bias& bias : biases(facts))
        names.insert(biasName(bias.cause));
    return names;
}

}  // namespace

class BiasTest : public QObject {
    Q_OBJECT

  private slots:
    /// Without the halves, noise of half a pixel's light would be the larger part of the result.
    void theBiasIsFoundBelowItsNoise() {
        int brightness = 0, levels = 0;
        constexpr int kSeeds = 100;
        for (unsigned seed = 1; seed <= kSeeds; ++seed) {
            const Lattice lattice{1.2, 0.3, seed};
            const MeasuredBias bias = lattice.measured();
            brightness += holds(bias.brightness, 0.2);
            levels += holds(bias.levels, lattice.levels());
            QVERIFY(bias.levels.value < 1.5 * lattice.levels() && bias.levels.value > lattice.levels() / 1.5);
        }
        // at 95 %, 87 or fewer of 100 occur once in 1,000 runs
        QVERIFY2(brightness > 87 && levels > 87, qPrintable(QString("%1, %2").arg(brightness).arg(levels)));
    }

    void whereThereIsNoneNoneIsSeen() {
        int seen = 0;
        for (unsigned seed = 1; seed <= 100; ++seed)
            seen += Lattice{1, 0.3, seed}.measured().levels.low > 0;
        QVERIFY2(seen <= 9, qPrintable(QString::number(seen)));  // 2.5 are to be expected; 10 once in 3,000
        const Lattice still{1, 0.01}, noisy{1, 0.3};
        QVERIFY(still.measured().levels.high < 0.1 * noisy.measured().levels.high);
    }

    void ofTooLittleNothingIsSaid() {
        std::vector<BiasTile> tiles = Lattice{1.2, 0.1, 1, 15}.made();
        QVERIFY(!measuredBias(tiles, 1));
        tiles.emplace_back();  // without tissue
        QVERIFY(!measuredBias(tiles, 1));
        const std::vector<BiasTile> black(20, BiasTile(4));
        QVERIFY(!measuredBias(black, 1));
    }

    void noBiasIsKnownWhereThereIsNoneAndOnlyThere() {
        const BiasFacts exact{.tissuePixels = 1000};
        QVERIFY(biases(exact).empty() && noneOfComputing(biases(exact)));
        const auto says = [&](const char* name, auto change) {
            BiasFacts facts = exact;
            change(facts);
            return namesOf(facts) == std::set<std::string>{name} && !noneOfComputing(biases(facts));
        };
        QVERIFY(says("march", [](BiasFacts& f) { f.estimator = Estimator::kroesMarch; }));
        QVERIFY(says("blur", [](BiasFacts& f) { f.schedule = {Schedule::Kind::kroes, false, true, false}; }));
        QVERIFY(says("runningMean", [](BiasFacts& f) { f.schedule = {Schedule::Kind::kroes, false, false, true}; }));
        QVERIFY(says("fastFilter", [](BiasFacts& f) { f.texturesFilter = true; }));
        QVERIFY(says("quadrature", [](BiasFacts& f) { f.model = Model::absorption; }));
        QVERIFY(says("overDense", [](BiasFacts& f) { f.denseWarning = "dense"; }));
        QVERIFY(says("smoothing", [](BiasFacts& f) { f.isDenoised = true; }));
        const char* kFaultBias[kFaults] = {"leftOut", "leftOut", "leftOut", "overBound", "bounceCap", "overTolerance"};
        for (int fault = 0; fault < kFaults; ++fault)
            QVERIFY(says(kFaultBias[fault], [&](BiasFacts& f) { f.health.add(Fault(fault), 0, 0); }));
        BiasFacts shown = exact;
        shown.image = {10, 10};
        shown.view = {20, 20};
        shown.slicesInterpolated = true;
        const std::set<std::string> ofView{"resolution", "interpolatedSlices"};
        QCOMPARE(namesOf(shown), ofView);
        QVERIFY(noneOfComputing(biases(shown)));
        BiasFacts projection = exact;
        projection.model = Model::maximumIntensity;
        QVERIFY(biases(projection).empty());
    }

    void aBoundIsGivenWhereThereIsOne() {
        BiasFacts facts{.model = Model::emission, .toleranceLevels = 0.25, .tissuePixels = 1000};
        facts.health.add(Fault::cutPath, 0, 7);
        facts.health.add(Fault::cutPath, 1, 7);
        const std::vector<Bias> known = biases(facts);
        QCOMPARE(known.size(), std::size_t(2));
        QCOMPARE(*known[0].levelsAtMost, 0.25);
        QCOMPARE(*known[1].shareAtMost, 0.002);
        QVERIFY(known[1].text.ends_with("in at most 0.2 % of the tissue"));
        facts.tissuePixels = 2;  // perhaps all of it
        QVERIFY(!biases(facts)[1].shareAtMost);
    }

    void roundingAndToleranceAreMeasuredToo() {
        BiasFacts facts{.model = Model::emissionAbsorption, .toleranceLevels = 0.25};
        QVERIFY(needsMeasuring(facts) && sumsToATolerance(facts) && !keepsRunningMean(facts));
        facts.measured.quadrature = MeasuredBias{{0, 0, 0}, {0.14, 0.12, 0.17}};
        QVERIFY(QString::fromStdString(biases(facts)[0].text).endsWith("within ±0.2 levels (0.2 to 0.2)"));
        QVERIFY(biases(facts)[0].measured && biases(facts)[0].levelsAtMost);
        facts = {.schedule = {Schedule::Kind::kroes, false, false, true}};
        QVERIFY(needsMeasuring(facts) && keepsRunningMean(facts) && !sumsToATolerance(facts));
        QVERIFY(biases(facts)[0].text.ends_with("how much is not known yet"));
        facts.measured.runningMean = MeasuredBias{{0, 0, 0}, {3e-5, 2e-5, 4e-5}};
        QVERIFY(biases(facts)[0].measured);
    }

    void whatWasNotMeasuredIsCalledUnknown() {
        BiasFacts facts{.estimator = Estimator::kroesMarch, .texturesFilter = true};
        QVERIFY(needsMeasuring(facts) && !needsMeasuring({}));
        QCOMPARE(QString::fromStdString(biases(facts)[0].text),
                 QString("march of 3 voxels, fast filter: how much is not known yet"));
        facts.measured.shortcuts = MeasuredBias{{0.097, 0.091, 0.103}, {12, 10, 14}};
        QCOMPARE(QString::fromStdString(biases(facts)[0].text),
                 QString::fromUtf8("march of 3 voxels, fast filter: +9.7 % bright (+9.1 to +10.3), 95 % of the tissue "
                                   "within ±12 levels (10 to 14)"));
        facts.measured.shortcuts->levels = {0.2, 0, 0.4};
        QVERIFY(QString::fromStdString(biases(facts)[0].text)
                    .endsWith(QString::fromUtf8("within ±0.4 levels at most, by now not told from none")));
    }
};

QTEST_GUILESS_MAIN(BiasTest)
#include "bias_test.moc"
