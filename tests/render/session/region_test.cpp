/// A part of the image gets its samples first, says how good it is, and costs the rest nothing in the end.

#include <QTest>
#include <cmath>
#include <future>

#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/reel.h"
#include "tests/support/devices/screen.h"
#include "tests/support/patience.h"

using namespace pdr;

namespace {

constexpr Region kMiddle{{0.4, 0.35}, {0.6, 0.65}};

Scene smallScene(std::uint64_t revision = 1) {
    Scene scene = test::largeScene(revision);
    scene.film = {96, 64};
    return scene;
}

struct Watched {
    test::Screen screen;
    Session session;

    explicit Watched(double target) : session(makeCpuDevice(2), screen.sink()) {
        session.setIterationsPerFrame(4);
        session.setStop({.levels = target});
    }
    std::shared_ptr<const Frame> reached() {
        return screen.await([](const Frame& frame) { return frame.reached; });
    }
    /// Returns a copy of the current film.
    FilmContent film() {
        std::promise<FilmContent> seen;
        session.requestSnapshot(1, [&](const Result<FilmView>& view) { seen.set_value(view->film.content()); });
        return seen.get_future().get();
    }
    FilmStatus truth() {
        std::promise<FilmStatus> seen;
        session.requestSnapshot(1, [&](const Result<FilmView>& view) {
            seen.set_value(view->film.status(1, tileOf(kMiddle, view->film.size())));
        });
        return seen.get_future().get();
    }
};

}  // namespace

class RegionTest : public QObject {
    Q_OBJECT

  private slots:
    void itsPixelsAreAllThatItTouches() {
        QVERIFY((tileOf({}, {96, 64}) == Tile{0, 0, 96, 64}));
        QVERIFY((tileOf({{0.25, 0.5}, {0.75, 1}}, {96, 64}) == Tile{24, 32, 48, 32}));
        QVERIFY((tileOf({{0.26, 0.51}, {0.74, 0.99}}, {96, 64}) == Tile{24, 32, 48, 32}));
        QVERIFY((tileOf({{0.999, 0.999}, {1, 1}}, {10, 10}) == Tile{9, 9, 1, 1}));
        QVERIFY((tileOf({{1, 1}, {1, 1}}, {10, 10}) == Tile{9, 9, 1, 1}));
    }

    void withoutOneNothingIsSaidOfIt() {
        Watched watched(16);
        watched.session.submit(smallScene(), false);
        const auto frame = watched.reached();
        QVERIFY(frame && !frame->region);
    }

    void itGetsAllSamplesUntilItIsAsGoodAsWantedThenTheRestDoes() {
        test::Reel reel;
        Session session(makeCpuDevice(2), reel.sink());
        session.setIterationsPerFrame(4);
        session.setStop({.levels = 8});
        session.setRegion(kMiddle);
        session.submit(smallScene(), false);
        QTRY_VERIFY_WITH_TIMEOUT(!reel.of(1).empty() && reel.of(1).back()->reached, 1'800'000);
        std::uint64_t rest = 0;
        bool ahead = false;
        for (const auto& frame : reel.of(1)) {
            if (frame->coarse || !frame->region)
                continue;
            const FilmStatus& status = frame->status;
            if (rest == 0)
                rest = status.samplesPerPixel;
            if (!frame->region->reached)
                QCOMPARE(status.samplesPerPixel, rest);
            ahead = ahead || status.mostSamplesPerPixel > status.samplesPerPixel;
        }
        QVERIFY(rest > 0 && ahead);
        const auto last = reel.of(1).back();
        QVERIFY(last->region && last->region->reached && last->region->status.displayError <= 8);
        QVERIFY(last->status.displayError <= 8 && last->status.samplesPerPixel > rest);
    }

    void whatIsSaidOfItIsTrueOfItsPixels() {
        Watched watched(8);
        watched.session.setRegion(kMiddle);
        watched.session.submit(smallScene(), false);
        const auto frame = watched.screen.await([](const Frame& f) { return f.region && f.region->reached; });
        watched.session.setPaused(true);
        QVERIFY(frame && frame->region->region == kMiddle);
        const FilmStatus said = frame->region->status, now = watched.truth();
        QVERIFY(said.tissuePixels > 100 && said.tissuePixels <= now.tissuePixels);
        QVERIFY(said.samplesPerPixel <= now.samplesPerPixel);
        // A stated error stays good enough: errors only fall, apart from their randomness.
        QVERIFY(now.displayError < said.displayError + 4 * said.displayErrorSpread);
        QVERIFY(!frame->region->steps.empty() && !frame->region->history.empty());
    }

