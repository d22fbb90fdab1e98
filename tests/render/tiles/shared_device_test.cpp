// First: it includes TBB, of whose names Qt takes some for keywords.
#include "tests/support/scenes/tissue_scene.h"

#include <QTest>

#include <atomic>
#include <mutex>
#include <random>
#include <thread>

#include "render/edit/first_samples.h"
#include "render/session/batch_render.h"
#include "render/session/session.h"
#include "render/tiles/result_check.h"
#include "render/tiles/shared_device.h"
#include "render/tiles/worker_pool.h"
#include "tests/support/network/nearby_worker.h"
#include "tests/support/patience.h"

using namespace pdr;
using namespace pdr::test;

namespace {

using Workers = std::vector<std::unique_ptr<NearbyWorker>>;

Scene sceneToShare() {
    Scene scene = tissueScene();
    scene.film = {90, 61};
    scene.revision = 7;
    return scene;
}

/// Whose paths end early, with light still on them.
Scene cutScene() {
    Scene scene = sceneToShare();
    scene.model = Model::multipleScattering;
    scene.maxBounces = 2;
    for (TransferNode& node : scene.transferFunction.nodes)
        node.albedo = vec3(1);
    return scene;
}

std::shared_ptr<WorkerPool> newPool() {
    return std::make_shared<WorkerPool>(1);
}

FilmContent alone(const Scene& scene, const std::vector<std::uint32_t>& orders) {
    const auto device = makeCpuDevice(1);
    const auto film = *startFilm(*device, scene);
    for (const std::uint32_t n : orders)
        (void)film->accumulate(n, {});
    return (*film->film())->content();
}

FilmContent shared(const Scene& scene, const std::vector<std::uint32_t>& orders, std::shared_ptr<WorkerPool> pool) {
    const auto device = shareDevice(makeCpuDevice(1), std::move(pool));
    const auto film = *startFilm(*device, scene);
    for (const std::uint32_t n : orders)
        if (const auto done = film->accumulate(n, {}); !done)
            qFatal("%s", done.error().text().c_str());
    return (*film->film())->content();
}

/// The last one has several whole blocks, and a part of one before and behind them.
const std::vector<std::uint32_t> kOrders{1, 5, 40, 64, 30, 130, 300};

/// What one device alone makes of sceneToShare() in kOrders, which it always makes the same.
const FilmContent& aloneInOrders() {
    static const FilmContent content = alone(sceneToShare(), kOrders);
    return content;
}

}  // namespace

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
        QTest::newRow("several blocks") << 64u << 192u;
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
        for (const int workers : {0, 1, 2, 3, 7})
            for (const bool bySamples : {false, true})
                QTest::addRow("%d workers, %s", workers, bySamples ? "blocks" : "tiles") << workers << bySamples;
    }
    void imageIsTheSameWhoeverMakesIt() {
        QFETCH(const int, workers);
        QFETCH(const bool, bySamples);
        const auto pool = newPool();
        pool->setSplit(bySamples ? Split::samples : Split::tiles);
        Workers all;
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
        const std::vector<std::uint32_t> orders{1, 63, 512, 70, 1000};
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

    /// What a stop leaves of a film that is extended: whole tiles, each as one device makes it.
    void stopLeavesAFilmThatCanGoOn() {
        const auto pool = newPool();
        NearbyWorker worker(pool, "one");
        const auto device = shareDevice(makeCpuDevice(1), pool);
        const auto film = *startFilm(*device, sceneToShare());
        std::stop_source stop;
        const auto told = [&](const SampleCounts& counts) {
            if (counts.mean > 0)
                stop.request_stop();
        };
        QCOMPARE(*film->extend(0, 2048, stop.get_token(), told), std::uint64_t(0));
        const SampleCounts there = (*film->film())->samples();
        QVERIFY(there.least == 0 && there.most > 0);
        const FilmContent content = (*film->film())->content();
        const FilmContent mine = alone(sceneToShare(), {std::uint32_t(there.most)});
        for (std::size_t i = 0; i < content.moments.size(); ++i)
            if (content.moments[i].count == there.most)
                QVERIFY(sameBits(std::span(&content.moments[i], 1), std::span(&mine.moments[i], 1)));
    }

    void imageSurvivesThoseWhoLeave() {
        const auto pool = newPool();
        std::atomic<bool> done = false;
        std::jthread crowd([&] {
            std::mt19937 random(5);
            Workers all;
            while (!done) {
                all.push_back(std::make_unique<NearbyWorker>(pool, "worker " + std::to_string(random() % 5)));
                std::this_thread::sleep_for(std::chrono::milliseconds(random() % 20));
                if (all.size() > 3)
                    all.erase(all.begin() + std::ptrdiff_t(random() % all.size()));
            }
        });
        const FilmContent together = shared(sceneToShare(), kOrders, pool);
        done = true;
        QVERIFY(sameBits(together, aloneInOrders()));
    }

    void imageSurvivesThoseWhoSayNothing() {
        const auto pool = newPool();
        NearbyWorker silent(pool, "silent", NearbyWorker::Nature::silent);
        NearbyWorker honest(pool, "honest");
        const FilmContent together = shared(sceneToShare(), {64, 64}, pool);
        QVERIFY(sameBits(together, alone(sceneToShare(), {64, 64})));
    }

    void liarIsFoundWithItsFirstTile_data() {
        QTest::addColumn<int>("nature");
        QTest::newRow("one bit") << int(NearbyWorker::Nature::lies);
        QTest::newRow("another tile") << int(NearbyWorker::Nature::sendsOthers);
        QTest::newRow("faults that were none") << int(NearbyWorker::Nature::tellsFaults);
    }
    void liarIsFoundWithItsFirstTile() {
        QFETCH(const int, nature);
        const auto pool = newPool();
        NearbyWorker liar(pool, "liar", NearbyWorker::Nature(nature));
        NearbyWorker honest(pool, "honest");
        FilmContent together;
        while (liar.status().state != WorkerState::quarantined)
            together = shared(sceneToShare(), {64, 40}, pool);
        QVERIFY(sameBits(together, alone(sceneToShare(), {64, 40})));
        QVERIFY(!liar.status().reason.empty());
        QCOMPARE(liar.status().results, 0u);
    }

    /// Who lies only when it is trusted: what it had added is taken again.
    void imageIsMadeAgainWithoutALiarsTiles() {
        const auto pool = newPool();
        pool->setOwnHelps(false);
        NearbyWorker liar(pool, "liar", NearbyWorker::Nature::liesSeldom);
        const auto device = shareDevice(makeCpuDevice(1), pool);
        const auto film = *startFilm(*device, sceneToShare());
        std::uint32_t samples = 0;
        while (liar.status().state != WorkerState::quarantined) {
            QVERIFY2(samples < 200000, "it is never found");
            QVERIFY(film->accumulate(32, {}));
            samples += 32;
        }
        QVERIFY(
            sameBits((*film->film())->content(), alone(sceneToShare(), std::vector<std::uint32_t>(samples / 32, 32))));
    }

    /// Whoever renders to an end is told, and obeys a stop before all is taken again.
    void imageThatALiarHelpedWithBeginsAnew() {
        const auto pool = newPool();
        pool->setOwnHelps(false);
        NearbyWorker liar(pool, "liar", NearbyWorker::Nature::liesSeldom);
        const auto device = shareDevice(makeCpuDevice(1), pool);
        const auto film = *startFilm(*device, sceneToShare());
        std::uint64_t samples = 0;
        do {
            QVERIFY2(samples < 200000, "it is never found");
            const auto there = film->extend(samples, 32, {});
            QVERIFY(there && (*there == samples + 32 || *there == 0));
            samples = *there;
        } while (samples > 0);
        QCOMPARE(liar.status().state, WorkerState::quarantined);
        QCOMPARE((*film->film())->samplesPerPixel(), std::uint64_t(0));
        for (const std::uint32_t n : {64u, 40u})
            QVERIFY(bool(film->extend(samples, n, {})));
        QVERIFY(sameBits((*film->film())->content(), alone(sceneToShare(), {64, 40})));
    }

    /// What is told of paths that were cut is checked as the light is.
    void whoHidesFaultsIsFound() {
        const FilmContent mine = alone(cutScene(), {64, 40});
        QVERIFY(mine.health.of(Fault::cutPath).count > 1000);
        const auto pool = newPool();
        NearbyWorker liar(pool, "liar", NearbyWorker::Nature::hidesFaults);
        FilmContent together;
        while (liar.status().state != WorkerState::quarantined)
            together = shared(cutScene(), {64, 40}, pool);
        QVERIFY(sameBits(together, mine) && sameHealth(together.health, mine.health));
    }

    void liesAboutSeveralBlocksAreSeen() {
        const auto device = makeCpuDevice(1);
        QVERIFY(device->upload(sceneToShare()));
        const Lease lease{1, 1, {0, 0, 16, 16}, {0, 128}, {}, {}};
        const LeaseResult truth = *traceLease(*device, lease, {});
        Audit audit{1, "key", truth, lease, 1, true};
        QVERIFY(confirms(truth, audit));
        audit.claimed.moments.back().m2.z = std::nextafter(audit.claimed.moments.back().m2.z, 1e9);
        QVERIFY(!confirms(truth, audit));
    }

    /// A film that was put away and continued knows whom to mistrust, as if it had stayed.
    void aFilmKeepsItsContributors() {
        const auto pool = newPool();
        pool->setOwnHelps(false);
        NearbyWorker node(pool, "node");
        const auto device = shareDevice(makeCpuDevice(1), pool);
        const auto film = *startFilm(*device, sceneToShare());
        for (int i = 0; i < 200 && film->contributors().empty(); ++i)
            QVERIFY(film->accumulate(32, {}));
        const Contributors contributors = film->contributors();
        QCOMPARE(contributors, Contributors{"node"});
        const std::shared_ptr<const Film> away = *film->putAway();
        QVERIFY(film->restart(away->area(), 7) && film->contributors().empty());
        QVERIFY(film->resume(*away));
        film->credit(contributors);
        QVERIFY(device->trusts(contributors));
        QCOMPARE(*film->extend(away->samplesPerPixel(), 1, {}), away->samplesPerPixel() + 1);
        pool->quarantine(node.status().id, "it lied");
        QVERIFY(!device->trusts(contributors));
        QCOMPARE(*film->extend(away->samplesPerPixel() + 1, 1, {}), std::uint64_t(0));
    }

    void liesAboutFaultsAreFoundLater_data() {
        QTest::addColumn<int>("nature");
        QTest::newRow("hidden") << int(NearbyWorker::Nature::hidesSeldom);
        QTest::newRow("more than samples") << int(NearbyWorker::Nature::tellsTooMany);
        QTest::newRow("of another sample") << int(NearbyWorker::Nature::tellsOfOthers);
    }
    void liesAboutFaultsAreFoundLater() {
        QFETCH(const int, nature);
        const auto pool = newPool();
        pool->setOwnHelps(false);
        NearbyWorker liar(pool, "liar", NearbyWorker::Nature(nature));
        const auto device = shareDevice(makeCpuDevice(1), pool);
        const auto film = *startFilm(*device, cutScene());
        std::uint32_t samples = 0;
        while (liar.status().state != WorkerState::quarantined) {
            QVERIFY2(samples < 10000, "it is never found");
            QVERIFY(film->accumulate(32, {}));
            samples += 32;
        }
        const FilmContent mine = alone(cutScene(), std::vector<std::uint32_t>(samples / 32, 32));
        const FilmContent together = (*film->film())->content();
        QVERIFY(sameBits(together, mine) && sameHealth(together.health, mine.health));
    }

    void quarantineOutlastsALeave() {
        const auto pool = newPool();
        const WorkerId first = pool->join("key", "name");
        pool->quarantine(first, "it lied");
        pool->leave(first);
        (void)pool->join("key", "name");
        QCOMPARE(pool->workers().front().state, WorkerState::quarantined);
        QCOMPARE(pool->workers().front().reason, std::string("it lied"));
        (void)pool->join("another", "name");
        QCOMPARE(pool->workers().back().state, WorkerState::waiting);
    }

    /// A node that lies, loses its connection and is back before the audit.
    void liarIsFoundAfterItHasReconnected() {
        WorkerPool pool(1);
        pool.setOwnHelps(false);
        const WorkerId first = pool.join("key", "name");
        const std::uint64_t scene = pool.publish(Purpose::viewport, std::make_shared<const Scene>(sceneToShare()));
        pool.hasScene(first, scene);
        Film film(Tile{0, 0, 128, 128}, 7);
        QVERIFY(pool.begin(film, scene, {{film.area(), 0, 64}}, {}));
        const Lease lease = *pool.take(first);
        const auto pixels = std::size_t(lease.tile.width) * std::size_t(lease.tile.height);
        LeaseResult result{lease.number, lease.tile, lease.samples, std::vector<PixelSums>(pixels), {}, 0};
        pool.deliver(first, result);
        pool.leave(first);
        const WorkerId second = pool.join("key", "name");
        const std::optional<SharedWork::OwnWork> work = pool.nextOwn({});
        QVERIFY(work && work->audit);
        result.sums.back().sum.x = 1;
        QVERIFY(pool.audited(*work->audit, result));
        QCOMPARE(pool.status(second)->state, WorkerState::quarantined);
        QVERIFY(pool.isAnyUntrusted({"key"}));
        (void)pool.end();
    }

    void stopEndsAnOrder() {
        const auto pool = newPool();
        NearbyWorker worker(pool, "one");
        const auto device = shareDevice(makeCpuDevice(1), pool);
        const auto film = *startFilm(*device, sceneToShare());
        std::stop_source stop;
        std::jthread stopper([&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
            stop.request_stop();
        });
        QVERIFY(film->accumulate(1000000, stop.get_token()));
        QVERIFY(film->restart(film->area(), 7));
        for (const std::uint32_t n : kOrders)
            QVERIFY(film->accumulate(n, {}));
        QVERIFY(sameBits((*film->film())->content(), aloneInOrders()));
    }

    void aFilmIsSharedWhileAWorkerTakesLeasesOfItsScene() {
        const auto pool = newPool();
        const auto device = shareDevice(makeCpuDevice(1), pool);
        const auto film = *startFilm(*device, sceneToShare());
        const WorkerId worker = pool->join("key", "name");
        QVERIFY(!film->orderSize().isShared);  // it has no scene yet
        pool->hasScene(worker, pool->scene().number);
        QVERIFY(film->orderSize().isShared);
        pool->setPaused(worker, true);
        QVERIFY(!film->orderSize().isShared);
        pool->setPaused(worker, false);
        const std::uint64_t another = pool->publish(Purpose::finalRender, std::make_shared<const Scene>(cutScene()));
        pool->hasScene(worker, another);
        QVERIFY(!film->orderSize().isShared);
    }

    /// On a clock on which everything is fast, however busy the machine is.
    void imagesOfAWindowWithNodesComeWithBlocks() {
        const auto pool = newPool();
        pool->setOwnHelps(false);
        NearbyWorker worker(pool, "one");
        std::mutex mutex;
        std::vector<std::uint64_t> shown;  // samples of the images, once the worker takes part
        const auto sink = [&](const std::shared_ptr<const Frame>& frame) {
            const std::lock_guard lock(mutex);
            const std::uint64_t samples = frame->status.samplesPerPixel;
            if (!frame->coarse && worker.status().results > 0 && (shown.empty() || samples > shown.back()))
                shown.push_back(samples);
        };
        const auto count = [&] {
            const std::lock_guard lock(mutex);
            return shown.size();
        };
        const auto clock = [seconds = std::make_shared<double>(0)] { return *seconds += 0.02; };
        Session session(shareDevice(makeCpuDevice(1), pool), sink, {}, clock);
        session.setPace({.automatic = true});
        session.submit(sceneToShare(), false);
        session.goOn();
        QTRY_VERIFY_WITH_TIMEOUT(count() >= 6, kPatience);
        const std::lock_guard lock(mutex);
        for (std::size_t i = 0; i + 1 < shown.size(); ++i) {
            const std::uint64_t had = shown[i], blockEnd = had - had % kSamplesPerBlock + kSamplesPerBlock;
            const std::uint64_t end = had < kSamplesPerBlock ? had + FirstSamples::leftToMark(had) : blockEnd;
            QVERIFY(shown[i + 1] >= end);
        }
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

    /// What is wanted of a slow worker does not pile up with it.
    void orderEndsAndItsLeasesStayOut() {
        WorkerPool pool(1);
        pool.setSplit(Split::samples);
        const WorkerId worker = pool.join("key", "slow");
        const std::uint64_t scene = pool.publish(Purpose::viewport, std::make_shared<const Scene>(sceneToShare()));
        pool.hasScene(worker, scene);
        const auto ordered = [&] {
            Film film(Tile{0, 0, 32, 32}, 7);
            if (!pool.begin(film, scene, {{film.area(), 0, 1000}}, {}))
                qFatal("nobody else wants the workers");
            const std::optional<Lease> lease = pool.take(worker);
            (void)pool.end();
            return lease;
        };
        const std::optional<Lease> first = ordered();
        QVERIFY(first && !ordered());
        pool.abandon(worker, first->number);
        QVERIFY(ordered());
    }

    void finalRenderHasTheWorkersUntilItIsDone() {
        const auto pool = newPool();
        NearbyWorker worker(pool, "one");
        const auto viewport = shareDevice(makeCpuDevice(1), pool);
        const auto film = *startFilm(*viewport, sceneToShare());
        std::atomic<bool> done = false;
        std::vector<std::uint32_t> orders;
        std::jthread viewer([&] {
            while (!done)
                if (film->accumulate(10, {}))
                    orders.push_back(10);
        });
        Scene scene = sceneToShare();
        scene.film = {60, 50};
        {
            const auto device = shareDevice(makeCpuDevice(1), pool, Purpose::finalRender);
            const auto saved = *startFilm(*device, scene);
            QCOMPARE(pool->scene().purpose, Purpose::finalRender);
            std::vector<std::uint32_t> taken;
            for (const double before = worker.status().work; worker.status().work == before; taken.push_back(70))
                QVERIFY(saved->accumulate(70, {}));
            QVERIFY(sameBits((*saved->film())->content(), alone(scene, taken)));
        }
        QCOMPARE(pool->scene().purpose, Purpose::viewport);
        for (const double before = worker.status().work; worker.status().work == before;)
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        done = true;
        viewer.join();
        QVERIFY(sameBits((*film->film())->content(), alone(sceneToShare(), orders)));
    }

    void viewportIsGivenUpWhereAFinalRenderWaits() {
        const auto pool = newPool();
        pool->setOwnHelps(false);
        NearbyWorker silent(pool, "silent", NearbyWorker::Nature::silent);
        const auto viewport = shareDevice(makeCpuDevice(1), pool);
        const auto film = *startFilm(*viewport, sceneToShare());
        std::jthread viewer([&] { (void)film->accumulate(64, {}); });  // all of it is with somebody who is silent
        const auto device = shareDevice(makeCpuDevice(1), pool, Purpose::finalRender);
        const auto saved = *startFilm(*device, sceneToShare());
        viewer.join();  // the own device has done it
        QVERIFY(sameBits((*film->film())->content(), alone(sceneToShare(), {64})));
    }
};

QTEST_APPLESS_MAIN(SharedDeviceTest)
#include "shared_device_test.moc"
