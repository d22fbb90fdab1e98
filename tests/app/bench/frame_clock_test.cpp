#include <QTest>
#include <algorithm>
#include <chrono>
#include <thread>

#include "app/bench/paper/measurement.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;
using namespace pdr::bench;
using namespace pdr::bench::paper;

namespace {

/// Takes `seconds` an iteration, on a clock that nothing else moves, and writes down what it was asked.
struct Diary {
    double seconds = 0.002;
    bool sleeps = false;  ///< on the wall's clock too
    int maxInFlight = 1;
    int iterations = 0, shown = 0, taken = 0, mostWaiting = 0;
    std::stop_source* stopAfterThree = nullptr;
    double now = 0;

    WorkClock clock() {
        return [this] { return now; };
    }
};

class SlowFilm final : public Accumulator {
  public:
    explicit SlowFilm(Diary& diary) : diary_(diary) {}

    Tile area() const override { return {0, 0, 4, 4}; }
    Result<void> accumulate(const Tile&, std::uint32_t n, std::stop_token) override {
        if (diary_.sleeps)
            std::this_thread::sleep_for(std::chrono::duration<double>(n * diary_.seconds));
        diary_.now += n * diary_.seconds;
        diary_.iterations += int(n);
        return {};
    }
    Result<void> resolve(const Display&, std::stop_token) override {
        ++diary_.shown;
        diary_.mostWaiting = std::max(diary_.mostWaiting, diary_.shown - diary_.taken);
        return {};
    }
    Result<Image> readback() override {
        ++diary_.taken;
        if (diary_.stopAfterThree != nullptr && diary_.taken == 3)
            diary_.stopAfterThree->request_stop();
        return Image{{}, {.samplesPerPixel = 16, .relativeError = 0.25}};
    }
    int maxInFlight() const override { return diary_.maxInFlight; }
    Result<std::shared_ptr<const Film>> film() override { return Error{"none", "", ""}; }
    Result<void> resume(const Film&) override { return {}; }
    Result<void> restart(const Tile&, std::uint64_t) override { return {}; }

  private:
    Diary& diary_;
};

/// Makes slow films, save where Exposure Render's schedule is asked for and `refusesKroes`.
class SlowDevice final : public Device {
  public:
    explicit SlowDevice(Diary& diary, bool refusesKroes = false) : diary_(diary), refusesKroes_(refusesKroes) {}

    DeviceInfo info() const override { return {"slow", ""}; }
    Result<void> upload(const Scene&) override { return {}; }
    Result<void> unload() override { return {}; }
    Result<std::unique_ptr<Accumulator>> film(const Tile&, std::uint64_t, const Schedule& schedule) override {
        if (refusesKroes_ && schedule.kind == Schedule::Kind::kroes)
            return Error{"there is no room", "", ""};
        return std::unique_ptr<Accumulator>(std::make_unique<SlowFilm>(diary_));
    }

  private:
    Diary& diary_;
    bool refusesKroes_;
};

Scene smallScene() {
    return test::plainScene(test::makeVolume({4, 4, 4}, dvec3(1), [](int, int, int) { return 100; }), 1);
}

Result<void> measured(
    Device& device, Diary& diary, const Plan& plan, Measured& result, std::stop_token stop = {},
    const OnMeasurement& watch = [](const Cell&, int, double) {}) {
    const auto load = processorLoad(1);
    return measure(device, smallScene(), {}, plan, diary.clock(), *load, watch, std::move(stop), result);
}

}  // namespace

class FrameClockTest : public QObject {
    Q_OBJECT

  private slots:
    void firstFrameWarmsUp() {
        Diary diary;
        SlowFilm film(diary);
        const auto lap = timeFrames(film, 3, {}, 0.02, diary.clock(), {});
        QVERIFY(bool(lap));
        QVERIFY(lap->seconds >= 0.02);
        QCOMPARE(int(lap->frames), diary.taken - 1);
        QCOMPARE(diary.iterations, 3 * diary.shown);
        QCOMPARE(lap->sampleNoise, 1.0);
        QVERIFY(lap->seconds >= 3 * diary.seconds * double(lap->frames));
        QCOMPARE(diary.mostWaiting, 1);
    }

