/// The errors of images are determined anew when they would have changed, and stated of the right image.

#include <QTest>
#include <cmath>
#include <limits>

#include "render/session/quality_tracker.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/reel.h"

using namespace pdr;

namespace {

/// An image whose errors were counted at so many samples per pixel.
Image counted(std::uint64_t samples, double error) {
    Image image;
    image.status.samplesPerPixel = samples;
    image.status.meanSamplesPerPixel = double(samples);
    image.status.displayError = error;
    return image;
}

/// A tracker with a clock that advances only when a film is read.
struct Tracked {
    std::shared_ptr<test::FakeClock> clock = std::make_shared<test::FakeClock>();
    QualityTracker tracker{test::readingOf(clock)};
    double readSeconds = 0;

    explicit Tracked(bool isCoarse = false) { tracker.startOver(isCoarse); }

    void record(Image image, float exposure = 1) { tracker.record(image, exposure, 0); }
    /// Returns a film of `samples` on a device whose film takes readSeconds to read.
    Accumulator& film(std::uint32_t samples) {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->before = [this](const std::string& call) {
            if (call == "read")
                clock->advanceTo(clock->seconds() + readSeconds);
        };
        Scene scene = test::largeScene(1);
        scene.film = {16, 16};
        film_.reset();
        device_ = test::failing(mishaps);
        film_ = *startFilm(*device_, scene);
        (void)film_->accumulate(samples, {});
        return *film_;
    }

  private:
    std::unique_ptr<Device> device_;
    std::unique_ptr<Accumulator> film_;  ///< declared after device_, which must outlive it
};

}  // namespace

class QualityTrackerTest : public QObject {
    Q_OBJECT

  private slots:
    void errorsAreCountedAtEachDoublingAndLaterAtEachTwelfth() {
        Tracked tracked;
        QVERIFY(tracked.tracker.isSurveyDue(1, 1));
        tracked.record(counted(4, 50));
        QVERIFY(!tracked.tracker.isSurveyDue(7.9, 1) && tracked.tracker.isSurveyDue(8, 1));
        tracked.record(counted(20, 50));
        QVERIFY(!tracked.tracker.isSurveyDue(31, 1) && tracked.tracker.isSurveyDue(32, 1));
        tracked.record(counted(100, 5));
        QVERIFY(!tracked.tracker.isSurveyDue(108, 1) && tracked.tracker.isSurveyDue(110, 1));
        QVERIFY(tracked.tracker.isSurveyDue(100, 2));  // on another display
    }

    void anImageBetweenTwoCountsHasItsOwnSamplesAndTheLastError() {
        Tracked tracked;
        tracked.record(counted(100, 5));
        Image between = counted(104, 0);
        between.surveyed = false;
        tracked.tracker.record(between, 1, 0);
        QCOMPARE(between.status.samplesPerPixel, std::uint64_t(104));
        QCOMPARE(between.status.displayError, 5.0);
    }

    void aCoarseFilmHasNoErrors() {
        Tracked tracked(true);
        tracked.record(counted(100, 5));
        QVERIFY(!tracked.tracker.progress(100).displayError);
        QVERIFY(tracked.tracker.isSurveyDue(100, 1));
        Frame frame;
        tracked.tracker.describe(frame, 0);
        QVERIFY(frame.history.empty() && frame.steps.empty());
    }

    void anImageIsAsGoodAsTheWorseOfItAndItsRegion() {
        Tracked tracked;
        tracked.record(counted(100, 5));
        QCOMPARE(tracked.tracker.progress(100).displayError, std::optional(5.0));
        tracked.tracker.chooseRegion(Region{{0.25, 0.25}, {0.75, 0.75}});
        QCOMPARE(tracked.tracker.progress(100).displayError, std::optional(std::numeric_limits<double>::infinity()));
        QVERIFY(tracked.tracker.lookAtRegion(tracked.film(64), 64, {}));
        const double inRegion = tracked.tracker.region().error();
        QVERIFY(std::isfinite(inRegion));
        QCOMPARE(tracked.tracker.progress(100).displayError, std::optional(std::max(5.0, inRegion)));
    }

