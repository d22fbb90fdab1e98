#include <QTest>

#include <map>
#include <random>

#include "render/film/tile_progress.h"
#include "render/tiles/tile_scheduler.h"

using namespace pdr;

namespace {

constexpr Tile kArea{0, 0, 250, 130};
constexpr Ability kCells{4 * kFilmCell * kFilmCell, 1e5};

/// What has been finished, checked as a film would check it.
class EffectCosts {
  public:
    explicit EffectCosts(const Tile& area) : progress_(area) {}
    /// Whether all pixels of the portion were just where it begins.
    bool finish(const Portion& portion) {
        const auto here = progress_.evenTiles(portion.tile);
        if (!progress_.isWholeCells(portion.tile) || here.size() != 1 || here[0].next != portion.samples.first)
            return false;
        progress_.advance(portion.tile, portion.samples.end());
        return true;
    }
    SampleCounts counts() const { return progress_.counts(); }

  private:
    TileProgress progress_;
};

}  // namespace

/// Who renders what: every sample of every pixel once, whatever workers do.
class TileSchedulerTest : public QObject {
    Q_OBJECT

  private slots:
    void everySampleIsTakenOnce_data() {
        QTest::addColumn<int>("goal");
        QTest::addColumn<double>("work");
        for (const int goal : {1, 64, 100, 200})
            for (const double work : {1.0, 3000.0, 1e9})
                QTest::addRow("%d samples, %g at a time", goal, work) << goal << work;
    }
    void everySampleIsTakenOnce() {
        QFETCH(const int, goal);
        QFETCH(const double, work);
        TileScheduler scheduler({{kArea, 0, std::uint64_t(goal)}}, Split::tiles, 1);
        EffectCosts effectCosts(kArea);
        double now = 0;
        while (const auto portion = scheduler.take(1, {work, 1e6}, now++)) {
            QVERIFY(portion->samples == samplesInBlock(portion->samples.first, portion->samples.count));
            QVERIFY(effectCosts.finish(*portion));
            scheduler.finish(portion->number);
        }
        QVERIFY(scheduler.isDone());
        QCOMPARE(effectCosts.counts().least, std::uint64_t(goal));
        QCOMPARE(effectCosts.counts().most, std::uint64_t(goal));
    }

    void portionsAreAsLargeAsIsAsked() {
        TileScheduler scheduler({{kArea, 0, 4}}, Split::tiles, 1);
        const auto some = scheduler.take(1, {2.0 * kFilmCell * kFilmCell * 4, 1}, 0);
        QCOMPARE(some->tile, (Tile{0, 0, 2 * kFilmCell, kFilmCell}));
        const auto rest = scheduler.take(1, {1e9, 1}, 0);
        QCOMPARE(rest->tile, (Tile{2 * kFilmCell, 0, 250 - 2 * kFilmCell, kFilmCell}));
    }

    /// Whoever can afford the least portion gets one: who waits for others to take it would wait for ever.
    void whatIsAffordedIsGivenOut() {
        TileScheduler scheduler({{kArea, 0, 64}}, Split::tiles, 1);
        const double least = scheduler.leastCost();
        QVERIFY(!scheduler.take(1, {1e9, 1, 0, 0.99 * least}, 0));
        for (const double most : {least, 2.5 * least, 100 * least}) {
            const auto portion = scheduler.take(1, {1e9, 1, 0, most}, 0);
            QVERIFY(portion && scheduler.costOf(*portion) <= most);
        }
    }

    void blocksOfATileGoTogether_data() {
        QTest::addColumn<int>("next");
        QTest::addColumn<int>("goal");
        QTest::addColumn<double>("deepest");  // blocks of a cell
        QTest::addColumn<QList<int>>("ends");
        QTest::newRow("all") << 0 << 256 << 1e9 << QList<int>{256};
        QTest::newRow("a rest before and behind") << 10 << 330 << 1e9 << QList<int>{64, 320, 330};
        QTest::newRow("a single block") << 64 << 140 << 1e9 << QList<int>{128, 140};
        QTest::newRow("who takes two at most") << 0 << 320 << 2.5 << QList<int>{128, 256, 320};
        QTest::newRow("who takes one at a time") << 0 << 192 << 0.0 << QList<int>{64, 128, 192};
    }
    void blocksOfATileGoTogether() {
        QFETCH(const int, next);
        QFETCH(const int, goal);
        QFETCH(const double, deepest);
        QFETCH(const QList<int>, ends);
        const double block = kFilmCell * kFilmCell * kSamplesPerBlock;
        TileScheduler scheduler({{kArea, std::uint64_t(next), std::uint64_t(goal)}}, Split::tiles, 1);
        QList<int> taken;
        while (const auto portion = scheduler.take(1, {1e30, 1e6, deepest * block}, 0)) {
            QCOMPARE(portion->tile, kArea);
            taken << int(portion->samples.end());
            scheduler.finish(portion->number);
        }
        QCOMPARE(taken, ends);
    }

