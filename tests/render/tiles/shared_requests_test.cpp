// First: it includes TBB, of whose names Qt takes some for keywords.
#include "tests/support/scenes/shared_films.h"

#include <QTest>

#include <atomic>
#include <mutex>
#include <random>
#include <thread>

#include "render/session/session.h"
#include "tests/support/network/nearby_worker.h"
#include "tests/support/patience.h"

using namespace pdr;
using namespace pdr::test;

/// Images while workers come, go and say nothing, while an order is stopped, and while another image wants the workers.
class SharedRequestsTest : public QObject {
    Q_OBJECT

  private slots:
    void imageSurvivesThoseWhoLeave() {
        const auto pool = newPool();
        std::atomic<bool> done = false;
        std::jthread crowd([&] {
            std::mt19937 random(5);
            std::vector<std::unique_ptr<NearbyWorker>> all;
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
    void imagesOfAWindowWithNodesGrowFourfold() {
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
        QTRY_VERIFY_WITH_TIMEOUT(count() >= 4, kPatience);
        const std::lock_guard lock(mutex);
        for (std::size_t i = 1; i + 1 < shown.size(); ++i)  // the first one may have begun before the worker took part
            QVERIFY(shown[i + 1] >= 4 * shown[i]);
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

QTEST_APPLESS_MAIN(SharedRequestsTest)
#include "shared_requests_test.moc"
