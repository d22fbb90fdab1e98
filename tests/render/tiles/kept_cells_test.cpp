// First: it includes TBB, of whose names Qt takes some for keywords.
#include "tests/support/scenes/tissue_scene.h"

#include <QTest>

#include <map>
#include <random>

#include "render/tiles/kept_cells.h"
#include "render/tiles/worker_pool.h"

using namespace pdr;

namespace {

constexpr Tile kCell{16, 32, 16, 16}, kOther{32, 32, 10, 16};
constexpr Tile kBoth{16, 32, 26, 16};
constexpr WorkerId kOne = 1, kTwo = 2;

/// Returns a result for that lease, of samples without light.
LeaseResult darkResult(const Lease& lease) {
    const std::size_t pixels = std::size_t(lease.tile.width) * std::size_t(lease.tile.height);
    LeaseResult result{lease.number, lease.tile, lease.samples, std::vector<PixelSums>(pixels), {}, 0, {}};
    if (isDeep(lease.samples))
        result.moments.resize(pixels);
    return result;
}

/// A worker that takes all samples of a small film, and forgets what it has kept when a test says so.
class OneWorker {
  public:
    OneWorker() {
        pool_.setOwnHelps(false);
        auto scene = std::make_shared<Scene>();
        scene->film = film_.size();
        scene_ = pool_.publish(Purpose::viewport, std::move(scene));
        worker_ = pool_.join("one", "one");
        pool_.hasScene(worker_, scene_);
    }

    /// Takes samples up to that number. Returns how many of the leases begin within a block, and how many of these
    /// continue what the worker has.
    std::pair<int, int> renderTo(std::uint64_t goal, bool forgets = false) {
        std::pair<int, int> leases;
        (void)pool_.begin(film_, scene_, {{film_.area(), film_.samplesPerPixel(), goal}}, {});
        for (;;) {
            while (std::optional<Lease> lease = pool_.take(worker_)) {
                leases.first += lease->samples.first % kSamplesPerBlock != 0;
                leases.second += lease->isKept;
                if (std::exchange(forgets, forgets && !lease->isKept))
                    pool_.abandon(worker_, lease->number);
                else
                    pool_.deliver(worker_, darkResult(*lease));
            }
            const auto own = pool_.nextOwn({});
            if (!own)
                break;
            if (own->lease)
                (void)(own->audit ? pool_.audited(*own->audit, darkResult(*own->lease))
                                  : pool_.deliverOwn(darkResult(*own->lease)));
        }
        (void)pool_.end();
        return leases;
    }

  private:
    WorkerPool pool_{1};
    Film film_{ivec2(96, 64), 0};
    std::uint64_t scene_ = 0;
    WorkerId worker_ = 0;
};

}  // namespace

/// Who need not be sent what it has sent.
class KeptCellsTest : public QObject {
    Q_OBJECT

  private slots:
    void whoRenderedAllOfATileLastHasItsSums() {
        KeptCells kept;
        kept.took(kOne, kCell, {0, 4});
        QVERIFY(kept.has(kOne, kCell, {4, 12}));
        QVERIFY(!kept.has(kTwo, kCell, {4, 12}));
        QVERIFY(!kept.has(kOne, kBoth, {4, 12}));
        QVERIFY(!kept.has(kOne, kCell, {5, 12}));
        kept.took(kOne, kOther, {0, 4});
        QVERIFY(kept.has(kOne, kBoth, {4, 12}));
        kept.took(kTwo, kOther, {4, 12});
        QVERIFY(!kept.has(kOne, kBoth, {16, 12}) && !kept.has(kTwo, kBoth, {16, 12}));
        QVERIFY(kept.has(kTwo, kOther, {16, 12}));
        kept.forget(kTwo);
        QVERIFY(!kept.has(kTwo, kOther, {16, 12}));
    }