    void anotherFilmForgetsErrorsButKeepsTheRegion() {
        Tracked tracked;
        tracked.tracker.chooseRegion(Region{});
        tracked.tracker.addSeconds(3);
        tracked.record(counted(100, 5));
        tracked.tracker.clear();
        QVERIFY(!tracked.tracker.progress(100).displayError);
        QCOMPARE(tracked.tracker.seconds(), 3.0);  // the same film on another device
        tracked.tracker.startOver(false);
        QCOMPARE(tracked.tracker.seconds(), 0.0);
        QVERIFY(tracked.tracker.region().region());
    }

    void aCheapJudgementComesSoonerAndTheLastOneWhenRenderingStops() {
        Tracked tracked;
        QVERIFY(!tracked.tracker.isJudgementDue(kSamplesToJudge - 1, true));
        QVERIFY(tracked.tracker.isJudgementDue(kSamplesToJudge, true));
        tracked.readSeconds = 2;
        QVERIFY(tracked.tracker.judge(tracked.film(64), 64, {}));
        QCOMPARE(tracked.tracker.seconds(), 2.0);
        QVERIFY(!tracked.tracker.isJudgementDue(127, true) && tracked.tracker.isJudgementDue(128, true));
        QVERIFY(tracked.tracker.isJudgementDue(65, false) && !tracked.tracker.isJudgementDue(64, false));
        tracked.tracker.addSeconds(50);  // a twenty-fifth of this went into the judgement
        QVERIFY(!tracked.tracker.isJudgementDue(69, true) && tracked.tracker.isJudgementDue(70, true));
    }

    void anErrorMapIsMadeAnewWhenItWouldDiffer() {
        Tracked tracked;
        tracked.record(counted(64, 5));
        const auto map = [&](std::uint32_t samples, float exposure) {
            if (!tracked.tracker.mapErrors(tracked.film(samples), samples, exposure, {}))
                return std::shared_ptr<const LevelErrorMap>();
            Frame frame;
            tracked.tracker.describe(frame, 0);
            return frame.errorMap;
        };
        const auto first = map(64, 1);
        QVERIFY(first);
        QCOMPARE(map(79, 1), first);
        const auto second = map(80, 1);
        QVERIFY(second != first);
        QVERIFY(map(80, 2) != second);
        tracked.tracker.dropErrorMap();
        Frame frame;
        tracked.tracker.describe(frame, 0);
        QVERIFY(!frame.errorMap);
    }

    void aSlowErrorMapIsMadeAtEachDoubling() {
        Tracked tracked;
        tracked.readSeconds = 1;
        tracked.record(counted(64, 5));
        QVERIFY(tracked.tracker.mapErrors(tracked.film(64), 64, 1, {}));
        QVERIFY(tracked.tracker.mapErrors(tracked.film(127), 127, 1, {}));
        QCOMPARE(tracked.tracker.seconds(), 1.0);
        QVERIFY(tracked.tracker.mapErrors(tracked.film(128), 128, 1, {}));
        QCOMPARE(tracked.tracker.seconds(), 2.0);
    }

    void timeSpentOnAPartIsAddedToTheStepsToCome() {
        Tracked tracked;
        for (std::uint64_t samples = 64; samples <= 512; samples *= 2) {
            tracked.tracker.addSeconds(double(samples));
            tracked.record(counted(samples, 64 / std::sqrt(double(samples))));
        }
        Frame now, ahead;
        now.status = ahead.status = counted(512, 64 / std::sqrt(512.0)).status;
        tracked.tracker.describe(now, 0);
        tracked.tracker.describe(ahead, 10);
        QVERIFY(!now.steps.empty() && !now.steps.back().reached);
        QCOMPARE(ahead.steps.size(), now.steps.size());
        for (std::size_t i = 0; i < now.steps.size(); ++i)
            QCOMPARE(ahead.steps[i].seconds.value, now.steps[i].seconds.value + (now.steps[i].reached ? 0 : 10));
    }
};

QTEST_GUILESS_MAIN(QualityTrackerTest)
#include "quality_tracker_test.moc"