    void frameThatFillsTheTimeCountsAlone() {
        Diary diary;
        SlowFilm film(diary);
        const auto lap = timeFrames(film, 20, {}, 0.01, diary.clock(), {});
        QVERIFY(bool(lap));
        QCOMPARE(int(lap->frames), 1);
        QCOMPARE(diary.taken, 1);
        QVERIFY(lap->seconds >= 20 * diary.seconds);
    }

    /// A film that sleeps spends next to nothing on the processor: the clock tells which time it is.
    void processorsClockLeavesOutWhatOthersTake() {
        Diary diary{.sleeps = true};
        SlowFilm film(diary);
        const auto lap = timeFrames(film, 1, {}, 0.001, clockOf(TimeOf::processor, 1), {});
        QVERIFY(bool(lap));
        QVERIFY(lap->seconds >= 0.001);
        QVERIFY(lap->seconds < 0.5 * diary.seconds * double(lap->frames));
        const WorkClock one = clockOf(TimeOf::processor, 1), ten = clockOf(TimeOf::processor, 10);
        const double spent = one(), tenth = ten();
        QVERIFY(tenth >= 0.1 * spent && tenth <= 0.1 * one());
    }

    void asManyAreOrderedAheadAsTheFilmAllows() {
        Diary diary{.maxInFlight = 3};
        SlowFilm film(diary);
        const auto lap = timeFrames(film, 1, {}, 0.02, diary.clock(), {});
        QVERIFY(bool(lap));
        QCOMPARE(diary.mostWaiting, 3);
        QCOMPARE(int(lap->frames), diary.taken - 1);
    }

    void whatWasWholeBeforeAStopCounts() {
        std::stop_source stop;
        Diary diary{.stopAfterThree = &stop};
        SlowFilm film(diary);
        const auto lap = timeFrames(film, 1, {}, 1000, diary.clock(), stop.get_token());
        QVERIFY(bool(lap));
        QCOMPARE(int(lap->frames), 1);  // the first warmed up, the third came with the stop
    }

    void cellsTakeTurnsAndOneFrameIsTheLeast() {
        Diary diary{.seconds = 0.0005};
        SlowDevice device(diary);
        Plan plan{.sizes = {{120, 67}, {60, 34}}, .seconds = 0.02, .rounds = 4};
        Measured result;
        std::vector<std::string> order;
        double left = 0;
        const OnMeasurement watch = [&](const Cell& cell, int round, double secondsLeft) {
            order.push_back(std::to_string(round) + " " + text(cell.size) + " " + kWays[cell.way].title());
            left = order.size() == 1 ? 0 : secondsLeft;
            if (left < 0)
                order.clear();
        };
        QVERIFY(bool(measured(device, diary, plan, result, {}, watch)));
        QVERIFY(result.complete);
        QVERIFY(order.size() >= 10);
        QCOMPARE(order[0], std::string("1 60x34 K0 n=1"));
        QCOMPARE(order[4], std::string("1 60x34 pd n=100"));
        QCOMPARE(order[5], std::string("1 120x67 K0 n=1"));
        for (const Cell& cell : result.cells) {
            QVERIFY(cell.frames() >= 1);
            const double frame = kWays[cell.way].iterations * diary.seconds;
            QVERIFY(cell.spread().low >= frame * (1 - 1e-9));  // sums round
            QVERIFY(cell.spread().low <= cell.spread().median && cell.spread().median <= cell.spread().high);
            if (frame > plan.seconds)
                QCOMPARE(int(cell.runs.size()), 1);  // its time is spent
        }
    }

    void refusalNamesTheCellAndKeepsTheOthers() {
        Diary diary{.seconds = 0.0001};
        SlowDevice device(diary, true);
        Measured result;
        const auto ran = measured(device, diary, {.sizes = {{60, 34}}, .seconds = 0.01, .rounds = 1}, result);
        QVERIFY(!ran);
        QCOMPARE(ran.error().text(), std::string("60x34 K0 n=1: there is no room"));
        QVERIFY(!result.complete);
        QCOMPARE(int(result.cells.size()), int(kWayCount));
    }

    void stopBeforeTheBeginningMeasuresNothing() {
        Diary diary;
        SlowDevice device(diary);
        std::stop_source stop;
        stop.request_stop();
        Measured result;
        QVERIFY(bool(measured(device, diary, {.sizes = {{60, 34}}}, result, stop.get_token())));
        QVERIFY(!result.complete);
        QCOMPARE(diary.taken, 0);
    }
};

QTEST_GUILESS_MAIN(FrameClockTest)
#include "frame_clock_test.moc"
