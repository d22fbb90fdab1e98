/// What a session shows of a scene, in which order, to whom, and that nothing of it stays when it is closed.

#include <QTest>
#include <algorithm>
#include <atomic>
#include <ctime>
#include <future>
#include <mutex>
#include <thread>

#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/reel.h"
#include "tests/support/patience.h"
#include "tests/support/scenes/images.h"

using namespace pdr;
using namespace std::chrono_literals;
using test::largeScene;
using test::Reel;

namespace {

/// The answer to a snapshot request.
struct Answer {
    std::promise<Result<Film>> film;
    SnapshotObserver look() {
        return [this](const Result<FilmView>& view) {
            film.set_value(view ? Result<Film>(view->film) : Result<Film>(view.error()));
        };
    }
    /// Returns the error that refused the request; null if there was no answer for minutes, or if there was a film.
    std::optional<Error> refusal() {
        auto future = film.get_future();
        if (future.wait_for(1800s) != std::future_status::ready)
            return std::nullopt;
        const Result<Film> result = future.get();
        return result ? std::nullopt : std::optional(result.error());
    }
};

std::unique_ptr<Device> makeDevice(const std::string& name) {
    if (name == "cpu")
        return makeCpuDevice(1);
    return test::failing(std::make_shared<test::Mishaps>());
}

}  // namespace

class FirstLookTest : public QObject {
    Q_OBJECT