    /// Blocks that are split among workers come back as sums of their own.
    void blocksOfSplitSamplesGoAlone() {
        TileScheduler scheduler({{kArea, 0, 256}}, Split::samples, 1);
        while (const auto portion = scheduler.take(1, {1e30, 1e6, 1e30}, 0))
            QVERIFY(!isDeep(portion->samples));
    }

    void portionsOfDearCellsAreSmaller() {
        const Tile left{0, 0, 128, 130}, right{128, 0, 122, 130};
        CellCosts costs(kArea);
        for (int order = 0; order < 10; ++order)  // pixels on the right cost four times as much
            costs.learn({{1, left, 1, 128}, {1, right, 1, 4 * 122}});
        TileScheduler scheduler({{right, 0, 1}, {left, 0, 1}}, Split::tiles, 1, costs);
        const Ability some{costs.ofSample({0, 0, 128, 64}), 1};
        const auto dear = scheduler.take(1, some, 0);
        QCOMPARE(dear->tile, (Tile{128, 0, 122, 16}));
        QVERIFY(scheduler.costOf(*dear) <= some.cost);
        while (const auto next = scheduler.take(1, some, 0))
            if (next->tile.x == 0) {
                QCOMPARE(next->tile, (Tile{0, 0, 128, 64}));
                return;
            }
        QFAIL("the left side was never given out");
    }

    void portionsAreNoLargerThanALeaseMayBe() {
        for (const auto& [split, goal] : {std::pair(Split::tiles, 64u), std::pair(Split::samples, 64u),
                                          std::pair(Split::tiles, 10 * kMostDeepSamples)}) {
            TileScheduler scheduler({{{0, 0, 16384, 300}, 0, goal}, {{0, 300, 700, 700}, 0, goal}}, split, 1);
            int portions = 0;
            for (; const auto portion = scheduler.take(1, {1e30, 1e30, 1e30}, 0); ++portions) {
                const std::size_t most = isDeep(portion->samples) ? kMostDeepPixels : kMostLeasePixels;
                QVERIFY(std::size_t(portion->tile.width) * std::size_t(portion->tile.height) <= most);
                QVERIFY(portion->samples.count <= kMostDeepSamples);
            }
            QVERIFY(portions > 20);
        }
    }

    void whatIsLostComesBack() {
        TileScheduler scheduler({{kArea, 0, 64}}, Split::tiles, 1);
        const auto lost = scheduler.take(1, kCells, 0);
        const double open = scheduler.openCost();
        scheduler.giveBackAll(1);
        QVERIFY(!scheduler.heldBy(1, lost->number));
        QCOMPARE(scheduler.openCost(), open + workOf(lost->tile, lost->samples));
        const auto again = scheduler.take(2, kCells, 0);
        QCOMPARE(again->tile, lost->tile);
        QVERIFY(again->number != lost->number);
    }

    void whatIsLateGoesToOthersAsWell() {
        TileScheduler scheduler({{{0, 0, 16, 16}, 0, 1}}, Split::tiles, 1);
        const auto portion = scheduler.take(1, {1e9, 256}, 0);  // a second's
        QVERIFY(!scheduler.take(2, kCells, 1));
        const double late = 3 + TileScheduler::kHedgeSeconds;
        QVERIFY(!scheduler.take(1, kCells, late + 0.1));  // not to the one who has it
        const auto copy = scheduler.take(2, kCells, late + 0.1);
        QVERIFY(copy && copy->number == portion->number);
        QVERIFY(scheduler.heldBy(1, 1) && scheduler.heldBy(2, 1));
        scheduler.finish(1);
        QVERIFY(!scheduler.heldBy(1, 1) && scheduler.isDone());
    }

    void severalLateBlocksGoToWhoTakesSeveral() {
        TileScheduler scheduler({{{0, 0, 16, 16}, 0, 256}}, Split::tiles, 1);
        const auto portion = scheduler.take(1, {1e9, 1e9, 1e9}, 0);
        QVERIFY(portion && isDeep(portion->samples));
        const double late = 1e3;
        QVERIFY(!scheduler.take(2, {1e9, 1e9, 0}, late));
        const auto copy = scheduler.take(3, {1e9, 1e9, 1e9}, late);
        QVERIFY(copy && copy->number == portion->number);
    }

    void ownDeviceIsNotAsPatient() {
        TileScheduler scheduler({{{0, 0, 16, 16}, 0, 1}}, Split::tiles, 1);
        (void)scheduler.take(1, {1e9, 256}, 0);  // a second's
        QVERIFY(!scheduler.take(kOwnDevice, kCells, 1));
        QVERIFY(scheduler.take(kOwnDevice, kCells, 1 + 2 * TileScheduler::kOwnHedgeSeconds));
    }

