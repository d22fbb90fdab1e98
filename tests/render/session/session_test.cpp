#include <QTest>
#include <chrono>
#include <future>
#include <thread>

#include "render/session/featured_view.h"
#include "render/session/render_commands.h"
#include "render/session/resolution_ladder.h"
#include "tests/support/devices/reel.h"
#include "tests/support/devices/screen.h"
#include "tests/support/patience.h"
#include "tests/support/processor_time.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;
using namespace std::chrono_literals;

namespace {

Scene someScene(std::uint64_t revision) {
    Scene scene = test::plainScene(test::bumpyVolume({40, 40, 40}, dvec3(1), 3), 1);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 600, .opacity = 1}};
    scene.film = {96, 64};
    scene.revision = revision;
    return scene;
}

}  // namespace

class SessionTest : public QObject {
    Q_OBJECT

  private slots:
    void framesCarryTheRevisionAndGrowByN() {
        test::Screen screen;
        Session session(makeCpuDevice(), screen.sink());
        session.setIterationsPerFrame(5);
        session.submit(someScene(7), false);
        const auto frame = screen.await([](const Frame& f) { return f.status.samplesPerPixel >= 50; });
        QVERIFY(frame);
        QCOMPARE(frame->revision, std::uint64_t(7));
        QCOMPARE(frame->status.samplesPerPixel % 5, std::uint64_t(0));
        QCOMPARE(frame->size.x, 96);
        QCOMPARE(frame->rgba.size(), std::size_t(96 * 64 * 4));
    }

    void newestSceneWinsAtOnce() {
        test::Screen screen;
        Session session(makeCpuDevice(), screen.sink());
        session.setIterationsPerFrame(10000);  // a launch of many seconds
        Scene slow = someScene(1);
        slow.film = {1024, 1024};
        session.submit(slow, false);
        std::this_thread::sleep_for(200ms);
        session.setIterationsPerFrame(1);
        const test::ProcessorTime spent;
        session.submit(someScene(2), false);
        QVERIFY(screen.await([](const Frame& f) { return f.revision == 2; }));
        QVERIFY(spent.seconds() < 2);
    }

    /// Work that takes longer than an image may, and is no part of it, is interrupted for another display; samples are
    /// not.
    void anotherDisplayEndsWhatIsNoPartOfTheImage() {
        RenderCommands commands;
        commands.submit(someScene(1), false);
        const auto step = commands.next({}, {});
        QVERIFY(step && step->order);
        commands.setDisplay(commands.display());
        QVERIFY(!step->detour.stop_requested());
        commands.setDisplay({.exposure = 2});
        QVERIFY(step->detour.stop_requested() && !step->stop.stop_requested());
        const auto next = commands.next({.scene = true, .film = true, .revision = 1}, {});
        QVERIFY(next && next->redisplay && !next->detour.stop_requested());
        commands.submit(someScene(2), false);
        QVERIFY(next->detour.stop_requested() && next->stop.stop_requested());
    }

    /// A mouse that reports faster than images are made would else leave none. A hand that lets go waits for nothing.
    void theImageOfADragIsMadeBeforeTheNextSceneOfTheDrag() {
        RenderCommands commands;
        commands.submit(someScene(1), true);
        const auto first = commands.next({}, {});
        QVERIFY(first && first->order);
        commands.submit(someScene(2), true);
        commands.submit(someScene(3), true);
        QVERIFY(!first->stop.stop_requested() && !first->detour.stop_requested());
        RenderCommands::LoopState state{.scene = true, .film = true, .revision = 1, .owed = true, .passing = true};
        const auto second = commands.next(state, {});
        QVERIFY(second && !second->order && second->render);
        state.owed = state.passing = false;  // its image is there
        const auto third = commands.next(state, {});
        QVERIFY(third && third->order);
        QCOMPARE(third->order->scene.revision, std::uint64_t(3));
        commands.submit(someScene(4), false);
        QVERIFY(third->stop.stop_requested());
    }

    /// The finer images while a hand rests are broken off when it moves on.
    void aHandThatMovesOnWaitsForNoFinerImage() {
        RenderCommands commands;
        commands.submit(someScene(1), true);
        QVERIFY(commands.next({}, {}));
        const auto finer = commands.next({.scene = true, .film = true, .revision = 1, .owed = true}, {});
        QVERIFY(finer && !finer->order);
        commands.submit(someScene(2), true);
        QVERIFY(finer->stop.stop_requested());
    }

    void aSnapshotOfASceneThatWaitsIsAnswered() {
        RenderCommands commands;
        commands.submit(someScene(1), true);
        QVERIFY(commands.next({}, {}));
        commands.submit(someScene(2), true);
        commands.requestSnapshot(2, [](const Result<FilmView>&) {});
        const RenderCommands::LoopState state{
            .scene = true, .film = true, .revision = 1, .owed = true, .passing = true};
        QVERIFY(commands.next(state, {})->unanswerable.empty());
        commands.submit(someScene(3), true);  // now it never comes
        QCOMPARE(commands.next(state, {})->unanswerable.size(), std::size_t(1));
    }

