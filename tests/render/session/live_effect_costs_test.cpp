/// The cost table of effects is filled beside the image, which it does not change, and only while there is an observer.

#include <QTest>

#include <algorithm>
#include <atomic>
#include <future>
#include <mutex>
#include <optional>

#include "render/session/live_effect_costs.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/reel.h"
#include "tests/support/devices/screen.h"

using namespace pdr;

namespace {

/// Returns a small scene; all of them share one volume.
Scene smallScene(std::uint64_t revision) {
    static const Scene first = test::largeScene(1);
    Scene scene = first;
    scene.film = {24, 16};
    scene.camera.eyeMm.x += double(revision);
    scene.revision = revision;
    return scene;
}

/// An observer that counts its calls.
struct Watcher {
    std::atomic<int> opened = 0, launches = 0;
    std::shared_ptr<test::Mishaps> mishaps = std::make_shared<test::Mishaps>();

    Watcher() {
        mishaps->before = [this](const std::string& verb) { launches += verb == "accumulate"; };
    }
    EffectsWatch watch() {
        return {[this]() -> Result<std::unique_ptr<Device>> {
                    ++opened;
                    return test::failing(mishaps);
                },
                [this](std::shared_ptr<const EffectCosts> effectCosts) {
                    const std::lock_guard lock(mutex_);
                    told_ = std::move(effectCosts);
                    ++times_;
                }};
    }
    /// Returns the table that was reported last; an empty one if there was none.
    EffectCosts told() const {
        const std::lock_guard lock(mutex_);
        return told_ ? *told_ : EffectCosts();
    }
    int times() const {
        const std::lock_guard lock(mutex_);
        return times_;
    }

  private:
    mutable std::mutex mutex_;
    std::shared_ptr<const EffectCosts> told_;
    int times_ = 0;
};

int trials(const EffectCosts& effectCosts, bool ofViewBefore) {
    return int(std::ranges::count_if(
        effectCosts.effects, [&](const TriedEffect& row) { return row.trial && row.ofViewBefore == ofViewBefore; }));
}

/// A cost table that the test drives itself.
struct Live {
    Watcher watcher;
    std::shared_ptr<test::FakeClock> clock = std::make_shared<test::FakeClock>();
    LiveEffectCosts effectCosts{test::readingOf(clock)};

    explicit Live(const Scene& scene) {
        watcher.mishaps->clock = clock;
        effectCosts.watch(watcher.watch());
        effectCosts.follow(scene, {});
    }
    void finish() {
        while (effectCosts.hasWork())
            effectCosts.step({});
    }
};

}  // namespace

class LiveEffectCostsTest : public QObject {
    Q_OBJECT

  private slots:
    void allThatCanBeTriedIsTried() {
        Live live(smallScene(1));
        live.finish();
        const EffectCosts effectCosts = live.watcher.told();
        QVERIFY(effectCosts.complete && effectCosts.film == ivec2(24, 16) && effectCosts.seconds > 0);
        QVERIFY(trials(effectCosts, false) > 0 && trials(effectCosts, true) == 0);
        for (const TriedEffect& row : effectCosts.effects)
            QCOMPARE(row.trial.has_value(), row.canBeTried());
    }

    void aMovedCameraKeepsWhatIsKnownAsThatOfTheViewBefore() {
        Live live(smallScene(1));
        live.finish();
        const int rows = trials(live.watcher.told(), false);
        live.effectCosts.follow(smallScene(2), {});
        QVERIFY(!live.watcher.told().complete && live.effectCosts.hasWork());
        QCOMPARE(trials(live.watcher.told(), true), rows);
        live.effectCosts.step({});
        QCOMPARE(trials(live.watcher.told(), true), rows);
        live.finish();
        QCOMPARE(trials(live.watcher.told(), true), 0);
        QCOMPARE(trials(live.watcher.told(), false), rows);
    }

    void anotherBrightnessIsAnotherView() {
        Live live(smallScene(1));
        live.finish();
        live.effectCosts.follow(smallScene(1), {.exposure = 2});
        QVERIFY(live.effectCosts.hasWork() && trials(live.watcher.told(), true) > 0);
    }

    void anotherLookForgetsWhatIsKnown() {
        Live live(smallScene(1));
        live.finish();
        Scene other = smallScene(2);
        other.gradientFactor = 1;
        live.effectCosts.follow(other, {});
        QVERIFY(live.watcher.told().effects.empty() && live.effectCosts.hasWork());
    }

