#include <QTest>
#include <cmath>
#include <string>
#include <vector>

#include "render/timing/efficiency.h"
#include "render/timing/least_squares.h"
#include "tests/render/paper_tables.h"

using namespace pdr;
using namespace pdr::test;

namespace {

/// Range of a figure, given the rounding of the figures that it is computed from [s].
struct Range {
    double low, high;
    bool meets(const Printed& ms) const { return low <= 1e-3 * ms.high() && 1e-3 * ms.low() <= high; }
};

double fps(const PrintedRow& row, int size) {
    return Printed::of(row[size]).value;
}

FrameParts parts(const PaperScenario& scenario, const PrintedRow& ofOne, int size) {
    const double iteration = iterationFromFrameRate(100, fps(scenario.pd100, size));
    return {iteration, otherFromFrameRate(fps(ofOne, size), iteration)};
}

Range iterationRange(const PaperScenario& scenario, int size) {
    const Printed rate = Printed::of(scenario.pd100[size]);
    return {iterationFromFrameRate(100, rate.high()), iterationFromFrameRate(100, rate.low())};
}

Range otherRange(const PrintedRow& ofOne, int size, const Range& iteration) {
    const Printed rate = Printed::of(ofOne[size]);
    return {otherFromFrameRate(rate.high(), iteration.high), otherFromFrameRate(rate.low(), iteration.low)};
}

/// Returns the printed figures of table 4 that do not follow from table 3: "93.02".
std::string unexplainedIterations(const PaperScenario& scenario) {
    std::string list;
    for (int size = 0; size < kPaperSizes; ++size)
        if (!iterationRange(scenario, size).meets(Printed::of(scenario.iterationMs[size])))
            list += std::string(scenario.iterationMs[size]) + " ";
    return list;
}

/// Returns the printed figures of table 5 that do not follow from table 2 and T_p, which is that of table 3 or as table
/// 4 prints it.
std::string unexplainedOthers(const PaperScenario& scenario, bool withPrintedIteration) {
    std::string list;
    for (const auto& [rates, others] :
         {std::pair(scenario.kroes, scenario.kroesOtherMs), std::pair(scenario.pd1, scenario.pdOtherMs)})
        for (int size = 0; size < kPaperSizes; ++size) {
            const Printed printed = Printed::of(scenario.iterationMs[size]);
            const Range iteration = withPrintedIteration ? Range{1e-3 * printed.low(), 1e-3 * printed.high()}
                                                         : iterationRange(scenario, size);
            if (!otherRange(rates, size, iteration).meets(Printed::of(others[size])))
                list += std::string(others[size]) + " ";
        }
    return list;
}

/// Fits T_p = T0 + alpha R by least squares of the relative errors.
std::array<double, kMostUnknowns> floorAndSlope(const PaperScenario& scenario) {
    std::vector<Equation> equations;
    for (int size = 0; size < kPaperSizes; ++size) {
        const double iteration = iterationFromFrameRate(100, fps(scenario.pd100, size));
        equations.push_back({{1, kPaperPixels[size]}, iteration, 1 / iteration});
    }
    return leastSquares(equations, 0b11)->unknowns;
}

bool near(double value, double expected, double halfUnit) {
    return std::fabs(value - expected) <= halfUnit * (1 + 1e-9);
}

}  // namespace

class EfficiencyTest : public QObject {
    Q_OBJECT

  private slots:
    void equationsSayTheSameInTheirOwnWays() {
        const FrameParts parts{4e-3, 9e-3};
        for (const double n : {1.0, 10.0, 100.0}) {
            const double rate = framesPerSecond(n, parts);
            QVERIFY(near(rate, 1 / (n * 4e-3 + 9e-3), 1e-12));
            QVERIFY(near(iterationsPerSecond(n, parts), n * rate, 1e-12));
            QVERIFY(near(efficiency(n, parts), n * 4e-3 * rate, 1e-12));
            QVERIFY(near(efficiencyAtFrameRate(rate, parts.other), efficiency(n, parts), 1e-12));
            QVERIFY(near(efficiencyOfManyNodes(rate, parts.other), efficiency(n, parts), 1e-12));
        }
        const double rate = framesPerSecond(1, parts);
        QVERIFY(near(otherFromFrameRate(rate, 4e-3), 9e-3, 1e-12));
        QVERIFY(near(communicationFromFrameRate(rate, 4e-3), 9e-3, 1e-12));
        QVERIFY(near(iterationFromFrameRate(100, framesPerSecond(100, parts)), 4e-3 + 9e-3 / 100, 1e-12));
    }

    void gtx560TiSpendsItsTimeAsThePaperSays() {
        const FrameParts kroes = parts(kGtx560Ti, kGtx560Ti.kroes, 0), pd = parts(kGtx560Ti, kGtx560Ti.pd1, 0);
        QVERIFY(near(1e3 * pd.iteration, 92.68, 0.005));
        QVERIFY(near(1e3 * kroes.other, 35.5, 0.05));
        QVERIFY(near(1e3 * pd.other, 9.36, 0.005));
        QVERIFY(near(efficiency(1, kroes), 0.723, 0.0005));
        QVERIFY(near(efficiency(1, pd), 0.908, 0.0005));
        QVERIFY(near(efficiency(100, pd), 0.9990, 0.00005));
        const FrameParts kroesTile = parts(kGtx560Ti, kGtx560Ti.kroes, 5), tile = parts(kGtx560Ti, kGtx560Ti.pd1, 5);
        QVERIFY(near(1e3 * tile.iteration, 0.400, 0.0005));
        QVERIFY(near(1e3 * kroesTile.other, 3.99, 0.005));
        QVERIFY(near(1e3 * tile.other, 0.922, 0.0005));
        QVERIFY(near(efficiency(1, kroesTile), 0.091, 0.0005));
        QVERIFY(near(efficiency(1, tile), 0.303, 0.0005));
        QVERIFY(near(efficiency(100, tile), 0.977, 0.0005));
    }

