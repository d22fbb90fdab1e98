#include <QTest>
#include <cmath>
#include <random>
#include <vector>

#include "render/base/significance.h"
#include "render/timing/frame_time_fit.h"
#include "tests/render/paper_tables.h"

using namespace pdr;

namespace {

constexpr double kScatter = 0.03;  ///< relative
constexpr FrameTimeModel kTruth{0.3e-3, 47e-9, 4e-9, 1e-3};

/// Six sizes x three n, one sample a launch, each off by a normal error of `scatter`.
std::vector<TimedFrame> measured(const FrameTimeModel& truth, double scatter, std::mt19937_64& random,
                                 std::uint32_t perLaunch = 1) {
    std::normal_distribution<double> error(0, scatter);
    std::vector<TimedFrame> frames;
    for (const double pixels : test::kPaperPixels)
        for (const std::uint32_t n : {1u, 10u, 100u}) {
            const FrameWork work{pixels, n, perLaunch};
            frames.push_back({work, frameSeconds(truth, work) * (1 + (scatter > 0 ? error(random) : 0))});
        }
    return frames;
}

bool near(double value, double expected, double relative) {
    return std::fabs(value - expected) <= relative * std::fabs(expected);
}

/// Returns whether `hits` of `rounds` may be 95 %. With random seeds, all such questions together would give a false
/// alarm once in 1e4 runs.
bool ninetyFivePercent(int hits, int rounds) {
    const double z = (hits - 0.95 * rounds) / std::sqrt(rounds * 0.95 * 0.05);
    qInfo("%d of %d hold the truth, z = %.2f", hits, rounds, z);
    return std::fabs(z) <= allowedZ(6);
}

}  // namespace

class FrameTimeFitTest : public QObject {
    Q_OBJECT

  private slots:
    void timesWithoutErrorGiveTheModelBack() {
        std::mt19937_64 random(1);
        const auto fit = FrameTimeFit::of(measured(kTruth, 0, random));
        QVERIFY(bool(fit));
        QVERIFY(fit->launchIsKnown());
        QVERIFY(near(fit->model().launch, kTruth.launch, 1e-8));
        QVERIFY(near(fit->model().sample, kTruth.sample, 1e-8));
        QVERIFY(near(fit->model().pixel, kTruth.pixel, 1e-6));
        QVERIFY(near(fit->model().communication, kTruth.communication, 1e-8));
        QVERIFY(fit->scatter() < 1e-9);
    }

    void intervalsHoldTheTruthNineteenTimesInTwenty() {
        constexpr int kRounds = 2000;
        std::mt19937_64 random(7);
        std::normal_distribution<double> error(0, kScatter);
        const FrameWork other{800 * 600, 20, 1};
        int launch = 0, sample = 0, pixel = 0, communication = 0, floor = 0, forecast = 0;
        for (int round = 0; round < kRounds; ++round) {
            const auto fit = FrameTimeFit::of(measured(kTruth, kScatter, random));
            QVERIFY(bool(fit));
            launch += fit->launch().holds(kTruth.launch);
            sample += fit->sample().holds(kTruth.sample);
            pixel += fit->pixel().holds(kTruth.pixel);
            communication += fit->communication().holds(kTruth.communication);
            floor += fit->floor().holds(kTruth.launch + kTruth.communication);
            forecast += fit->predict(other).interval.holds(frameSeconds(kTruth, other) * (1 + error(random)));
        }
        QVERIFY(ninetyFivePercent(launch, kRounds));
        QVERIFY(ninetyFivePercent(sample, kRounds));
        QVERIFY(ninetyFivePercent(pixel, kRounds));
        QVERIFY(ninetyFivePercent(communication, kRounds));
        QVERIFY(ninetyFivePercent(floor, kRounds));
        QVERIFY(ninetyFivePercent(forecast, kRounds));
    }

    /// Where the truth is 0, half of the free fits lie below it: none may be shown, and the intervals still hold it.
    void nothingIsNegative() {
        constexpr int kRounds = 500;
        const FrameTimeModel truth{0.3e-3, 47e-9, 0, 1e-3};
        std::mt19937_64 random(3);
        int held = 0;
        for (int round = 0; round < kRounds; ++round) {
            const auto fit = FrameTimeFit::of(measured(truth, kScatter, random));
            QVERIFY(bool(fit));
            QVERIFY(fit->model().pixel >= 0 && fit->pixel().low >= 0);
            QVERIFY(fit->pixel().low <= fit->model().pixel && fit->model().pixel <= fit->pixel().high);
            held += fit->pixel().holds(0);
        }
        QVERIFY(held >= 0.95 * kRounds);
    }