  private slots:
    void everySceneIsCoarseFirstAndThenFull() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->iterationSeconds = 0.05;
        Reel reel;
        Session session(test::failing(mishaps), reel.sink());
        for (std::uint64_t revision = 1; revision <= 4; ++revision) {
            session.submit(largeScene(revision), false);
            QTRY_VERIFY_WITH_TIMEOUT(reel.full(revision, 2), test::kPatience);
        }
        for (std::uint64_t revision = 1; revision <= 4; ++revision) {
            const auto frames = reel.of(revision);
            QVERIFY(frames.front()->coarse);
            QVERIFY(frames.front()->size.x < 400 && frames.front()->size.y < 300);
            const auto full = std::ranges::find_if(frames, [](const auto& frame) { return !frame->coarse; });
            for (auto frame = full; frame != frames.end(); ++frame)
                QVERIFY(!(*frame)->coarse && (*frame)->size == ivec2(400, 300));
        }
    }

    void aFrameKnowsItsCameraAndItsLook() {
        Reel reel;
        Session session(makeCpuDevice(1), reel.sink());
        for (std::uint64_t revision = 1; revision <= 20; ++revision) {
            session.submit(largeScene(revision), revision % 4 != 0);
            std::this_thread::sleep_for(std::chrono::milliseconds(5 * (revision % 3)));
        }
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(20), test::kPatience);
        for (const auto& frame : reel.frames()) {
            QVERIFY(frame->camera == largeScene(frame->revision).camera);
            QCOMPARE(frame->lookName, largeScene(frame->revision).lookName);
        }
    }

    void theFilmAtRestIsThatOfTheSceneAlone() {
        Reel reel;
        Session session(makeCpuDevice(1), reel.sink());
        session.submit(largeScene(1), true);
        session.submit(largeScene(2), false);
        Answer answer;
        session.requestSnapshot(2, answer.look());
        auto film = answer.film.get_future();
        QVERIFY(film.wait_for(1800s) == std::future_status::ready);
        const Result<Film> seen = film.get();
        QVERIFY(seen);
        QVERIFY(test::sameBits(*seen, test::render(largeScene(2), seen->samplesPerPixel())));
    }

    /// The image of the last move was a first image already.
    void aHandAtRestNeedsNoSecondFirstLook() {
        auto mishaps = std::make_shared<test::Mishaps>();
        std::mutex gate;
        std::atomic<bool> atTheGate = false;
        mishaps->before = [&](const std::string& verb) {
            if (verb != "accumulate")
                return;
            atTheGate = true;
            const std::lock_guard through(gate);
            atTheGate = false;
        };
        Reel reel;
        Session session(test::failing(mishaps), reel.sink());
        session.submit(largeScene(1), true);
        QTRY_VERIFY_WITH_TIMEOUT(!reel.of(1).empty(), test::kPatience);
        std::unique_lock closed(gate);
        QTRY_VERIFY_WITH_TIMEOUT(atTheGate, test::kPatience);
        const std::size_t before = reel.of(1).size() + 1;  // the running launch is shown
        session.setPaused(true);
        closed.unlock();
        QTRY_COMPARE_WITH_TIMEOUT(reel.of(1).size(), before, test::kPatience);
        session.submit(largeScene(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.of(1).size() > before, test::kPatience);
        QVERIFY(!reel.of(1)[before]->coarse);
    }

    void aPausedSessionShowsBothAndHolds() {
        Reel reel;
        Session session(makeCpuDevice(1), reel.sink());
        session.setPaused(true);
        session.submit(largeScene(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1), test::kPatience);
        QTest::qWait(200);
        QVERIFY(reel.frames().front()->coarse);
        QCOMPARE(std::ranges::count_if(reel.frames(), [](const auto& frame) { return !frame->coarse; }),
                 std::ptrdiff_t(1));
        QCOMPARE(reel.frames().back()->status.samplesPerPixel, reel.frames().front()->status.samplesPerPixel);
    }

    void whoAsksForAnOlderSceneIsTold() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->iterationSeconds = 0.05;
        Reel reel;
        Session session(test::failing(mishaps), reel.sink());
        session.submit(largeScene(1), true);  // the user still drags, so there is no snapshot
        Answer pending, late;
        session.requestSnapshot(1, pending.look());
        QTest::qWait(100);
        session.submit(largeScene(2), false);
        const auto refusal = pending.refusal();
        QVERIFY(refusal && refusal->what.find("another image") != std::string::npos && !refusal->hint.empty());
        session.requestSnapshot(1, late.look());
        QVERIFY(late.refusal());
    }

    void whoAsksForASceneThatFailsIsTold() {
        Reel reel;
        Session session(makeCpuDevice(1), reel.sink());
        Scene wrong = largeScene(1);
        wrong.phaseG = 1;
        session.submit(wrong, false);
        Answer pending, late;
        session.requestSnapshot(1, pending.look());
        const auto refusal = pending.refusal();
        QVERIFY(refusal && refusal->what.find("could not be rendered") != std::string::npos);
        session.requestSnapshot(1, late.look());
        QVERIFY(late.refusal());
    }

    void whoAsksOfADeviceThatIsLostIsTold() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->iterationSeconds = 0.2;
        mishaps->accumulates = 0;
        Reel reel;
        Session session(test::failing(mishaps), reel.sink());
        session.submit(largeScene(1), false);
        Answer pending;
        session.requestSnapshot(1, pending.look());
        QVERIFY(pending.refusal());
    }

    void whoAsksForWhatIsClosedIsTold() {
        Reel reel;
        Session session(makeCpuDevice(1), reel.sink());
        Answer before, pending, late;
        session.requestSnapshot(0, before.look());
        QVERIFY(before.refusal());
        session.submit(largeScene(1), true);
        session.requestSnapshot(1, pending.look());
        session.clear();
        const auto refusal = pending.refusal();
        QVERIFY(refusal && refusal->what.find("closed") != std::string::npos);
        session.requestSnapshot(1, late.look());
        QVERIFY(late.refusal());
    }

    void aClosedSceneIsFreedAndCostsNothing_data() { devices(); }
    void aClosedSceneIsFreedAndCostsNothing() {
        QFETCH(QString, device);
        Reel reel;
        Session session(makeDevice(device.toStdString()), reel.sink());
        Scene scene = largeScene(1);
        const std::weak_ptr<const Volume> volume = scene.volume;
        session.submit(std::move(scene), false);
        scene = {};
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1, 3), test::kPatience);
        QVERIFY(!volume.expired());
        session.clear();
        QTRY_VERIFY_WITH_TIMEOUT(volume.expired(), test::kPatience);
        const std::size_t frames = reel.frames().size();
        const std::clock_t start = std::clock();
        QTest::qWait(500);
        QVERIFY(double(std::clock() - start) / CLOCKS_PER_SEC < 0.1);  // processor time
        QCOMPARE(reel.frames().size(), frames);
        session.setDevice([] { return makeCpuDevice(1); });
        session.setDisplay({.exposure = 2});
        session.submit(largeScene(2), false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(2), test::kPatience);
    }

    void clearingAtAnyMomentIsSound() {
        for (int i = 0; i < 40; ++i) {
            Reel reel;
            Session session(makeDevice(i % 2 ? "cpu" : "gpu"), reel.sink());
            session.submit(largeScene(1), i % 3 == 0);
            std::this_thread::sleep_for(std::chrono::microseconds(i * 300));
            session.clear();
            if (i % 4 == 0)
                session.submit(largeScene(2), false);
            std::this_thread::sleep_for(std::chrono::microseconds(i * 100));
            session.clear();
        }
    }

  private:
    static void devices() {
        QTest::addColumn<QString>("device");
        QTest::newRow("cpu") << "cpu";
        QTest::newRow("gpu") << "gpu";
    }
};

QTEST_GUILESS_MAIN(FirstLookTest)
#include "first_look_test.moc"
