#include "app/bench/scale/star_simulation.h"

#include <QTest>
#include <cmath>

using namespace pdr;
using namespace pdr::bench::scale;

namespace {

std::vector<double> evenly(double low, double high) {
    std::vector<double> costs;
    for (int i = 0; i < 1000; ++i)
        costs.push_back(low + (high - low) * (i + 0.5) / 1000);
    return costs;
}

/// Half of it air.
std::vector<double> likeAnImage() {
    std::vector<double> costs(1000, 0.05);
    const std::vector<double> tissue = evenly(1, 2.9);
    costs.insert(costs.end(), tissue.begin(), tissue.end());
    return costs;
}

struct Named {
    const char* name;
    TileCosts costs;
};

std::vector<Named> kinds() {
    return {{"alike", {}}, {"nearly alike", TileCosts(evenly(0.8, 1.2))}, {"half air", TileCosts(likeAnImage())}};
}

/// An image so large that 100,000 nodes have eight tiles each; a second of one node's time a tile's worth of nodes.
ScalingFacts facts() {
    ScalingFacts facts;
    facts.node = {50e-6, 5e-9, 1e-9, 1e-3};
    facts.work = {16384.0 * 16384, 64, 64};
    facts.leastTilePixels = 256;
    facts.link = {100e-6, 1e15, 1e-12};
    return facts;
}

double off(double told, double played) {
    return std::fabs(told / played - 1);
}

constexpr double kPromise = 0.05;

}  // namespace

/// Tests the formulas of render/timing/scaling.h: they are within 5 % of a simulation event by event, from eight tiles
/// a node on (sixteen where tiles deviate from their mean by more than it), where eight nodes or more keep the link
/// busy for less than half of the time, or would for twice as long. (Where both are as slow, nodes and link wait for
/// each other in turn, which the formulas do not model.)
class StarSimulationTest : public QObject {
    Q_OBJECT

    static void compare(const ScalingFacts& facts, Distribution how, double nodes, const char* name) {
        const ScaledFrames told = scaled(facts, how, nodes);
        const auto played = simulated(facts, how, std::int64_t(nodes));
        QVERIFY(played);
        const QString words = QString("%1, %2 nodes: rate %3 foretold, %4 played; latency %5, %6")
                                  .arg(name)
                                  .arg(nodes)
                                  .arg(told.framesPerSecond)
                                  .arg(played->framesPerSecond)
                                  .arg(told.latency)
                                  .arg(played->latency);
        QVERIFY2(off(told.framesPerSecond, played->framesPerSecond) < kPromise, qPrintable(words));
        QVERIFY2(off(told.latency, played->latency) < kPromise, qPrintable(words));
        QCOMPARE(told.bytes, played->bytes);
        QCOMPARE(told.messages, played->messages);
        QCOMPARE(told.busy, played->busy);
    }

    /// The link busy for `load` of the time of so many nodes.
    static ScalingFacts loaded(const ScalingFacts& plain, Distribution how, double nodes, double load) {
        ScalingFacts facts = plain;
        facts.link.bytesPerSecond = 1e30;
        facts.link.messageSeconds = 0;
        const ScaledFrames frames = scaled(facts, how, nodes);
        facts.link.messageSeconds = load / frames.framesPerSecond / (frames.messages / 2);
        return facts;
    }

  private slots:
    void tilesComeAsForetold() {
        for (const Named& kind : kinds())
            for (const int tiles : {8, 32})
                for (const double nodes : {1.0, 2.0, 8.0, 64.0, 1000.0}) {
                    ScalingFacts some = facts();
                    some.tiles = kind.costs;
                    some.tilesPerNode = tiles;
                    compare(some, Distribution::sortFirst, nodes, kind.name);
                }
    }

    /// Four fifths of it air, the rest from little to much: tiles deviate by twice their mean.
    void veryUnlikeTilesComeAsForetoldFromSixteenOn() {
        std::vector<double> costs = evenly(1, 9);
        costs.insert(costs.end(), 4 * costs.size(), 0.02);
        ScalingFacts some = facts();
        some.tiles = TileCosts(costs);
        QVERIFY(some.tiles.deviation() > 2);
        for (const int tiles : {16, 64})
            for (const double nodes : {2.0, 4.0, 64.0, 1000.0}) {
                some.tilesPerNode = tiles;
                compare(some, Distribution::sortFirst, nodes, "four fifths air");
            }
    }