    void newestSceneWinsAtOnceInExposureRendersOrderToo() {
        test::Screen screen;
        Session session(makeCpuDevice(), screen.sink());
        session.setIterationsPerFrame(10000);
        Scene slow = someScene(1);
        slow.film = {1024, 1024};
        slow.schedule.kind = Schedule::Kind::kroes;
        session.submit(slow, false);
        std::this_thread::sleep_for(200ms);
        session.setIterationsPerFrame(1);
        const test::ProcessorTime spent;
        Scene next = someScene(2);
        next.schedule = slow.schedule;
        session.submit(next, false);
        const auto frame = screen.await([](const Frame& f) { return f.revision == 2; });
        QVERIFY(frame && frame->schedule.kind == Schedule::Kind::kroes);
        QVERIFY(spent.seconds() < 2);
    }

    void anotherScheduleBeginsAnew() {
        test::Screen screen;
        Session session(makeCpuDevice(), screen.sink());
        session.submit(someScene(1), false);
        QVERIFY(screen.await([](const Frame& f) { return f.status.samplesPerPixel >= 50; }));
        session.setPaused(true);
        Scene compared = someScene(2);
        compared.schedule = {.kind = Schedule::Kind::kroes, .filter = false, .runningMean = false};
        session.submit(compared, false);
        const auto shown = screen.await([&](const Frame& f) { return f.schedule == compared.schedule && !f.coarse; });
        QVERIFY(shown);  // once, even while paused
        // one, or on a slow machine, where a coarse image came first, as many as that has
        const std::uint64_t samples = shown->status.samplesPerPixel;
        QVERIFY2(samples == 1 || samples == ResolutionLadder::kSamples, std::to_string(samples).c_str());
        QCOMPARE(shown->revision, std::uint64_t(2));
        session.setPaused(false);
        session.submit(someScene(3), false);
        QVERIFY(screen.await([](const Frame& f) { return f.schedule == Schedule{}; }));
    }

    void aDeviceCanBeChosenBeforeThereIsAScene() {
        test::Screen screen;
        Session session(makeCpuDevice(), screen.sink());
        session.setDevice([] { return makeCpuDevice(1); });
        std::this_thread::sleep_for(50ms);
        QCOMPARE(screen.count(), 0);
        Scene scene = someScene(1);
        scene.schedule.kind = Schedule::Kind::kroes;
        session.submit(scene, false);
        const auto frame = screen.await([](const Frame&) { return true; });
        QVERIFY(frame && frame->schedule.kind == Schedule::Kind::kroes && frame->device == "cpu");
    }

    void pausedSessionShowsNewScenesOnceAndHolds() {
        test::Screen screen;
        Session session(makeCpuDevice(), screen.sink());
        session.setPaused(true);
        session.submit(someScene(1), false);
        QVERIFY(screen.await([](const Frame& f) { return f.status.samplesPerPixel == 1; }));
        std::this_thread::sleep_for(200ms);
        QCOMPARE(screen.count(), 1);
        session.setPaused(false);
        QVERIFY(screen.await([](const Frame& f) { return f.status.samplesPerPixel > 3; }));
    }

    void aYieldingSessionOnlyAnswers() {
        test::Screen screen;
        Session session(makeCpuDevice(), screen.sink());
        session.submit(someScene(1), false);
        QVERIFY(screen.await([](const Frame&) { return true; }));
        session.setYielding(true);
        const auto samplesNow = [&] {
            std::promise<std::uint64_t> now;
            session.requestSnapshot(
                1, [&](const Result<FilmView>& view) { now.set_value(view ? view->film.samplesPerPixel() : 0); });
            return now.get_future().get();
        };
        samplesNow();  // it may be answered within the step that was running
        const std::uint64_t before = samplesNow();
        QVERIFY(before > 0);
        std::this_thread::sleep_for(100ms);
        QCOMPARE(samplesNow(), before);
        session.setYielding(false);
        QVERIFY(screen.await([&](const Frame& f) { return f.status.samplesPerPixel > before; }));
    }

    void displayChangesWithoutARestart() {
        test::Screen screen;
        Session session(makeCpuDevice(), screen.sink());
        session.submit(someScene(1), false);
        QVERIFY(screen.await([](const Frame& f) { return f.status.samplesPerPixel >= 20; }));
        session.setPaused(true);
        const auto samplesNow = [&] {
            std::promise<std::uint64_t> held;
            session.requestSnapshot(
                1, [&](const Result<FilmView>& view) { held.set_value(view->film.samplesPerPixel()); });
            return held.get_future().get();
        };
        const std::uint64_t samples = samplesNow();  // all work in flight has arrived by then
        const auto before = screen.await([&](const Frame& f) { return f.status.samplesPerPixel == samples; });
        QVERIFY(before);
        session.setDisplay({.exposure = 0.01f});
        const auto after = screen.await([&](const Frame& f) { return f.rgba != before->rgba; });
        QVERIFY(after);
        QCOMPARE(after->status.samplesPerPixel, samples);
        samplesNow();  // it may be reported within the step that showed this image
        QCOMPARE(samplesNow(), samples);
    }

