/// Every pixel of a part gets its samples once per pass, in whatever pieces; pixels that lag behind go first.

#include <QTest>

#include "render/session/sweep.h"

using namespace pdr;

namespace {

constexpr Tile kWhole{0, 0, 100, 70};  // its last cells are cut
constexpr Tile kRegion{20, 16, 30, 20};
constexpr Tile kRegionCells{16, 16, 48, 32};

/// Carries out a pass of n samples, in pieces of about so many pixels; returns the number of pieces.
int pass(Sweep& sweep, const Tile& part, std::uint32_t n, double pixels = 1e9) {
    sweep.choose(part);
    sweep.begin(n);
    int pieces = 0;
    while (sweep.isHalfMade()) {
        sweep.took(sweep.next(pixels));
        ++pieces;
    }
    return pieces;
}

}  // namespace

class SweepTest : public QObject {
    Q_OBJECT

  private slots:
    void aWholePassIsOnePiece() {
        Sweep sweep{TileProgress(kWhole)};
        QVERIFY(!sweep.isHalfMade());
        sweep.begin(7);
        QVERIFY(sweep.isHalfMade());
        const Sweep::Order order = sweep.next(1e9);
        QVERIFY(order.tile == kWhole);
        QCOMPARE(order.n, 7U);
        QCOMPARE(sweep.took(order), 7U);
        QVERIFY(!sweep.isHalfMade());
        QCOMPARE(sweep.samples(), (SampleCounts{7, 7, 7}));
    }

    void aPassComesInBandsOfWholeCells_data() {
        QTest::addColumn<std::uint32_t>("samples");
        QTest::newRow("one sample") << 1U;
        QTest::newRow("several samples") << 5U;
    }
    void aPassComesInBandsOfWholeCells() {
        QFETCH(const std::uint32_t, samples);
        Sweep sweep{TileProgress(kWhole)};
        sweep.begin(samples);
        QCOMPARE(sweep.passSamples(), samples);
        std::vector<Tile> bands;
        while (sweep.isHalfMade()) {
            const Sweep::Order order = sweep.next(3500);
            bands.push_back(order.tile);
            const std::uint32_t ended = sweep.took(order);
            QCOMPARE(ended, sweep.isHalfMade() ? 0U : samples);
        }
        const std::vector<Tile> expected{{0, 0, 100, 32}, {0, 32, 100, 32}, {0, 64, 100, 6}};
        QVERIFY(bands == expected);
        QCOMPARE(sweep.samples(), (SampleCounts{samples, samples, double(samples)}));
    }

    void aPieceIsARowOfCellsAtLeast() {
        Sweep sweep{TileProgress(kWhole)};
        QCOMPARE(pass(sweep, kWhole, 1, 0), 5);
        QCOMPARE(pass(sweep, kWhole, 2, 0), 5);
        QCOMPARE(pass(sweep, kWhole, 1, double(kWhole.width) * kWhole.height), 1);
    }

    void aPartRunsAheadInWholeCells() {
        Sweep sweep{TileProgress(kWhole)};
        pass(sweep, kWhole, 3);
        pass(sweep, kRegion, 10);
        QVERIFY(sweep.part() == kRegionCells);
        QCOMPARE(sweep.samplesOf(kRegion), 13U);
        QCOMPARE(sweep.samples().least, 3U);
        QCOMPARE(sweep.samples().most, 13U);
    }

    void theRestCatchesUpBeforeAnythingElseGetsMore() {
        Sweep sweep{TileProgress(kWhole)};
        pass(sweep, kRegion, 10);
        pass(sweep, kWhole, 4);
        QCOMPARE(sweep.samples().least, 4U);
        QCOMPARE(sweep.samples().most, 10U);
        pass(sweep, kWhole, 100);
        QCOMPARE(sweep.samples(), (SampleCounts{10, 10, 10}));
        QCOMPARE(pass(sweep, kWhole, 100), 1);
        QCOMPARE(sweep.samples(), (SampleCounts{110, 110, 110}));
    }

    /// Another region overlaps the first one.
    void soDoesWhatLagsWithinAPart() {
        constexpr Tile other{50, 20, 40, 40};
        Sweep sweep{TileProgress(kWhole)};
        pass(sweep, kRegion, 10);
        pass(sweep, other, 6);
        QCOMPARE(sweep.samplesOf(kRegion), 10U);
        QCOMPARE(sweep.samplesOf(other), 6U);
        pass(sweep, other, 6);
        QCOMPARE(sweep.samplesOf(other), 10U);
        pass(sweep, other, 6);
        QCOMPARE(sweep.samplesOf(other), 16U);
        QCOMPARE(sweep.samplesOf(kRegion), 10U);
    }

    void aFilmThatIsTornAmidAPassGoesOnWhereItLags() {
        TileProgress progress(kWhole, 64);
        progress.advance({0, 0, 100, 32}, 65);
        Sweep sweep(progress);
        QVERIFY(!sweep.isHalfMade());
        sweep.begin(5);
        const Sweep::Order order = sweep.next(1e9);
        QVERIFY((order.tile == Tile{0, 32, 100, 38}));
        QCOMPARE(sweep.took(order), 1U);
        QCOMPARE(sweep.samples(), (SampleCounts{1, 1, 1}));
    }
};

QTEST_GUILESS_MAIN(SweepTest)
#include "sweep_test.moc"
