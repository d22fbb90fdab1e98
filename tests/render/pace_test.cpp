/// How many iterations a frame gets: the rate that was asked for, the efficiency that the rate allows, and no picture
/// that waits behind others.

#include <QTest>
#include <algorithm>
#include <chrono>
#include <future>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/support/failing_device.h"
#include "tests/support/scenes.h"
#include "tests/support/screen.h"

using namespace pdr;
using namespace std::chrono_literals;

namespace {

using Clock = std::chrono::steady_clock;

Scene someScene(std::uint64_t revision = 1) {
    Scene scene = test::plainScene(test::bumpyVolume({20, 20, 20}, dvec3(1), 3), 1);
    scene.film = {8, 8};
    scene.revision = revision;
    return scene;
}

/// Frames and when they came.
class Reel {
  public:
    FrameSink sink() {
        return [this](std::shared_ptr<const Frame> frame) {
            const std::lock_guard lock(mutex_);
            frames_.push_back({Clock::now(), std::move(frame)});
        };
    }
    struct Shot {
        Clock::time_point at;
        std::shared_ptr<const Frame> frame;
    };
    std::vector<Shot> shots() {
        const std::lock_guard lock(mutex_);
        return frames_;
    }

  private:
    std::mutex mutex_;
    std::vector<Shot> frames_;
};

/// Frames a second over the last `count` of them.
double rate(const std::vector<Reel::Shot>& shots, std::size_t count) {
    const double seconds = std::chrono::duration<double>(shots.back().at - shots[shots.size() - 1 - count].at).count();
    return double(count) / seconds;
}

}  // namespace

class PaceTest : public QObject {
    Q_OBJECT

  private slots:
    void medianFramesDecide() {
        PaceMeter meter;
        const Pace pace{.automatic = true, .framesPerSecond = 1, .efficiency = 0.9};
        QCOMPARE(meter.iterations(pace), 1u);
        QCOMPARE(meter.efficiency(), 0.0);
        for (int i = 0; i < 9; ++i)
            meter.addFrame(10, i == 4 ? 5.0 : 0.020, i == 5 ? 3.0 : 0.004);  // two that another program delayed
        QCOMPARE(meter.iterations(pace), 18u);                               // 9 * 4 ms / 2 ms
        QVERIFY(std::abs(meter.efficiency() - 20.0 / 24) < 1e-9);
        QCOMPARE(meter.iterations({.iterations = 77}), 77u);
        meter.clear();
        QCOMPARE(meter.iterations(pace), 1u);
    }

    void firstGuessesAreCareful() {
        PaceMeter meter;
        const Pace pace{.automatic = true, .framesPerSecond = 0.1, .efficiency = 0.98};
        meter.addFrame(1, 0, 0.01);  // too short to be measured
        QCOMPARE(meter.iterations(pace), 4u);
    }

    void numbersStayInTheirRanges() {
        const Pace wild = Pace{true, 0, 1e9, 2}.clamped();
        QCOMPARE(wild.iterations, 1);
        QCOMPARE(wild.framesPerSecond, 60.0);
        QVERIFY(wild.efficiency < 1);
        QCOMPARE((Pace{false, 1 << 30, 0, -1}.clamped().iterations), 10000);
    }

    void theRateIsReached_data() {
        QTest::addColumn<double>("framesPerSecond");
        QTest::addColumn<int>("ahead");
        for (const int ahead : {1, 3})
            for (const double rate : {10.0, 20.0})
                QTest::newRow(qPrintable(QString("%1/s, %2 ahead").arg(rate).arg(ahead))) << rate << ahead;
    }

