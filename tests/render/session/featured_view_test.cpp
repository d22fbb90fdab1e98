/// A film of few samples is denoised on features of its scene, one of many samples by itself.

#include <QTest>
#include <algorithm>
#include <atomic>
#include <cmath>

#include "render/session/featured_view.h"
#include "render/session/resolution_ladder.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/reel.h"
#include "tests/support/patience.h"
#include "tests/support/scenes/featured_images.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/tissue_scene.h"

using namespace pdr;
using test::Reel;

namespace {

constexpr Display kDisplay{1, true};

Scene sceneOf(std::uint64_t revision) {
    Scene scene = test::tissueScene();
    scene.film = {80, 64};
    scene.revision = revision;
    scene.camera.eyeMm.x += 5 * double(revision);
    return scene;
}

std::stop_token stopped() {
    std::stop_source source;
    source.request_stop();
    return source.get_token();
}

/// A film of four samples on the CPU.
struct Rendered {
    FilmOnDevice place{makeCpuDevice()};
    FeaturedView features;

    Rendered() {
        (void)place.begin(sceneOf(1));
        (void)place.film()->accumulate(4, {});
    }
    std::vector<std::uint8_t> image(bool adds, const std::stop_token& stop = {}) {
        return features.image(place, kDisplay, adds, stop)->image.rgba;
    }
    std::vector<std::uint8_t> expected() {
        return test::featuredImageOf(**place.film()->film(), sceneOf(1), kDisplay).rgba;
    }
};

/// Returns the rms difference of the frame, stretched to `size`, from an image of that size [levels].
double levelsBetween(const Frame& frame, const Image& image, ivec2 size) {
    double squares = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const ivec2 at = ivec2(x, y) * frame.size / size;
            for (int c = 0; c < 3; ++c) {
                const int shown = frame.rgba[std::size_t(4 * (frame.size.x * at.y + at.x) + c)];
                const int apart = shown - image.rgba[std::size_t(4 * (size.x * y + x) + c)];
                squares += apart * apart;
            }
        }
    return std::sqrt(squares / (3.0 * size.x * size.y));
}

/// A clock by which every device is fast.
SessionClock unhurried() {
    return [now = std::make_shared<std::atomic<double>>(0)] { return *now += 1e-4; };
}

}  // namespace

class FeaturedViewTest : public QObject {
    Q_OBJECT

  private slots:
    void featuresHelpAFilmOfFewSamples() {
        Rendered shown;
        QVERIFY(!shown.features.helps(4));  // not yet found
        shown.features.find(shown.place, 4, {});
        QVERIFY(shown.features.helps(4));
        QVERIFY(shown.features.helps(FeaturedView::kEnoughAlone - 1));
        QVERIFY(!shown.features.helps(FeaturedView::kEnoughAlone));
        shown.features.startOver();
        QVERIFY(!shown.features.helps(4));
    }

    void aDeviceIsAskedOnceUnlessItIsInterrupted() {
        auto mishaps = std::make_shared<test::Mishaps>();
        int guides = 0;
        mishaps->before = [&](const std::string& call) { guides += call == "guide"; };
        FilmOnDevice place(test::failing(mishaps));  // it has none
        (void)place.begin(sceneOf(1));
        FeaturedView features;
        features.find(place, FeaturedView::kEnoughAlone, {});
        QCOMPARE(guides, 0);  // too late to help
        features.find(place, 1, stopped());
        features.find(place, 1, {});
        features.find(place, 1, {});
        QCOMPARE(guides, 2);
        QVERIFY(!features.helps(1));
    }

    void theImageIsMadeOnThemOnceForAllDisplays() {
        Rendered shown;
        shown.features.find(shown.place, 4, {});
        const std::vector<std::uint8_t> four = shown.expected();
        QVERIFY(shown.image(true) == four);
        (void)shown.place.film()->accumulate(4, {});
        QVERIFY(shown.image(false) == four);  // another display: the samples since then are not looked at
        QVERIFY(shown.image(true) == shown.expected());
        (void)shown.place.film()->accumulate(4, {});
        (void)shown.image(true, stopped());
        QVERIFY(shown.image(false) == shown.expected());  // nothing is left of an interrupted one
    }

    void theHalvesAreMadeOnThemToo() {
        Rendered shown;
        shown.features.find(shown.place, 4, {});
        const NoisyFilm noisy = noisyFilm(**shown.place.film()->film());
        const auto firstOf = [&](const HalfSmoother& smoother) { return smoother(noisy, {}).even[0].row(30)[40]; };
        QVERIFY(firstOf(shown.features.smoother(4)) != firstOf(denoisedHalves));
        QCOMPARE(firstOf(shown.features.smoother(FeaturedView::kEnoughAlone)), firstOf(denoisedHalves));
    }

