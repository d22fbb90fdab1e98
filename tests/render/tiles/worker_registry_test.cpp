#include <QTest>

#include "render/tiles/worker_registry.h"

using namespace pdr;

namespace {

constexpr std::uint64_t kScene = 3;

/// Adds a worker that takes leases of kScene, with a speed of 100 cost/s.
WorkerId joinReady(WorkerRegistry& registry, const std::string& key) {
    const WorkerId id = registry.join(key, "name");
    registry.find(id)->scene = kScene;
    registry.find(id)->speed.add(100, 1);
    return id;
}

}  // namespace

/// What is remembered of workers, by number while they are connected and by key for good.
class WorkerRegistryTest : public QObject {
    Q_OBJECT

  private slots:
    void trustOutlastsALeave() {
        WorkerRegistry registry(1);
        const WorkerId first = registry.join("key", "name");
        registry.find(first)->trust.confirmed(Trust::kProof);
        registry.leave(first);
        QVERIFY(!registry.find(first));
        QVERIFY(registry.find(registry.join("key", "name"))->trust.isProved());
        QVERIFY(registry.find(registry.join("another", "name"))->trust.isStranger());
    }

    void quarantineHoldsForAllWorkersOfAKey() {
        WorkerRegistry registry(1);
        const WorkerId one = registry.join("key", "name"), two = registry.join("key", "name");
        const WorkerId other = registry.join("another", "name");
        QCOMPARE(registry.quarantine("key", "it lied"), (std::vector<WorkerId>{one, two}));
        QCOMPARE(registry.quarantine("key", "it lied again"), (std::vector<WorkerId>{one, two}));
        registry.leave(two);
        const WorkerId late = registry.join("key", "name");
        for (const WorkerId id : {one, late}) {
            QVERIFY(registry.find(id)->isQuarantined());
            QCOMPARE(registry.find(id)->status.reason, std::string("it lied"));
        }
        QVERIFY(!registry.find(other)->isQuarantined());
        QVERIFY(registry.isAnyUntrusted({"another", "key"}));
        QVERIFY(!registry.isAnyUntrusted({"another"}));
    }

    void quarantineHoldsForAWorkerThatIsAway() {
        WorkerRegistry registry(1);
        QVERIFY(registry.quarantine("key", "it lied").empty());
        QVERIFY(registry.find(registry.join("key", "name"))->isQuarantined());
        QVERIFY(!registry.hasTrusted());
        (void)registry.join("another", "name");
        QVERIFY(registry.hasTrusted());
    }

    void onlyWorkersThatTakeLeasesCount() {
        WorkerRegistry registry(1);
        (void)joinReady(registry, "one");
        registry.find(joinReady(registry, "paused"))->isPaused = true;
        registry.find(joinReady(registry, "of another scene"))->scene = kScene + 1;
        (void)joinReady(registry, "quarantined");
        (void)registry.quarantine("quarantined", "it lied");
        QCOMPARE(registry.countTaking(kScene), 1);
        QCOMPARE(registry.perSecond(kScene), 100.0);
    }
};

QTEST_APPLESS_MAIN(WorkerRegistryTest)
#include "worker_registry_test.moc"