    void gts250SpendsItsTimeAsThePaperSays() {
        const FrameParts kroes = parts(kGts250, kGts250.kroes, 0), pd = parts(kGts250, kGts250.pd1, 0);
        QVERIFY(near(efficiency(1, kroes), 0.711, 0.0005));
        QVERIFY(near(efficiency(1, pd), 0.874, 0.0005));
        QVERIFY(near(efficiency(100, pd), 0.9986, 0.00005));
        const FrameParts kroesTile = parts(kGts250, kGts250.kroes, 5), tile = parts(kGts250, kGts250.pd1, 5);
        QVERIFY(near(efficiency(1, kroesTile), 0.410, 0.0005));
        QVERIFY(near(efficiency(1, tile), 0.730, 0.0005));
        QVERIFY(near(efficiency(100, tile), 0.9963, 0.00005));
    }

    void hundredIterationsGainWhatThePaperSays() {
        const auto gain = [](const PaperScenario& scenario, int size) {
            return 100 * fps(scenario.pd100, size) / fps(scenario.kroes, size);
        };
        QVERIFY(near(gain(kGtx560Ti, 0), 1.38, 0.005));
        QVERIFY(near(gain(kGtx560Ti, 5), 10.96, 0.005));
        QVERIFY(near(gain(kGts250, 0), 1.41, 0.005));
        QVERIFY(near(gain(kGts250, 5), 2.44, 0.005));
    }

    /// All others agree within the rounding of both. 93.02 belongs to no frame rate of the table; 1.35 was cut, not
    /// rounded.
    void tableFourFollowsFromTableThreeSaveTwoFigures() {
        QCOMPARE(unexplainedIterations(kGtx560Ti), std::string("93.02 "));
        QCOMPARE(unexplainedIterations(kGts250), std::string("1.35 "));
    }

    /// 9.48 follows from nothing printed (11.07 would). The other three follow where T_p is taken as table 4 prints it.
    void tableFiveFollowsFromTableTwoSaveFourFigures() {
        QCOMPARE(unexplainedOthers(kGtx560Ti, false), std::string("9.48 "));
        QCOMPARE(unexplainedOthers(kGts250, false), std::string("74.9 26.06 0.510 "));
        QCOMPARE(unexplainedOthers(kGtx560Ti, true), std::string("9.48 "));
        QCOMPARE(unexplainedOthers(kGts250, true), std::string(""));
    }

    /// Times that the paper calls proportional have a floor.
    void iterationOfNoPixelsTakesTime() {
        const auto fast = floorAndSlope(kGtx560Ti), slow = floorAndSlope(kGts250);
        QVERIFY(near(1e3 * fast[0], 0.328, 0.0005));
        QVERIFY(near(1e9 * fast[1], 46.7, 0.05));
        QVERIFY(near(1e3 * slow[0], 0.81, 0.005));
        QVERIFY(near(1e9 * slow[1], 285, 0.5));
    }

    /// With the floor of the GTX 560 Ti and one sample a launch, as in the paper's program, eq. 5 does not include the
    /// floor.
    void manyNodesAreLessEfficientThanThePaperHopes() {
        const FrameTimeModel model{0.328e-3, 46.7e-9, 3.8e-9, 0.92e-3};
        const FrameWork tile{60 * 34, 100, 1};
        const double seconds = frameSeconds(model, tile);
        QVERIFY(near(seconds, 100 * 0.328e-3 + 100 * 2040 * 46.7e-9 + 2040 * 3.8e-9 + 0.92e-3, 1e-12));
        QVERIFY(near(efficiencyOfManyNodes(1 / seconds, model.communication), 0.979, 0.0005));
        QVERIFY(near(sampleShare(model, tile), 0.220, 0.0005));
        QVERIFY(near(optimismOfManyNodes(model, tile), 0.979 - 0.220, 0.001));
        const FrameWork inOneLaunch{60 * 34, 100, 100};
        QVERIFY(near(sampleShare(model, inOneLaunch), 0.884, 0.0005));
    }

    void lastLaunchTakesWhatIsLeft() {
        QCOMPARE((FrameWork{1, 100, 64}).launches(), 2u);
        QCOMPARE((FrameWork{1, 128, 64}).launches(), 2u);
        QCOMPARE((FrameWork{1, 129, 64}).launches(), 3u);
        QCOMPARE((FrameWork{1, 1, 64}).launches(), 1u);
        QCOMPARE(frameSeconds({1, 1, 1, 1}, {10, 100, 64}), 2.0 + 1000 + 10 + 1);
    }
};

QTEST_GUILESS_MAIN(EfficiencyTest)
#include "efficiency_test.moc"
