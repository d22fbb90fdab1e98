/// Images of a film come in the order of their requests, and a coarser film stands in until the first of them.

#include <QTest>

#include "render/session/display_pipeline.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/reel.h"

using namespace pdr;

namespace {

Scene smallScene(std::uint64_t revision) {
    Scene scene = test::largeScene(revision);
    scene.film = {16, 16};
    return scene;
}

/// A film of four samples on a device that makes up to three images in advance.
struct Rendered {
    std::shared_ptr<test::Mishaps> mishaps = std::make_shared<test::Mishaps>();
    FilmOnDevice place;
    DisplayPipeline pipeline;

    Rendered() : place(test::failing(prepared(mishaps))) {
        (void)place.begin(smallScene(1));
        pipeline.reset(true);
        (void)place.film()->accumulate(4, {});
    }
    /// Makes an image of that exposure and returns the exposures of those that are due.
    std::vector<float> make(float exposure, bool atOnce) { return make({.exposure = exposure}, atOnce, {}); }
    std::vector<float> make(const Display& display, bool atOnce, const std::stop_token& stop) {
        return exposures(pipeline.make(place, display, display, atOnce, stop));
    }
    static std::vector<float> exposures(const Result<DisplayPipeline::Images>& images) {
        std::vector<float> all;
        for (const DisplayedImage& each : *images)
            all.push_back(each.display.exposure);
        return all;
    }

  private:
    static std::shared_ptr<test::Mishaps> prepared(const std::shared_ptr<test::Mishaps>& mishaps) {
        mishaps->maxInFlight = 3;
        return mishaps;
    }
};

std::stop_token stopped() {
    std::stop_source source;
    source.request_stop();
    return source.get_token();
}

using Exposures = std::vector<float>;

}  // namespace

class DisplayPipelineTest : public QObject {
    Q_OBJECT

  private slots:
    void imagesStayInFlightAsLongAsTheDeviceAllows() {
        Rendered shown;
        QCOMPARE(shown.make(1, false), Exposures{});
        QCOMPARE(shown.make(2, false), Exposures{});
        QVERIFY(shown.pipeline.hasWaiting());
        QCOMPARE(shown.make(3, false), Exposures{1});
        QCOMPARE(shown.make(4, true), (Exposures{2, 3, 4}));
        QVERIFY(!shown.pipeline.hasWaiting());
    }

    void anInterruptedDenoisedImageIsNotShownButThoseBeforeItAre() {
        Rendered shown;
        QCOMPARE(shown.make(1, false), Exposures{});
        QCOMPARE(shown.make({.exposure = 2, .denoised = true}, false, stopped()), Exposures{1});
        QVERIFY(!shown.pipeline.hasWaiting());
        QCOMPARE(shown.make({.exposure = 3}, true, stopped()), Exposures{3});  // nothing takes long in this one
    }

    void anotherFilmForgetsWhatWasInFlight() {
        Rendered shown;
        QCOMPARE(shown.make(1, false), Exposures{});
        shown.pipeline.reset(true);
        (void)shown.place.begin(smallScene(2));
        (void)shown.place.film()->accumulate(1, {});
        QCOMPARE(shown.make(2, true), Exposures{2});
    }

    void aFilmAwaitsItsFirstImageOnce() {
        Rendered shown;
        DisplayPipeline& pipeline = shown.pipeline;
        QVERIFY(pipeline.awaitsFirst() && pipeline.isFresh());
        pipeline.reset(false);  // the same film on another device
        QVERIFY(pipeline.awaitsFirst());
        pipeline.markShown();
        QVERIFY(!pipeline.awaitsFirst() && !pipeline.isFresh());
        pipeline.reset(false);
        QVERIFY(!pipeline.awaitsFirst() && pipeline.isFresh());
        pipeline.reset(true);
        QVERIFY(pipeline.awaitsFirst());
    }

    void onlyAFirstImageIsMadeAgainBeforeMoreSamples() {
        Rendered shown;
        shown.pipeline.breakOff();
        QVERIFY(shown.pipeline.isBroken());
        shown.pipeline.markShown();
        shown.pipeline.breakOff();
        QVERIFY(!shown.pipeline.isBroken());
    }

    void aCoarserFilmStandsInUntilTheFirstImage() {
        Rendered shown;
        DisplayPipeline& pipeline = shown.pipeline;
        QVERIFY(!pipeline.hasCoarser() && !pipeline.coarserSamples());
        pipeline.keepCoarser(*shown.place.film()->film());
        QVERIFY(pipeline.hasCoarser());
        QCOMPARE(pipeline.coarserSamples(), std::optional<std::uint64_t>(4));
        const Display asked{.exposure = 2};
        const auto image = pipeline.coarserImage(asked, asked, {});
        QVERIFY(image && image->display == asked);
        QVERIFY(image->size == ivec2(16));
        QVERIFY(!pipeline.coarserImage(asked, asked, stopped()));
        pipeline.reset(true);
        QVERIFY(pipeline.hasCoarser());
        pipeline.markShown();
        QVERIFY(!pipeline.hasCoarser());
    }

    void aDeviceIsAskedForAGuideOnceUnlessItIsInterrupted() {
        Rendered shown;
        int guides = 0;
        shown.mishaps->before = [&](const std::string& call) { guides += call == "guide"; };
        const auto find = [&](int finer, const std::stop_token& stop) {
            QVERIFY(!shown.pipeline.findGuide(shown.place, finer, stop));  // this device has none
        };
        find(1, {});
        QCOMPARE(guides, 0);  // it would be no finer than the film
        find(2, {});
        find(2, {});
        QCOMPARE(guides, 1);
        shown.pipeline.reset(true);
        find(2, stopped());
        find(2, {});
        find(2, {});
        QCOMPARE(guides, 3);
    }
};

QTEST_GUILESS_MAIN(DisplayPipelineTest)
#include "display_pipeline_test.moc"
