#include "render/timing/split_choice.h"

#include <QTest>
#include <cmath>

using namespace pdr;

namespace {

/// Full HD on GPUs like the paper's first, 50 us away.
SplitFacts facts() {
    return {.pixels = 1920 * 1080,
            .samples = 6400,
            .nodes = 100,
            .sampleSeconds = 1e-9,
            .launchSeconds = 2e-3,
            .latencySeconds = 50e-6,
            .bytesPerSecond = 1.25e9,
            .bytesPerPixel = 0.1};
}

}  // namespace

class SplitChoiceTest : public QObject {
    Q_OBJECT

  private slots:
    void samplesWhereTilesWouldBeSmallerThanTheStart() {
        const SplitChoice choice = chooseSplit(facts());
        QCOMPARE(choice.split, Split::samples);
        QVERIFY(std::abs(choice.workSeconds - 64 * 1e-9 * 1920 * 1080 / 100) < 1e-12);
        QVERIFY(std::abs(choice.startSeconds - 2.1e-3) < 1e-12);
        QCOMPARE(choice.reason,
                 std::string("tiles would be smaller than what a render node needs to start: 1.3 ms of 2.1 ms"));
        QVERIFY(choice.samplesSeconds < choice.tilesSeconds);
    }

    void tilesWhereTheyKeepANodeBusy() {
        SplitFacts few = facts();
        few.nodes = 10;
        const SplitChoice choice = chooseSplit(few);
        QCOMPARE(choice.split, Split::tiles);
        QCOMPARE(choice.reason,
                 std::string("a tile keeps a render node busy for longer than it needs to start: 13 ms, 2.1 ms"));
    }

    void onlyWholeBlocksAreShared() {
        SplitFacts one = facts();
        one.samples = 127;
        QCOMPARE(chooseSplit(one).split, Split::tiles);
        QVERIFY(QString::fromStdString(chooseSplit(one).reason).contains("blocks of 64"));
        one.nodes = 100'000;
        one.samples = 0;
        QCOMPARE(chooseSplit(one).split, Split::tiles);
    }

    /// Two blocks keep two nodes busy: tiles use them all.
    void fewBlocksForManyNodesAreNoGain() {
        SplitFacts few = facts();
        few.samples = 128;
        const SplitChoice choice = chooseSplit(few);
        QCOMPARE(choice.split, Split::tiles);
        QVERIFY(choice.samplesSeconds > choice.tilesSeconds);
        QVERIFY(QString::fromStdString(choice.reason).startsWith("there are too few blocks of 64 samples"));
    }

    void aSlowNetworkDecidesNothing() {
        SplitFacts slow = facts();
        slow.bytesPerSecond = 1e6;
        slow.bytesPerPixel = 16;
        const SplitChoice choice = chooseSplit(slow);
        QCOMPARE(choice.split, Split::tiles);
        QCOMPARE(choice.tilesSeconds, choice.samplesSeconds);
        QVERIFY(QString::fromStdString(choice.reason).startsWith("the network takes longest"));
        slow.bytesPerSecond = 0;  // unknown
        QCOMPARE(chooseSplit(slow).split, Split::samples);
    }

    void aloneThereIsNothingToShare() {
        SplitFacts alone = facts();
        alone.nodes = 1;
        QCOMPARE(chooseSplit(alone).split, Split::tiles);
        QCOMPARE(chooseSplit(alone).reason, std::string("one render node has the whole image"));
    }

    /// The chosen way is always the one that is predicted to be sooner.
    void theSoonerOneIsChosen() {
        for (const int nodes : {1, 2, 3, 8, 100, 1000, 100'000})
            for (const std::uint64_t samples : {1u, 64u, 128u, 1000u, 64'000u})
                for (const double launch : {0.0, 1e-5, 1e-3, 0.1}) {
                    SplitFacts some = facts();
                    some.nodes = nodes, some.samples = samples, some.launchSeconds = launch;
                    const SplitChoice choice = chooseSplit(some);
                    if (choice.split == Split::samples)
                        QVERIFY(choice.samplesSeconds < choice.tilesSeconds);
                    QVERIFY(!choice.reason.empty());
                }
    }
};

QTEST_GUILESS_MAIN(SplitChoiceTest)
#include "split_choice_test.moc"
