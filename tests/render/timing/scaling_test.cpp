#include "render/timing/scaling.h"

#include <QTest>
#include <cmath>

using namespace pdr;

namespace {

/// The paper's first machine, GTX 560 Ti, and full HD; n = 100, a launch for each sample as its program makes them.
ScalingFacts paperFacts(std::uint32_t perLaunch = 1) {
    ScalingFacts facts;
    facts.node = {0.328e-3, 46.7e-9, 3.8e-9, 0.92e-3};
    facts.work = {1920 * 1080, 100, perLaunch};
    facts.tilesPerNode = 1;
    facts.leastTilePixels = 1;
    facts.link = {0, 1e30, 0};
    facts.pixelBytes = 4;
    facts.sumBytes = 16;
    facts.checkedPart = 0;
    return facts;
}

bool near(double value, double expected, double relative = 1e-9) {
    return std::fabs(value - expected) <= relative * std::fabs(expected);
}

}  // namespace

class ScalingTest : public QObject {
    Q_OBJECT

  private slots:
    void oneNodeIsTheModelOfOneNode() {
        const ScalingFacts facts = paperFacts();
        const double seconds = frameSeconds(facts.node, facts.work);
        for (const Distribution how :
             {Distribution::sortFirst, Distribution::alternateFrames, Distribution::sortLast}) {
            const ScaledFrames one = scaled(facts, how, 1);
            QVERIFY(near(one.framesPerSecond, 1 / seconds));
            QVERIFY(near(one.efficiency, sampleShare(facts.node, facts.work)));
            QVERIFY(near(one.latency, seconds));
        }
    }

    /// f.2: E = n alpha R/m / (n (T0 + alpha R/m) + beta R/m + Tc).
    void manyNodesMeetTheFloorThatThePaperLeavesOut() {
        const ScalingFacts facts = paperFacts();
        for (const double nodes : {2.0, 100.0, 1000.0}) {
            const double pixels = 1920 * 1080 / nodes;
            const double seconds = 100 * (0.328e-3 + 46.7e-9 * pixels) + 3.8e-9 * pixels + 0.92e-3;
            const ScaledFrames frames = scaled(facts, Distribution::sortFirst, nodes);
            QVERIFY(near(frames.efficiency, 100 * 46.7e-9 * pixels / seconds));
            QVERIFY(near(frames.paper, 1 - 0.92e-3 / seconds));
        }
        QVERIFY(scaled(facts, Distribution::sortFirst, 1000).paper > 0.97);
        QVERIFY(scaled(facts, Distribution::sortFirst, 1000).efficiency < 0.23);
        // One launch for all samples of a frame pays the floor once.
        QVERIFY(scaled(paperFacts(100), Distribution::sortFirst, 1000).efficiency > 0.88);
    }

    void tilesAreSmallerThanTheFloorFromSevenThousandPixelsOn() {
        const ScalingFacts facts = paperFacts();
        QVERIFY(near(floorPixels(facts.node, facts.work), 0.328e-3 / 46.7e-9));
        QVERIFY(near(floorNodes(facts), 1920 * 1080 / (0.328e-3 / 46.7e-9)));
        ScalingFacts large = facts;
        large.leastTilePixels = 10'000;
        QVERIFY(std::isinf(floorNodes(large)));
        large.node.launch = 0;
        QVERIFY(std::isinf(floorNodes(large)));
    }

    void noMoreNodesAreBusyThanThereAreTiles() {
        ScalingFacts facts = paperFacts(100);
        facts.leastTilePixels = 256;
        facts.tilesPerNode = 8;
        const ScaledFrames few = scaled(facts, Distribution::sortFirst, 8100),
                           many = scaled(facts, Distribution::sortFirst, 100'000);
        QCOMPARE(few.busy, 8100.0);
        QCOMPARE(many.busy, 8100.0);
        QVERIFY(near(many.framesPerSecond, few.framesPerSecond));
        QVERIFY(near(many.efficiency, few.efficiency * 0.081));
        QCOMPARE(tileCut(facts, 2000).tilesPerNode, 4.0);
        QCOMPARE(tileCut(facts, 10).tilesPerNode, 8.0);
    }

    void theLinkIsTheEndOfIt() {
        ScalingFacts facts = paperFacts(100);
        facts.link = {0, 125e6, 0};
        const double most = 125e6 / (4 * 1920 * 1080);
        for (const Distribution how : {Distribution::sortFirst, Distribution::alternateFrames})
            QVERIFY(near(scaled(facts, how, 100'000).framesPerSecond, most));
        QVERIFY(scaled(facts, Distribution::sampleFirst, 2).framesPerSecond < most / 4);
    }

    /// Alternate frames come as often as frames in tiles, but as late as those of one node.
    void alternateFramesAreLate() {
        const ScalingFacts facts = paperFacts(100);
        const ScaledFrames tiles = scaled(facts, Distribution::sortFirst, 10),
                           frames = scaled(facts, Distribution::alternateFrames, 10);
        QVERIFY(near(frames.latency, frameSeconds(facts.node, facts.work)));
        QVERIFY(frames.latency > 9 * tiles.latency);
        QVERIFY(frames.framesPerSecond >= tiles.framesPerSecond);
    }

    void samplesAreSharedInBlocks() {
        ScalingFacts facts = paperFacts(64);
        facts.work.iterations = 256;
        QCOMPARE(scaled(facts, Distribution::sampleFirst, 100).busy, 4.0);
        QCOMPARE(scaled(facts, Distribution::sampleFirst, 3).busy, 3.0);
        QCOMPARE(scaled(facts, Distribution::sampleFirst, 100).bytes, 4.0 * 16 * 1920 * 1080);
        QVERIFY(near(scaled(facts, Distribution::sampleFirst, 3).framesPerSecond,
                     scaled(facts, Distribution::sampleFirst, 2).framesPerSecond));
    }

    void sumsAddedOnTheWaySpareTheLink() {
        ScalingFacts facts = paperFacts(64);
        facts.work.iterations = 6400;
        facts.link = {100e-6, 1.25e9, 20e-6};
        facts.node.sample = 1e-9;
        QVERIFY(scaled(facts, Distribution::sampleFirstInTree, 100).framesPerSecond >
                5 * scaled(facts, Distribution::sampleFirst, 100).framesPerSecond);
    }

    /// 28 bytes a sample of a pixel against 4 a pixel.
    void bricksSendSevenHundredTimesTheBytes() {
        const ScalingFacts facts = paperFacts();
        const double ratio =
            scaled(facts, Distribution::sortLast, 1000).bytes / scaled(facts, Distribution::sortFirst, 1000).bytes;
        QVERIFY(ratio > 650 && ratio < 750);
    }

    void unlikeTilesCostFrames() {
        ScalingFacts alike = paperFacts(100), unlike = alike;
        alike.tilesPerNode = unlike.tilesPerNode = 8;
        unlike.tiles = TileCosts({0.1, 0.1, 0.5, 1.5, 2.8});
        const double ratio = scaled(unlike, Distribution::sortFirst, 100).framesPerSecond /
                             scaled(alike, Distribution::sortFirst, 100).framesPerSecond;
        QVERIFY(ratio < 0.9 && ratio > 0.7);
    }
};

QTEST_GUILESS_MAIN(ScalingTest)
#include "scaling_test.moc"
