// First: it includes TBB, of whose names Qt takes some for keywords.
#include "tests/support/scenes/shared_films.h"

#include <QTest>

#include "render/session/batch_render.h"
#include "render/tiles/result_check.h"
#include "render/tiles/trace_lease.h"
#include "tests/support/network/nearby_worker.h"

using namespace pdr;
using namespace pdr::test;

/// Images that several workers make together.
class SharedDeviceTest : public QObject {
    Q_OBJECT

  private slots:
    /// A lease is the same whether the device that takes it shares it with others or not.
    void leaseIsTheSameWhoeverMakesIt_data() {
        QTest::addColumn<quint32>("first");
        QTest::addColumn<quint32>("count");
        QTest::newRow("begins a block") << 0u << 30u;
        QTest::newRow("fills a block") << 0u << 64u;
        QTest::newRow("ends a block") << 94u << 34u;
        QTest::newRow("within a block") << 70u << 3u;
        QTest::newRow("several blocks") << 64u << 128u;
    }
    void leaseIsTheSameWhoeverMakesIt() {
        QFETCH(const quint32, first);
        QFETCH(const quint32, count);
        const Scene scene = sceneToShare();
        const Tile tile{16, 0, scene.film.x - 16, 32};
        const auto one = makeCpuDevice(1);
        QVERIFY(bool(one->upload(scene)));
        Lease lease{1, 1, tile, {first, count}, {}, {}};
        if (const std::uint32_t before = first % kSamplesPerBlock; before > 0)
            lease.before = traceLease(*one, {1, 1, tile, {first - before, before}, {}, {}}, {})->sums;
        const LeaseResult alone = *traceLease(*one, lease, {});
        const auto pool = newPool();
        pool->setOwnHelps(false);
        const auto device = shareDevice(makeCpuDevice(1), pool);
        QVERIFY(bool(device->upload(scene)));
        const NearbyWorker worker(pool, "a"), other(pool, "b"), liar(pool, "c", NearbyWorker::Nature::lies);
        while (worker.status().results + other.status().results < 3 ||
               liar.status().state != WorkerState::quarantined) {
            const Result<LeaseResult> shared = traceLease(*device, lease, {});
            QVERIFY(sameBits(std::span<const PixelSums>(shared->sums), alone.sums));
            QVERIFY(sameBits(std::span<const Moments>(shared->moments), alone.moments));
            for (int i = 0; i < kFaults; ++i)
                QCOMPARE(shared->health.faults[i].count, alone.health.faults[i].count);
        }
    }

    void imageIsTheSameWhoeverMakesIt_data() {
        QTest::addColumn<int>("workers");
        QTest::addColumn<bool>("bySamples");
        for (const int workers : {0, 1, 2, 7})
            for (const bool bySamples : {false, true})
                QTest::addRow("%d workers, %s", workers, bySamples ? "blocks" : "tiles") << workers << bySamples;
    }
    void imageIsTheSameWhoeverMakesIt() {
        QFETCH(const int, workers);
        QFETCH(const bool, bySamples);
        const auto pool = newPool();
        pool->setSplit(bySamples ? Split::samples : Split::tiles);
        std::vector<std::unique_ptr<NearbyWorker>> all;
        for (int i = 0; i < workers; ++i)
            all.push_back(std::make_unique<NearbyWorker>(pool, "worker " + std::to_string(i)));
        const FilmContent together = shared(sceneToShare(), kOrders, pool);
        QVERIFY(sameBits(together, aloneInOrders()));
    }

    void workersTakeTheirPart() {
        const auto pool = newPool();
        pool->setOwnHelps(false);
        NearbyWorker worker(pool, "one");
        (void)shared(sceneToShare(), {1, 64, 64, 64, 64}, pool);
        QVERIFY(worker.status().work > 0);
        QVERIFY(worker.status().audited > 0);
        QCOMPARE(worker.status().state, WorkerState::ready);
    }

    /// Blocks of a tile that one worker takes together are added as the film would add them.
    void blocksThatComeTogetherAreThoseOfOneDevice() {
        const auto pool = newPool();
        pool->setOwnHelps(false);
        pool->setSplit(Split::tiles);
        NearbyWorker worker(pool, "one");
        const std::vector<std::uint32_t> orders{1, 63, 256, 70, 320};
        const auto device = shareDevice(makeCpuDevice(1), pool);
        const auto film = *startFilm(*device, cutScene());
        std::vector<std::uint32_t> taken;
        while (worker.deepLeases() < 10) {  // trusted, and of a known speed
            QVERIFY2(taken.size() < 500, "it gets none");
            for (const std::uint32_t n : orders) {
                QVERIFY(film->accumulate(n, {}));
                taken.push_back(n);
            }
        }
        const FilmContent mine = alone(cutScene(), taken), together = (*film->film())->content();
        QVERIFY(sameBits(together, mine) && sameHealth(together.health, mine.health));
    }

    void whoKnowsNoSeveralBlocksGetsThemOneByOne() {
        const auto pool = newPool();
        pool->setOwnHelps(false);
        NearbyWorker worker(pool, "one", NearbyWorker::Nature::honest, false);
        while (!worker.status().isProved || worker.status().results < 100)
            (void)shared(sceneToShare(), {512}, pool);
        QCOMPARE(worker.deepLeases(), 0);
    }

    /// The error is looked at after the same samples, however they are ordered.
    void anErrorEndsAnImageWhereItEndsWithoutNodes() {
        const auto pool = newPool();
        pool->setOwnHelps(false);
        NearbyWorker worker(pool, "one");
        const auto device = shareDevice(makeCpuDevice(1), pool), own = makeCpuDevice(1);
        const auto film = *startFilm(*device, sceneToShare()), mine = *startFilm(*own, sceneToShare());
        for (Accumulator* one : {film.get(), mine.get()}) {
            const auto ended = BatchRender(*one, {.relativeError = 0.02}, {}).run({}, [](const BatchState&) {});
            QVERIFY(ended && ended->reason == StopReason::error && ended->film.relativeError <= 0.02);
            QVERIFY(ended->film.samplesPerPixel > 2 * kSamplesPerBlock);
        }
        QVERIFY(sameBits((*film->film())->content(), (*mine->film())->content()));
    }

    void partOfAnImageIsShared() {
        const auto pool = newPool();
        NearbyWorker worker(pool, "one");
        const auto device = shareDevice(makeCpuDevice(1), pool), own = makeCpuDevice(1);
        const auto film = *startFilm(*device, sceneToShare()), mine = *startFilm(*own, sceneToShare());
        for (Accumulator* one : {film.get(), mine.get()}) {
            QVERIFY(one->accumulate(10, {}));
            QVERIFY(one->accumulate({40, 30, 50, 50}, 100, {}));
            QVERIFY(one->accumulate(7, {}));
        }
        QVERIFY(sameBits((*film->film())->content(), (*mine->film())->content()));
    }
};

QTEST_APPLESS_MAIN(SharedDeviceTest)
#include "shared_device_test.moc"