    void whoRenderedAllBlocksHasTheirMoments() {
        KeptCells kept;
        kept.took(kOne, kCell, {0, 4});
        QVERIFY(!kept.has(kOne, kCell, {64, 128}));
        kept.took(kOne, kCell, {4, 60});
        QVERIFY(kept.has(kOne, kCell, {64, 128}));
        QVERIFY(!kept.has(kOne, kCell, {64, 64}));  // a block continues nothing
        kept.took(kOne, kCell, {64, 64});
        kept.took(kOne, kCell, {128, 256});
        QVERIFY(kept.has(kOne, kCell, {384, 128}));
        kept.took(kTwo, kCell, {384, 64});
        QVERIFY(!kept.has(kTwo, kCell, {448, 128}) && !kept.has(kOne, kCell, {448, 128}));
        kept.took(kTwo, kCell, {448, 8});
        QVERIFY(!kept.has(kTwo, kCell, {456, 8}));  // what earlier blocks have seen goes with the sums
        kept.took(kTwo, kCell, {512, 128});
        QVERIFY(kept.has(kTwo, kCell, {640, 128}));
    }

    void goalsAreCutByKeepers() {
        std::mt19937 random(1);
        const Tile area{16, 32, 150, 75};
        KeptCells kept;
        std::map<std::pair<int, int>, WorkerId> keepers;
        eachCell(area, [&](const Tile& cell) {
            const WorkerId keeper = random() % 3;
            keepers[{cell.x, cell.y}] = keeper;
            kept.took(keeper, cell, {0, 64});
        });
        std::map<std::pair<int, int>, int> times;
        for (const TileGoal& goal : kept.byKeeper({{area, 64, 100}})) {
            QVERIFY(goal.next == 64 && goal.goal == 100);
            eachCell(goal.tile, [&](const Tile& cell) {
                ++times[{cell.x, cell.y}];
                QCOMPARE(goal.keeper, (keepers[{cell.x, cell.y}]));
                QVERIFY(isInside(cell, area));
            });
        }
        QCOMPARE(times.size(), keepers.size());
        QVERIFY(std::ranges::all_of(times, [](const auto& one) { return one.second == 1; }));
        QCOMPARE(kept.byKeeper({{area, 0, 64}}).size(), std::size_t(1));  // nobody has anything of a new film
    }

    void eachGoesOnWithItsOwnCells() {
        const Tile above{0, 0, 160, 64}, below{0, 64, 160, 64};
        TileScheduler scheduler({{above, 4, 64, kOne}, {below, 4, 64, kTwo}}, Split::tiles, 1);
        const Ability cells{8 * 60 * kFilmCell * kFilmCell, 1e5};
        for (int turn = 0; turn < 8; ++turn)
            for (const WorkerId worker : {kTwo, kOne}) {
                const auto portion = scheduler.take(worker, cells, 0);
                QVERIFY(portion && isInside(portion->tile, worker == kOne ? above : below));
                scheduler.finish(portion->number);
            }
        QVERIFY(scheduler.isDone());
    }

    void whoHasDoneItsOwnHelpsOthers() {
        const Tile all{0, 0, 160, 64};
        TileScheduler scheduler({{all, 4, 64, kTwo}}, Split::tiles, 1);
        while (const auto portion = scheduler.take(kOne, {1e4, 1e5}, 0))
            scheduler.finish(portion->number);
        QVERIFY(scheduler.isDone());
    }

    void aWorkerAloneIsSentNothingBack() {
        OneWorker worker;
        QCOMPARE(worker.renderTo(4).second, 0);
        for (const std::uint64_t goal : {16, 40, 64}) {
            const auto [within, kept] = worker.renderTo(goal);
            QVERIFY(within > 0);
            QCOMPARE(kept, within);
        }
    }

    void whatAWorkerHasLostIsSentAgain() {
        OneWorker worker;
        (void)worker.renderTo(4);
        const auto [within, kept] = worker.renderTo(16, true);
        QVERIFY(kept < within);
        const auto after = worker.renderTo(40);
        QCOMPARE(after.second, after.first);
    }
};

QTEST_APPLESS_MAIN(KeptCellsTest)
#include "kept_cells_test.moc"
