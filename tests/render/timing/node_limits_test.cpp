/// What ends the gain of more nodes, and when all of them have the scan.

#include "render/timing/node_limits.h"

#include <QTest>
#include <cmath>

using namespace pdr;

namespace {

/// A node of 2 million samples a second and 200 a pixel: a frame of a million pixels takes it 100 s.
ScalingFacts facts() {
    ScalingFacts facts;
    facts.node = {0, 0.5e-6, 0, 0};
    facts.work = {1e6, 200, 64};
    facts.tilesPerNode = 10;
    facts.leastTilePixels = 100;
    facts.link = {1e-3, 1e8, 1e-4};
    facts.pixelBytes = 20;
    facts.orderBytes = 4;
    facts.checkedPart = 0;
    facts.scanBytes = 2e8;
    return facts;
}

double nodesOf(const ScalingFacts& facts, NodeLimit limit) {
    for (const LimitedNodes& one : limitsOf(facts))
        if (one.limit == limit)
            return one.nodes;
    return NAN;
}

bool near(double value, double expected) {
    return std::fabs(value - expected) <= 1e-9 * std::fabs(expected);
}

}  // namespace

class NodeLimitsTest : public QObject {
    Q_OBJECT

  private slots:
    void eachLimitIsWhereAllIsTaken() {
        QVERIFY(near(nodesOf(facts(), NodeLimit::results), 500));   // 20 MB each 100 s, of 100 MB/s
        QVERIFY(near(nodesOf(facts(), NodeLimit::orders), 2500));   // 4 MB
        QVERIFY(near(nodesOf(facts(), NodeLimit::tiles), 10'000));  // of 100 pixels
        // 316 nodes: 3162 results a frame, 3.16 frames a second, 0.1 ms each
        QVERIFY(near(nodesOf(facts(), NodeLimit::messages), std::sqrt(1e5)));
    }

    void theLowestIsFirst() {
        const std::vector<LimitedNodes> limits = limitsOf(facts());
        QCOMPARE(limits.size(), 4u);
        QCOMPARE(limits.front().limit, NodeLimit::messages);
        QCOMPARE(limits.back().limit, NodeLimit::tiles);
    }

    void whatIsFreeIsNoLimit() {
        ScalingFacts free = facts();
        free.link.messageSeconds = 0;
        QVERIFY(std::isinf(nodesOf(free, NodeLimit::messages)));
    }

    /// Nodes that check each other are slower, so more of them fit on a link; a node alone checks nobody.
    void checksTakeTimeOfNodes() {
        ScalingFacts checking = facts();
        checking.checkedPart = 0.25;
        QVERIFY(near(nodesOf(checking, NodeLimit::results), 625));
        const auto rate = [](const ScalingFacts& facts, double nodes) {
            return scaled(facts, Distribution::alternateFrames, nodes).framesPerSecond;
        };
        QVERIFY(near(rate(checking, 1), rate(facts(), 1)));
        QVERIFY(std::fabs(rate(facts(), 4) / rate(checking, 4) - 1.25) < 0.01);
    }

    /// The limit of the link is where frames cease to come more often.
    void theLinkIsTheEndOfFramesToo() {
        ScalingFacts fast = facts();
        fast.link = {0, 1e8, 0};
        fast.leastTilePixels = 1;
        const double limit = nodesOf(fast, NodeLimit::results);
        const auto rate = [&](double nodes) { return scaled(fast, Distribution::sortFirst, nodes).framesPerSecond; };
        QVERIFY(near(rate(10 * limit), 5));
        QVERIFY(rate(0.9 * limit) < 0.91 * rate(10 * limit));
        QVERIFY(rate(0.9 * limit) > 0.8 * rate(10 * limit));
    }

    void relaysSendTheScanAtTheSameTime() {
        QVERIFY(near(scanSeconds(facts(), 100), 1e-3 + 200));
        ScalingFacts relayed = facts();
        relayed.relays = 10;
        QVERIFY(near(scanSeconds(relayed, 100), 2 * (1e-3 + 20)));
        QVERIFY(near(scanSeconds(relayed, 101), 2 * 1e-3 + 20 + 22));
    }
};

QTEST_GUILESS_MAIN(NodeLimitsTest)
#include "node_limits_test.moc"