    /// A saved image states the same as the screen, which also learns what was found out for the file: the error of the
    /// denoised image, or that the raw one is better.
    void aSnapshotAndTheScreenSayTheSame() {
        test::Reel reel;
        Session session(makeCpuDevice(2), reel.sink());
        session.setIterationsPerFrame(1);
        session.setDisplay({.denoised = true});
        Scene scene = test::largeScene(1);
        scene.transferFunction.extinctionPerMm = 0.1f;  // noise that denoising takes away
        scene.film = {200, 150};
        session.setStop({.levels = 1e-3});
        session.submit(scene, false);
        const auto says = [&](std::uint64_t samples, const auto& what) {
            return std::ranges::any_of(reel.frames(), [&](const auto& frame) {
                return frame->status.samplesPerPixel >= samples && what(*frame);
            });
        };
        const auto isJudged = [](const Frame& frame) { return frame.denoisedError.has_value(); };
        QTRY_VERIFY_WITH_TIMEOUT(says(FeaturedView::kEnoughAlone, isJudged), test::kPatience);
        struct Saved {
            std::uint64_t samples;
            std::optional<double> levels;  ///< none: the raw image is better
        };
        std::promise<Saved> promised;
        session.requestSnapshot(1, [&](const Result<FilmView>& view) {
            const std::uint64_t samples = view->film.samplesPerPixel();
            DenoisedView& denoised = *view->denoised;
            denoised.judge(view->film, samples, {});
            const bool pays = denoised.better({.denoised = true}).denoised;
            promised.set_value({samples, pays ? std::optional(denoised.error(1)->levelsAtMost) : std::nullopt});
        });
        const Saved saved = promised.get_future().get();
        const auto isSaved = [&](const Frame& frame) {
            return frame.denoised == saved.levels.has_value() &&
                   (!saved.levels || frame.denoisedError->levelsAtMost == *saved.levels);
        };
        QTRY_VERIFY_WITH_TIMEOUT(says(saved.samples, isSaved), test::kPatience);
    }

    /// Toggling denoising changes neither the film nor its status; the judgement comes with the samples.
    void aDenoisedImageIsToldWithItsErrorAndTheFilmGoesOn() {
        test::Screen screen;
        Session session(makeCpuDevice(), screen.sink());
        session.setDisplay({1, true});
        session.setIterationsPerFrame(8);  // enough to judge, not enough for the raw image to be the better one
        Scene scene = someScene(1);
        scene.film = {192, 128};
        session.submit(scene, false);
        const auto judged = screen.await([](const Frame& f) { return f.denoised && f.denoisedError; });
        QVERIFY(judged && judged->status.samplesPerPixel >= kSamplesToJudge);
        QVERIFY(judged->denoisedError->levels <= judged->denoisedError->levelsAtMost);
        QVERIFY(judged->denoisedError->relativeAtMost < judged->status.relativeError);
        session.setDisplay({1, false});
        const auto raw = screen.await([](const Frame& f) { return !f.denoised; });
        QVERIFY(!raw->denoisedError && raw->status.samplesPerPixel >= judged->status.samplesPerPixel);
        std::promise<FilmContent> held;
        session.requestSnapshot(1, [&](const Result<FilmView>& view) { held.set_value(view->film.content()); });
        const FilmContent content = held.get_future().get();
        const auto device = makeCpuDevice();
        QVERIFY(device->upload(scene));
        const auto alone =
            test::renderedPart(scene, wholeImage(scene.film), content.progress.counts().least, *device, 1);
        QVERIFY(sameBits(content, alone->content()));
    }

    void sceneThatCannotBeRenderedIsSaid() {
        test::Screen screen;
        Session session(makeCpuDevice(), screen.sink());
        Scene scene = someScene(3);
        scene.phaseG = 1;
        session.submit(scene, false);
        const auto frame = screen.await([](const Frame& f) { return !f.error.empty(); });
        QVERIFY(frame);
        QCOMPARE(frame->revision, std::uint64_t(3));
        session.submit(someScene(4), false);  // and the next one is rendered
        QVERIFY(screen.await([](const Frame& f) { return f.revision == 4 && f.error.empty(); }));
    }

    void endsSoon() {
        test::Screen screen;
        auto session = std::make_unique<Session>(makeCpuDevice(), screen.sink());
        session->setIterationsPerFrame(10000);
        Scene slow = someScene(1);
        slow.film = {1024, 1024};
        session->submit(slow, false);
        std::this_thread::sleep_for(100ms);
        const test::ProcessorTime spent;
        session.reset();
        QVERIFY(spent.seconds() < 2);
    }
};

QTEST_GUILESS_MAIN(SessionTest)
#include "session_test.moc"