    /// In a session: the full film of each view from its first sample on, until it is good enough alone.
    void aNewViewIsShownOnFeatures() {
        Reel reel;
        Session session(makeCpuDevice(), reel.sink(), {}, unhurried());
        session.setDisplay(kDisplay);
        session.setIterationsPerFrame(8);
        session.submit(sceneOf(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1), test::kPatience);
        session.submit(sceneOf(2), false);
        QTRY_VERIFY_WITH_TIMEOUT(
            !reel.of(2).empty() && reel.of(2).back()->status.samplesPerPixel >= FeaturedView::kEnoughAlone,
            test::kPatience);
        session.setPaused(true);
        int few = 0, many = 0;
        for (const auto& frame : reel.of(2)) {
            const std::uint64_t samples = frame->status.samplesPerPixel;
            if (frame->coarse || !frame->denoised)
                continue;
            const Film film = test::render(sceneOf(2), samples);
            const bool isFew = samples < FeaturedView::kEnoughAlone;
            const Image image = isFew ? test::featuredImageOf(film, sceneOf(2), kDisplay) : imageOf(film, kDisplay);
            QVERIFY2(frame->rgba == image.rgba, qPrintable(QString("%1 samples").arg(samples)));
            ++(isFew ? few : many);
        }
        QVERIFY(few > 0);
        qInfo("%d images on features, %d without", few, many);
    }

    /// So it replaces that, which has four samples in each of its fewer pixels. The next one has as many, and does not
    /// wait for its judgement either.
    void oneSampleOnFeaturesIsBetterThanTheCoarseImage() {
        Scene scene = test::largeScene(1);
        Reel reel;
        Session session(makeCpuDevice(), reel.sink());
        session.setDisplay(kDisplay);
        session.setIterationsPerFrame(3);
        session.submit(scene, false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1) && reel.of(1).back()->denoisedError, test::kPatience);
        session.setPaused(true);
        const auto frames = reel.of(1);
        const auto full = std::ranges::find(frames, false, [](const auto& frame) { return frame->coarse; });
        QVERIFY(full != frames.begin() && (*full)->denoised);
        QCOMPARE((*full)->status.samplesPerPixel, std::uint64_t(1));
        for (int i : {1, 2})  // and once more with its error
            QCOMPARE(full[i]->status.samplesPerPixel, std::uint64_t(ResolutionLadder::kSamples));
        QVERIFY(!full[1]->denoisedError && full[2]->denoisedError);
        scene.seed += 1000;
        const Image truth = imageOf(test::render(scene, 64), kDisplay);
        const double one = levelsBetween(**full, truth, scene.film),
                     coarse = levelsBetween(*full[-1], truth, scene.film);
        QVERIFY2(one < coarse, qPrintable(QString("%1 %2").arg(one).arg(coarse)));
    }

    void theStatedErrorIsThatOfTheImageOnFeatures() {
        Scene scene = sceneOf(1);
        scene.film = {128, 112};
        Reel reel;
        Session session(makeCpuDevice(), reel.sink(), {}, unhurried());
        session.setDisplay(kDisplay);
        session.setIterationsPerFrame(8);
        session.setStop({.samples = 8});
        session.submit(scene, false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1) && reel.of(1).back()->denoisedError, test::kPatience);
        const auto frames = reel.of(1);
        const auto full = std::ranges::find(frames, false, [](const auto& frame) { return frame->coarse; });
        QVERIFY((*full)->denoised && !(*full)->denoisedError);  // it did not wait for that
        const auto& last = frames.back();
        QVERIFY(last->denoised);
        QVERIFY(last->status.samplesPerPixel < FeaturedView::kEnoughAlone);
        const Film film = test::render(scene, last->status.samplesPerPixel);
        const auto features = std::make_shared<const denoise::Features>(test::featuresOf(scene));
        const auto said = SmoothingJudgement::of(film, smootherOn(features))->overAll(double(kDisplay.exposure));
        const auto alone = SmoothingJudgement::of(film)->overAll(double(kDisplay.exposure));
        QVERIFY(said && alone && said->levels != alone->levels);
        QCOMPARE(last->denoisedError->levels, said->levels);
    }

    void aRawImageAsksForNone() {
        auto mishaps = std::make_shared<test::Mishaps>();
        std::atomic<int> guides = 0;
        mishaps->before = [&](const std::string& call) { guides += call == "guide"; };
        Reel reel;
        Session session(test::failing(mishaps), reel.sink(), {}, unhurried());
        session.setDisplay({1, false});
        session.submit(sceneOf(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1), test::kPatience);
        QCOMPARE(guides.load(), 0);
    }
};

QTEST_GUILESS_MAIN(FeaturedViewTest)
#include "featured_view_test.moc"
