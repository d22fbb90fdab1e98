// First: it includes TBB, of whose names Qt takes some for keywords.
#include "tests/support/scenes/shared_films.h"

#include <QTest>

#include "render/tiles/result_check.h"
#include "render/tiles/trace_lease.h"
#include "tests/support/network/nearby_worker.h"

using namespace pdr;
using namespace pdr::test;

/// Images that workers with wrong results have helped with.
class LiarsTest : public QObject {
    Q_OBJECT

  private slots:
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
};

QTEST_APPLESS_MAIN(LiarsTest)
#include "liars_test.moc"
