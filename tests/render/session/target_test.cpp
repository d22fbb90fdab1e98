/// Rendering stops by itself when more of it would not be seen, says so, and continues on request.

#include <QTest>
#include <cmath>
#include <ctime>

#include "tests/support/devices/reel.h"
#include "tests/support/devices/screen.h"
#include "tests/support/scenes/featured_images.h"

using namespace pdr;

namespace {

Scene smallScene(std::uint64_t revision) {
    Scene scene = test::largeScene(revision);
    scene.film = {24, 16};
    return scene;
}

struct Held {
    test::Screen screen;
    Session session{makeCpuDevice(2), screen.sink()};

    Held() { session.setIterationsPerFrame(50); }
    std::shared_ptr<const Frame> reached(std::uint64_t revision) {
        session.submit(smallScene(revision), false);
        return screen.await([&](const Frame& frame) { return frame.revision == revision && frame.reached; });
    }
};

}  // namespace

class TargetTest : public QObject {
    Q_OBJECT

  private slots:
    void renderingHoldsAtTheLastStep() {
        Held held;
        const auto frame = held.reached(1);
        QVERIFY(frame && frame->status.displayError <= kFinestStep);
        QVERIFY(frame->status.samplesPerPixel >= kSamplesToStop);
        const int shown = held.screen.count();
        const std::clock_t start = std::clock();
        QTest::qWait(300);
        QVERIFY(double(std::clock() - start) / CLOCKS_PER_SEC < 0.1);
        QCOMPARE(held.screen.count(), shown);
    }

    void beforeThatItGoesOn() {
        Held held;
        held.session.setIterationsPerFrame(1);
        held.session.submit(smallScene(1), false);
        const auto early = held.screen.await([](const Frame& frame) { return !frame.coarse; });
        QVERIFY(early && !early->reached);
        QVERIFY(!(early->status.displayError <= kFinestStep));
        held.session.setIterationsPerFrame(50);
        QVERIFY(held.screen.await([](const Frame& frame) { return frame.reached; }));
    }

    /// Too few samples never meet a target, however small the error seems: as on the command line.
    void aFewSamplesAreNeverEnough() {
        Held held;
        held.session.setIterationsPerFrame(4);
        held.session.setStop({.levels = 64});
        const auto frame = held.reached(1);
        QVERIFY(frame && frame->status.samplesPerPixel >= kSamplesToStop);
        QVERIFY(frame->status.samplesPerPixel < kSamplesToStop + 8);
    }

    /// The denoised image counts if that is shown, and the film once it is shown as it is.
    void theImageOnTheScreenIsHeldByItsOwnError() {
        Held held;
        held.session.setIterationsPerFrame(8);
        held.session.setDisplay({.denoised = true});
        Scene scene = smallScene(1);
        scene.film = {96, 80};
        held.session.setStop({.levels = 64});
        held.session.submit(scene, false);
        const auto first = held.screen.await([](const Frame& f) { return f.reached && f.denoisedError; });
        QVERIFY(first && first->denoised && first->denoisedError->levelsAtMost < 0.8 * first->status.displayError);
        const double between = std::sqrt(first->denoisedError->levelsAtMost * first->status.displayError);
        held.session.setStop({.levels = between});
        const auto denoised = held.screen.await([&](const Frame& f) { return f.stop.levels == between; });
        QVERIFY(denoised && denoised->reached);
        QCOMPARE(denoised->status.samplesPerPixel, first->status.samplesPerPixel);
        held.session.setDisplay({});
        const auto raw = held.screen.await([](const Frame& f) { return !f.denoised && f.reached; });
        QVERIFY(raw && raw->status.displayError <= between);
        QVERIFY(raw->status.samplesPerPixel > first->status.samplesPerPixel);
    }

    void moreIsRenderedOnRequestUntilThereIsAnotherScene() {
        Held held;
        const auto frame = held.reached(1);
        QVERIFY(frame);
        held.session.goOn();
        const auto more = held.screen.await(
            [&](const Frame& f) { return f.status.samplesPerPixel > 2 * frame->status.samplesPerPixel; });
        QVERIFY(more && !more->reached);
        held.session.submit(smallScene(2), false);
        const auto next = held.screen.await([&](const Frame& f) {
            return f.revision == 2 && (f.reached || f.status.samplesPerPixel > 4 * frame->status.samplesPerPixel);
        });
        QVERIFY(next && next->reached);
    }