    void whatIsCancelledLeavesNoTrace() {
        Live live(smallScene(1));
        for (int i = 0; i < 5; ++i)
            live.effectCosts.step({});
        QVERIFY(live.watcher.launches > 0);
        const int told = live.watcher.times();
        std::stop_source stop;
        stop.request_stop();
        live.effectCosts.step(stop.get_token());
        QCOMPARE(live.watcher.times(), told);
        Scene other = smallScene(2);
        other.lights.clear();
        other.environment.visible = false;
        live.effectCosts.follow(other, {});
        live.finish();
        QVERIFY(live.watcher.told().complete);
        QCOMPARE(trials(live.watcher.told(), false) + trials(live.watcher.told(), true), 0);
    }

    /// Each step takes a second of 20.
    void measuringTakesATwentiethOfTheTime() {
        Live live(smallScene(1));
        live.watcher.mishaps->iterationSeconds = 1;
        QVERIFY(live.effectCosts.isDue());
        while (live.watcher.launches == 0)
            live.effectCosts.step({});
        const double spent = live.clock->seconds() - 1;
        QVERIFY(spent >= 1 && !live.effectCosts.isDue());
        live.clock->advanceTo(1 + 19.9 * spent);
        QVERIFY(!live.effectCosts.isDue());
        live.clock->advanceTo(1 + 20.1 * spent);
        QVERIFY(live.effectCosts.isDue());
    }

    void aDeviceThatFailsIsToldOnce() {
        Live live(smallScene(1));
        live.watcher.mishaps->accumulates = 3;
        live.finish();
        QVERIFY(live.watcher.told().failure.find("the device is lost") != std::string::npos);
        QCOMPARE(live.watcher.opened.load(), 2);
    }

    void nobodyLooksAndNothingIsMeasured() {
        Live live(smallScene(1));
        live.effectCosts.step({});
        live.effectCosts.watch({});
        QVERIFY(!live.effectCosts.hasWork());
        live.effectCosts.follow(smallScene(2), {});
        QVERIFY(!live.effectCosts.hasWork());
    }

    /// While rendering is stopped, measuring runs to its end; it makes no frame, and the film stays the same to the
    /// last bit.
    void theImageStaysAsItIs() {
        std::optional<FilmContent> films[2];
        for (const bool watched : {false, true}) {
            test::Screen screen;
            Watcher watcher;
            Session session(makeCpuDevice(2), screen.sink());
            session.setIterationsPerFrame(50);
            if (watched)
                session.watchEffects(watcher.watch());
            session.submit(smallScene(1), false);
            QVERIFY(screen.await([](const Frame& frame) { return frame.reached; }));
            if (watched)
                QTRY_VERIFY_WITH_TIMEOUT(watcher.told().complete, 1800000);
            const int frames = screen.count();
            QTest::qWait(50);
            QCOMPARE(screen.count(), frames);
            std::promise<FilmContent> content;
            session.requestSnapshot(1, [&](const Result<FilmView>& view) { content.set_value(view->film.content()); });
            films[watched] = content.get_future().get();
            QCOMPARE(watcher.opened.load(), watched ? 2 : 0);
        }
        QVERIFY(sameBits(*films[0], *films[1]));
    }

    /// This includes a long rendering, and the time after the observer has left.
    void nothingRunsWhileNobodyLooks() {
        test::Screen screen;
        Watcher watcher;
        Session session(makeCpuDevice(2), screen.sink());
        session.submit(smallScene(1), false);
        QVERIFY(screen.await([](const Frame& frame) { return frame.reached; }));
        QCOMPARE(watcher.opened + watcher.launches, 0);
        session.watchEffects(watcher.watch());
        QTRY_VERIFY_WITH_TIMEOUT(watcher.launches > 0, 1800000);
        session.watchEffects({});
        session.submit(smallScene(2), false);
        QVERIFY(screen.await([](const Frame& frame) { return frame.revision == 2 && frame.reached; }));
        const int launches = watcher.launches, told = watcher.times();
        session.submit(smallScene(3), false);
        QVERIFY(screen.await([](const Frame& frame) { return frame.revision == 3 && frame.reached; }));
        QCOMPARE(watcher.launches.load(), launches);
        QCOMPARE(watcher.times(), told);
    }

    void aClosedImageHasNoLedger() {
        test::Screen screen;
        Watcher watcher;
        Session session(makeCpuDevice(2), screen.sink());
        session.watchEffects(watcher.watch());
        session.submit(smallScene(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(!watcher.told().effects.empty(), 1800000);
        session.clear();
        QTRY_VERIFY_WITH_TIMEOUT(watcher.told().effects.empty(), 1800000);
    }
};

QTEST_GUILESS_MAIN(LiveEffectCostsTest)
#include "live_effect_costs_test.moc"