    /// Each pixel's samples are those of an image without a region.
    void itsBitsAreThoseOfAnyOtherOrder() {
        Watched watched(1e-3);  // this target is never reached
        watched.session.setRegion(kMiddle);
        watched.session.submit(smallScene(), false);
        QVERIFY(watched.screen.await([](const Frame& f) { return f.status.mostSamplesPerPixel >= 80; }));
        watched.session.setRegion(Region{{0.5, 0.5}, {1, 1}});
        QVERIFY(watched.screen.await([](const Frame& f) { return f.status.mostSamplesPerPixel >= 100; }));
        const FilmContent film = watched.film();
        const auto device = makeCpuDevice(2);
        QVERIFY(device->upload(smallScene()));
        const auto again = device->film(wholeImage(smallScene().film), 1, {});
        QVERIFY(again);
        const std::vector<EvenTile> parts = film.progress.evenTiles(film.progress.area());
        QVERIFY(parts.size() > 2);
        for (const EvenTile& part : parts)
            QVERIFY((*again)->accumulate(part.tile, std::uint32_t(part.next), {}));
        const auto other = (*again)->film();
        QVERIFY(other && sameBits(film, (*other)->content()));
    }

    void anImageThatIsHeldGoesOnInItWhereItIsWorse() {
        Watched watched(16);
        watched.session.submit(smallScene(), false);
        const auto whole = watched.reached();
        QVERIFY(whole);
        // Some part is worse than 95 % of the whole, such as the silhouette.
        for (int i = 0; i < 16; ++i) {
            const dvec2 from = 0.25 * dvec2(i % 4, i / 4);
            const Region part{from, from + 0.25};
            watched.session.setRegion(part);
            const auto frame =
                watched.screen.await([&](const Frame& f) { return f.region && f.region->region == part && f.reached; });
            QVERIFY(frame && frame->region->reached);
            // A part that has seen no light for long counts as dark, and delays nothing.
            const FilmStatus& status = frame->region->status;
            const bool isDark = status.unlitTissue && std::isinf(status.displayError) && status.samplesPerPixel >= 256;
            QVERIFY(status.tissuePixels == 0 || isDark || status.displayError <= 16);
        }
        watched.session.setRegion(std::nullopt);
        QVERIFY(watched.screen.await([](const Frame& f) { return !f.region && f.reached; }));
    }

    void anEmptyPartKeepsNobodyWaiting() {
        Watched watched(16);
        Scene scene = smallScene();
        scene.camera.fovDegrees *= 3;  // air all around
        watched.session.setRegion(Region{{0, 0}, {0.15, 0.15}});
        watched.session.submit(scene, false);
        const auto frame = watched.reached();
        QVERIFY(frame && frame->region && frame->region->reached);
        QCOMPARE(frame->region->status.tissuePixels, 0U);
    }

    /// An empty region is finished as soon as it is known that there is nothing to see.
    void whatIsEmptyIsAsGoodAsItGets() {
        Scene scene = smallScene();
        scene.transferFunction.extinctionPerMm = 0;
        const Film air = test::render(scene, int(kSamplesToEstimate));
        RegionView view;
        view.choose(kMiddle);
        QVERIFY(!(view.error() <= 1e30));
        view.look(air, 1, 0);
        QCOMPARE(view.error(), 0.0);
    }

    /// Times of errors are those of an image without a region: the rest need not repeat what the region has had.
    void whatItGotIsNoTimeLost() {
        constexpr double kIteration = 1;
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->clock = std::make_shared<test::FakeClock>();
        mishaps->iterationSeconds = kIteration;
        test::Reel reel;
        Session session(test::failing(mishaps), reel.sink(), {}, test::readingOf(mishaps->clock));
        session.setStop({.levels = 1e-3});
        Scene scene = smallScene();
        scene.film = {64, 32};
        session.submit(scene, false);
        const auto most = [&] { return reel.of(1).empty() ? 0 : reel.of(1).back()->status.mostSamplesPerPixel; };
        QTRY_VERIFY_WITH_TIMEOUT(most() >= 40, test::kPatience);
        session.setRegion(Region{{0, 0}, {0.5, 1}});
        QTRY_VERIFY_WITH_TIMEOUT(reel.of(1).back()->status.meanSamplesPerPixel >= 100, test::kPatience);
        session.setRegion(std::nullopt);
        const std::uint64_t far = most();
        QTRY_VERIFY_WITH_TIMEOUT(reel.of(1).back()->status.samplesPerPixel >= far, test::kPatience);
        session.setPaused(true);
        int ahead = 0;
        for (const auto& frame : reel.of(1)) {
            if (frame->coarse || frame->history.empty())
                continue;
            const double samples = double(frame->status.samplesPerPixel);
            const double mean = frame->status.meanSamplesPerPixel;
            ahead += mean > samples;
            QVERIFY(std::abs(frame->history.back().seconds - kIteration * samples) < 0.05 * samples);
            QVERIFY(std::abs(frame->seconds - kIteration * mean) < 0.05 * mean);
            for (const QualityStep& step : frame->steps)
                QVERIFY(step.reached || step.seconds.value >= frame->seconds);
        }
        QVERIFY(ahead > 3);
    }

    void itStaysWhenTheSceneChanges() {
        Watched watched(16);
        watched.session.setRegion(kMiddle);
        for (const std::uint64_t revision : {1, 2}) {
            watched.session.submit(smallScene(revision), false);
            const auto frame = watched.screen.await(
                [&](const Frame& f) { return f.revision == revision && f.region && f.region->reached; });
            QVERIFY(frame && frame->region->region == kMiddle);
        }
    }
};

QTEST_GUILESS_MAIN(RegionTest)
#include "region_test.moc"