    /// The times call for a T_c far below 0: it is 0 then, but that is not certain.
    void unknownAtItsBoundIsNotCertain() {
        std::mt19937_64 random(9);
        const auto fit = FrameTimeFit::of(measured({3e-3, 47e-9, 4e-9, -2.5e-3}, 0.01, random));
        QVERIFY(bool(fit));
        QCOMPARE(fit->model().communication, 0.0);
        QVERIFY(fit->communication().high > 1e-5);
        QVERIFY(fit->launch().low < fit->model().launch && fit->model().launch < fit->launch().high);
    }

    /// All samples are in one launch: T0 and T_c occur once a frame each and cannot be told apart.
    void floorIsPartOfCommunicationWhereEveryFrameIsOneLaunch() {
        std::mt19937_64 random(5);
        const auto fit = FrameTimeFit::of(measured(kTruth, 0, random, 100));
        QVERIFY(bool(fit));
        QVERIFY(!fit->launchIsKnown());
        QCOMPARE(fit->model().launch, 0.0);
        QVERIFY(near(fit->model().communication, kTruth.launch + kTruth.communication, 1e-8));
    }

    /// The paper's own times of the GTX 560 Ti have a floor, which is found and is not chance.
    void papersTimesHaveAFloor() {
        std::vector<TimedFrame> frames;
        for (int size = 0; size < test::kPaperSizes; ++size)
            for (const auto& [n, row] : {std::pair(1u, test::kGtx560Ti.pd1), std::pair(10u, test::kGtx560Ti.pd10),
                                         std::pair(100u, test::kGtx560Ti.pd100)})
                frames.push_back({{test::kPaperPixels[size], n, 1}, 1 / test::Printed::of(row[size]).value});
        const auto fit = FrameTimeFit::of(frames);
        QVERIFY(bool(fit));
        qInfo("T0 %.3f ms [%.3f, %.3f], alpha %.1f ns, beta %.1f ns, Tc %.2f ms, scatter %.1f %%",
              1e3 * fit->model().launch, 1e3 * fit->launch().low, 1e3 * fit->launch().high, 1e9 * fit->model().sample,
              1e9 * fit->model().pixel, 1e3 * fit->model().communication, 100 * fit->scatter());
        QVERIFY(fit->launch().holds(0.328e-3));
        QVERIFY(fit->launch().low > 0.2e-3);
        QVERIFY(fit->sample().holds(46.7e-9));
    }

    void tooFewMeasurementsAreRefused() {
        std::mt19937_64 random(1);
        std::vector<TimedFrame> frames = measured(kTruth, kScatter, random);
        frames.resize(12);  // four sizes
        QVERIFY(!FrameTimeFit::of(frames));
        frames = measured(kTruth, kScatter, random);
        std::erase_if(frames, [](const TimedFrame& frame) { return frame.work.iterations == 10; });
        QVERIFY(!FrameTimeFit::of(frames));
        frames = measured(kTruth, kScatter, random);
        frames[3].seconds = 0;
        QVERIFY(!FrameTimeFit::of(frames));
        QVERIFY(!FrameTimeFit::of({}));
    }

    /// Printed tables: t of 5 % is 12.706, 4.303, 2.571, 2.145, 1.980 with 1, 2, 5, 14, 120 degrees of freedom.
    void studentsTIsThatOfTheTables() {
        for (const auto& [freedom, t] : {std::pair(1, 12.706), {2, 4.303}, {5, 2.571}, {14, 2.145}, {120, 1.980}}) {
            QVERIFY(std::fabs(studentT(0.05, freedom) - t) < 0.0006);
            QVERIFY(std::fabs(studentP(-t, freedom) - 0.05) < 1e-4);
        }
        QVERIFY(std::fabs(studentT(0.01, 3) - 5.841) < 0.0006);
    }
};

QTEST_GUILESS_MAIN(FrameTimeFitTest)
#include "frame_time_fit_test.moc"