    void tilesOfAHundredThousandNodesToo() {
        for (const Named& kind : kinds()) {
            ScalingFacts some = facts();
            some.tiles = kind.costs;
            QCOMPARE(tileCut(some, 100'000).tilesPerNode, 8.0);
            compare(some, Distribution::sortFirst, 100'000, kind.name);
        }
    }

    void aLinkThatIsBusyIsForetold() {
        for (const Named& kind : kinds())
            for (const double load : {0.1, 0.5, 2.0, 10.0})
                for (const double nodes : {8.0, 64.0, 1000.0}) {
                    ScalingFacts some = facts();
                    some.tiles = kind.costs;
                    some = loaded(some, Distribution::sortFirst, nodes, load);
                    compare(some, Distribution::sortFirst, nodes,
                            qPrintable(QString("%1, link %2").arg(kind.name).arg(load)));
                }
    }

    void farNodesAreForetold() {
        ScalingFacts far = facts();
        far.link.latency = 20e-3;
        for (const Named& kind : kinds()) {
            far.tiles = kind.costs;
            compare(far, Distribution::sortFirst, 64, kind.name);
        }
    }

    void blocksOfSamplesComeAsForetold() {
        ScalingFacts some = facts();
        some.work.pixels = 1920 * 1080;
        some.work.iterations = 64 * 100;
        for (const double load : {0.01, 0.5, 2.0})
            for (const double nodes : {1.0, 2.0, 7.0, 64.0, 100.0, 1000.0})
                compare(loaded(some, Distribution::sampleFirst, nodes, load), Distribution::sampleFirst, nodes,
                        qPrintable(QString("link %1").arg(load)));
    }

    void theLastBlockMayBeShort() {
        ScalingFacts some = facts();
        some.work.pixels = 1920 * 1080;
        for (const std::uint32_t samples : {1, 63, 65, 100, 200})
            for (const double nodes : {1.0, 2.0, 7.0}) {
                some.work.iterations = samples;
                compare(some, Distribution::sampleFirst, nodes, qPrintable(QString("%1 samples").arg(samples)));
            }
    }

    void alternateFramesComeAsForetold() {
        ScalingFacts some = facts();
        some.work.pixels = 1920 * 1080;
        for (const double load : {0.01, 0.4, 3.0})
            for (const double nodes : {1.0, 2.0, 64.0, 10'000.0})
                compare(loaded(some, Distribution::alternateFrames, nodes, load), Distribution::alternateFrames, nodes,
                        qPrintable(QString("link %1").arg(load)));
    }

    void whatIsNoStarIsNotPlayed() {
        QVERIFY(!simulated(facts(), Distribution::sortLast, 8));
        QVERIFY(!simulated(facts(), Distribution::sampleFirstInTree, 8));
    }

    /// Two nodes, three pieces of 1 s, a result takes 0.5 s, a message 0.25 s one way: told by hand.
    void playedByHand() {
        const StarTimes times = play({{1, 1, 1}, 2, 0, {0.25, 1, 0}, 0.5});
        QCOMPARE(times.latency, 2 + 0.25 + 1 + 0.25 + 0.5 - 0.0 + (0.25 + 1 + 0.25 + 0.5 - 2));
        QCOMPARE(times.link, 1.5);
        QCOMPARE(times.computed, 2.0 + 0.25 + 1 - 0.25);
    }

    void equalSeedsPlayTheSame() {
        ScalingFacts some = facts();
        some.tiles = TileCosts(likeAnImage());
        QCOMPARE(simulated(some, Distribution::sortFirst, 8, 3)->latency,
                 simulated(some, Distribution::sortFirst, 8, 3)->latency);
        QVERIFY(simulated(some, Distribution::sortFirst, 8, 3)->latency !=
                simulated(some, Distribution::sortFirst, 8, 4)->latency);
    }
};

QTEST_GUILESS_MAIN(StarSimulationTest)
#include "star_simulation_test.moc"