    /// 3 ms an iteration, 2 ms to show it: 98 % would take 33 iterations, 100 ms; so the rate decides above 10 a
    /// second.
    void theRateIsReached() {
        QFETCH(double, framesPerSecond);
        QFETCH(int, ahead);
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->iterationSeconds = 0.003;
        mishaps->displaySeconds = 0.004;
        mishaps->ahead = ahead;
        Reel reel;
        Session session(test::failing(mishaps), reel.sink());
        session.setPace({.automatic = true, .framesPerSecond = framesPerSecond});
        session.submit(someScene(), false);
        std::this_thread::sleep_for(std::chrono::duration<double>(0.5 + 8 / framesPerSecond));
        const auto shots = reel.shots();
        QVERIFY(shots.size() > 6);
        const double reached = rate(shots, 4);
        QVERIFY2(std::abs(reached / framesPerSecond - 1) < 0.3, qPrintable(QString("%1 frames/s").arg(reached)));
    }

    void theEfficiencyIsReachedWhereTheRateAllows_data() {
        QTest::addColumn<int>("ahead");
        QTest::newRow("nothing behind") << 1;
        QTest::newRow("3 ahead") << 3;
    }

    void theEfficiencyIsReachedWhereTheRateAllows() {
        QFETCH(int, ahead);
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->iterationSeconds = 0.004;
        mishaps->displaySeconds = 0.001;
        mishaps->ahead = ahead;
        Reel reel;
        Session session(test::failing(mishaps), reel.sink());
        session.setPace({.automatic = true, .framesPerSecond = 2, .efficiency = 0.95});
        session.submit(someScene(), false);
        std::this_thread::sleep_for(1200ms);
        const auto shots = reel.shots();
        const Frame& last = *shots.back().frame;
        QVERIFY2(last.efficiency >= 0.94 && last.efficiency <= 1, qPrintable(QString::number(last.efficiency)));
        // No more than it takes: 19 * 1 ms / 4 ms.
        QVERIFY2(last.iterations >= 4 && last.iterations <= 8, qPrintable(QString::number(last.iterations)));
        QVERIFY(rate(shots, 4) > 2);
    }

    /// A scene's first picture and those of a moving hand come when they are there, not when the next ones have been
    /// ordered; at rest the copies overlap the iterations.
    void firstAndMovingPicturesDoNotQueue() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->iterationSeconds = 0.2;
        mishaps->ahead = 4;
        Reel reel;
        Session session(test::failing(mishaps), reel.sink());
        const auto start = Clock::now();
        session.submit(someScene(1), false);
        QTRY_VERIFY(!reel.shots().empty());
        const double first = std::chrono::duration<double>(reel.shots().front().at - start).count();
        QVERIFY2(first < 0.35, qPrintable(QString("%1 s").arg(first)));
        mishaps->iterationSeconds = 0.02;
        for (std::uint64_t revision = 2; revision < 6; ++revision) {
            const auto moved = Clock::now();
            session.submit(someScene(revision), true);
            QTRY_VERIFY(reel.shots().back().frame->revision == revision);
            const auto shots = reel.shots();
            const auto shown = std::find_if(shots.begin(), shots.end(),
                                            [&](const auto& shot) { return shot.frame->revision == revision; });
            // 4 iterations, and what was under way when the hand moved.
            QVERIFY(shown->at - moved < 450ms);
        }
    }

    void picturesComeInOrderAndNoneIsLost() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->iterationSeconds = 0.001;
        mishaps->displaySeconds = 0.002;
        mishaps->ahead = 3;
        Reel reel;
        Session session(test::failing(mishaps), reel.sink());
        session.setIterationsPerFrame(3);
        session.submit(someScene(), false);
        QTRY_VERIFY(reel.shots().size() >= 60);
        session.setPaused(true);
        std::this_thread::sleep_for(300ms);  // all that was ordered has come
        const auto shots = reel.shots();
        for (std::size_t i = 0; i + 1 < shots.size(); ++i)
            QCOMPARE(shots[i].frame->status.samplesPerPixel, 3 * (i + 1));
        std::promise<std::uint64_t> samples;
        session.inspect(1, [&](const Result<FilmView>& view) { samples.set_value(view->film.samplesPerPixel()); });
        QCOMPARE(shots.back().frame->status.samplesPerPixel, samples.get_future().get());
    }
};

QTEST_GUILESS_MAIN(PaceTest)
#include "pace_test.moc"