    void whoIsSuspectIsHedgedAtOnce() {
        TileScheduler scheduler({{{0, 0, 16, 16}, 0, 1}}, Split::tiles, 1);
        (void)scheduler.take(1, {1e9, 1e-3}, 0);
        QVERIFY(!scheduler.take(2, kCells, 0.1));
        scheduler.setSuspect(1, true);
        QVERIFY(scheduler.take(2, kCells, 0.1));
    }

    void whatIsOverdueIsTakenAway() {
        TileScheduler scheduler({{{0, 0, 16, 16}, 0, 1}}, Split::tiles, 1);
        (void)scheduler.take(1, {1e9, 256}, 0);
        QVERIFY(scheduler.expire(4 + TileScheduler::kExpirySeconds - 0.1).empty());
        QCOMPARE(scheduler.expire(4 + TileScheduler::kExpirySeconds + 0.1), std::vector<WorkerId>{1});
        QVERIFY(scheduler.openCost() > 0);
        // The own device cannot lose anything.
        TileScheduler own({{{0, 0, 16, 16}, 0, 1}}, Split::tiles, 1);
        (void)own.take(kOwnDevice, {1e9, 256}, 0);
        QVERIFY(own.expire(1e6).empty());
    }

    void whatIsLookedAtGoesToNobody() {
        TileScheduler scheduler({{{0, 0, 16, 16}, 0, 1}}, Split::tiles, 1);
        const auto portion = scheduler.take(1, {1e9, 256}, 0);
        scheduler.arrived(portion->number);
        scheduler.giveBackAll(1);
        QVERIFY(!scheduler.take(2, kCells, 100));
        QVERIFY(scheduler.expire(100).empty() && !scheduler.isDone());
        scheduler.finish(portion->number);
        QVERIFY(scheduler.isDone());
    }

    void blocksOfTheWholeImageAreFreeAtOnce() {
        TileScheduler scheduler({{kArea, 10, 200}}, Split::samples, 1);
        std::vector<SampleRange> taken;
        for (WorkerId worker = 1; worker <= 4; ++worker) {
            const auto portion = scheduler.take(worker, kCells, 0);
            QCOMPARE(portion->tile, kArea);
            taken.push_back(portion->samples);
        }
        QCOMPARE(taken, (std::vector<SampleRange>{{10, 54}, {64, 64}, {128, 64}, {192, 8}}));
        QVERIFY(!scheduler.take(5, kCells, 0));
        scheduler.giveBackAll(2);
        const auto again = scheduler.take(5, kCells, 0);
        QCOMPARE(again->samples, (SampleRange{64, 64}));
        QVERIFY(!scheduler.take(6, kCells, 0));
        for (std::uint64_t number = 1; number <= again->number; ++number)
            scheduler.finish(number);
        QVERIFY(scheduler.isDone());
    }

    /// Workers that take, finish, lose and leave by chance.
    void nothingIsLostWhateverHappens() {
        for (unsigned seed = 1; seed <= 50; ++seed) {
            std::mt19937 random(seed);
            const auto chance = [&](int in) { return int(random() % unsigned(in)) == 0; };
            TileScheduler scheduler({{{0, 0, 250, 64}, 3, 150}, {{0, 64, 250, 66}, 0, 70}}, Split::tiles, 1);
            EffectCosts effectCosts(kArea);
            effectCosts.finish({0, {0, 0, 250, 64}, {0, 3}});
            std::map<std::uint64_t, std::pair<WorkerId, Portion>> held;
            double now = 0;
            for (int step = 0; !scheduler.isDone(); ++step) {
                QVERIFY2(step < 200000, "it does not end");
                now += 0.01;
                const WorkerId worker = 1 + random() % 5;
                if (const auto portion = scheduler.take(worker, {double(random() % 50000), 1e5}, now))
                    held.insert_or_assign(portion->number, std::pair(worker, *portion));
                if (chance(20))
                    scheduler.giveBackAll(1 + random() % 5);
                if (chance(10))
                    scheduler.setSuspect(1 + random() % 5, chance(2));
                if (chance(30))
                    (void)scheduler.expire(now);
                if (held.empty() || chance(3))
                    continue;
                const auto one = std::next(held.begin(), std::ptrdiff_t(random() % held.size()));
                const auto [who, portion] = one->second;
                if (scheduler.heldBy(who, portion.number)) {
                    QVERIFY(effectCosts.finish(portion));
                    scheduler.finish(portion.number);
                }
                held.erase(one);
            }
            QCOMPARE(effectCosts.counts().least, 70u);
            QCOMPARE(effectCosts.counts().most, 150u);
        }
    }
};

QTEST_APPLESS_MAIN(TileSchedulerTest)
#include "tile_scheduler_test.moc"