    /// This includes an image that is already better than the target, which says so at once.
    void renderingHoldsAtTheTargetAndGoesOnToAFinerOne() {
        Held held;
        held.session.setIterationsPerFrame(8);
        held.session.setStop({.levels = 8});
        const auto frame = held.reached(1);
        QVERIFY(frame && frame->stop.levels == 8 && frame->status.displayError <= 8 && frame->status.displayError > 2);
        held.session.setStop({.levels = 2});
        const auto finer = held.screen.await([](const Frame& f) { return f.reached && f.stop.levels == 2; });
        QVERIFY(finer && finer->status.displayError <= 2);
        held.session.setStop({.levels = 16});
        const auto still = held.screen.await([](const Frame& f) { return f.stop.levels == 16; });
        QVERIFY(still && still->reached);
        QCOMPARE(still->status.samplesPerPixel, finer->status.samplesPerPixel);
    }

    void aNewTargetCountsEvenWhereRenderingWentOnBeyondTheOld() {
        Held held;
        held.session.setIterationsPerFrame(8);
        held.session.setStop({.levels = 8});
        QVERIFY(held.reached(1));
        held.session.goOn();
        QVERIFY(held.screen.await([](const Frame& f) { return f.status.displayError <= 6 && !f.reached; }));
        held.session.setStop({.levels = 2});
        QVERIFY(held.screen.await([](const Frame& f) { return f.reached && f.stop.levels == 2; }));
    }

    void framesSayWhenStepsWereAndWillBeReached() {
        Held held;
        held.session.setIterationsPerFrame(8);
        held.session.setStop({.levels = 8});
        const auto frame = held.reached(1);
        QVERIFY(frame && frame->steps.size() == kQualitySteps.size());
        QVERIFY(reachedStep(frame->steps)->levels <= 8);
        for (const QualityStep& step : frame->steps)
            QVERIFY(step.reached ? step.seconds.value <= frame->seconds : step.seconds.value > frame->seconds);
    }

    void aDisplayThatShowsMoreOfTheNoiseGoesOn() {
        Held held;
        const auto frame = held.reached(1);
        QVERIFY(frame);
        held.session.setDisplay({.exposure = 0.2f});
        QVERIFY(held.screen.await([&](const Frame& f) {
            return f.display.exposure == 0.2f && f.status.samplesPerPixel > frame->status.samplesPerPixel;
        }));
    }

    void whicheverLimitComesFirstHolds() {
        Held held;
        held.session.setIterationsPerFrame(4);
        held.session.setStop({.levels = 1e-3, .samples = 40});
        const auto frame = held.reached(1);
        QVERIFY(frame && frame->status.samplesPerPixel >= 40 && frame->status.displayError > 1e-3);
        held.session.setStop({.levels = 1e-3, .seconds = frame->seconds + 0.05});
        const auto later = held.screen.await([](const Frame& f) { return f.reached && f.stop.samples == 0; });
        QVERIFY(later && later->seconds >= later->stop.seconds);
        QVERIFY(later->status.samplesPerPixel > frame->status.samplesPerPixel);
    }

    /// During rendering the denoised image is judged at each doubling at most; in the end the statement refers to all
    /// samples.
    void aHeldImageIsJudgedAsItIs() {
        Held held;
        held.session.setIterationsPerFrame(1);
        held.session.setDisplay({.denoised = true});
        Scene scene = smallScene(1);
        scene.film = {96, 64};
        const auto features = std::make_shared<const denoise::Features>(test::featuresOf(scene));
        held.session.setStop({.levels = 1e-3, .samples = 8});
        held.session.submit(scene, false);
        for (const std::uint64_t samples : {8, 11}) {
            held.session.setStop({.levels = 1e-3, .samples = samples});
            QVERIFY(held.screen.await([&](const Frame& f) { return f.reached && f.stop.samples == samples; }));
            const auto truth = SmoothingJudgement::of(test::render(scene, samples), smootherOn(features))->overAll(1);
            QVERIFY(truth && truth->levelsAtMost > 0 && held.screen.await([&](const Frame& f) {
                return f.reached && f.denoisedError && f.denoisedError->levelsAtMost == truth->levelsAtMost;
            }));
        }
    }

    void aPauseStaysAPause() {
        Held held;
        QVERIFY(held.reached(1));
        held.session.setPaused(true);
        held.session.goOn();
        const int shown = held.screen.count();
        QTest::qWait(200);
        QCOMPARE(held.screen.count(), shown);
    }
};

QTEST_GUILESS_MAIN(TargetTest)
#include "target_test.moc"
