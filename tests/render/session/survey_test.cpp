/// Errors are counted in few of a session's images, since they change slowly; samples are stated with each.

#include <QTest>

#include "render/film/display/tone_map.h"
#include "tests/support/devices/reel.h"
#include "tests/support/devices/screen.h"

using namespace pdr;

namespace {

constexpr int kFrames = 200;

Scene smallScene() {
    Scene scene = test::largeScene(1);
    scene.film = {24, 16};
    return scene;
}

}  // namespace

class SurveyTest : public QObject {
    Q_OBJECT

  private slots:
    void errorsAreCountedAnewSeldomAndSamplesAlways() {
        test::Reel reel;
        const Scene scene = smallScene();
        {
            Session session(makeCpuDevice(1), reel.sink());
            session.setIterationsPerFrame(1);
            session.submit(scene, false);
            QTRY_VERIFY_WITH_TIMEOUT(reel.full(1, kFrames), 1'800'000);
        }
        double error = -1, countedAt = 0, samples = 0;
        int counted = 0;
        for (const auto& frame : reel.of(1)) {
            if (frame->coarse)
                continue;
            QVERIFY(double(frame->status.samplesPerPixel) > samples);
            samples = double(frame->status.samplesPerPixel);
            if (frame->status.relativeError != error) {
                QVERIFY(samples >= (countedAt < 32 ? std::min(2 * countedAt, 32.0) : 1.09 * countedAt));
                const FilmStatus truth = test::render(scene, std::uint64_t(samples)).status(1);
                QCOMPARE(frame->status.relativeError, truth.relativeError);
                QCOMPARE(frame->status.displayError, truth.displayError);
                error = frame->status.relativeError;
                countedAt = samples;
                ++counted;
            }
            QVERIFY(samples < std::max(2 * countedAt, 2.0) && (countedAt < 32 || samples < 1.09 * countedAt + 1));
        }
        QVERIFY2(samples >= kFrames && counted <= 35, qPrintable(QString::number(counted)));
    }

    void onAnotherDisplayTheyAreCountedAtOnce() {
        test::Screen screen;
        Session session(makeCpuDevice(1), screen.sink());
        session.setIterationsPerFrame(1);
        session.submit(smallScene(), false);
        QVERIFY(screen.await([](const Frame& frame) { return frame.status.samplesPerPixel >= 61; }));
        session.setPaused(true);
        session.setDisplay({.exposure = 8});
        const auto dark = screen.await([](const Frame& frame) { return frame.display.exposure == 8; });
        QVERIFY(dark);
        const Film film = test::render(smallScene(), dark->status.samplesPerPixel);
        QCOMPARE(dark->status.displayError, film.status(8).displayError);
    }

    void colouredImagesHaveTheToneThatWasAskedFor() {
        Scene scene = smallScene();
        scene.background = vec3(1, 0.6f, 0.3f);
        test::Screen screen;
        Session session(makeCpuDevice(1), screen.sink());
        session.setIterationsPerFrame(1);
        const Display keepsHue{.exposure = 0.3f, .curve = ToneCurve::keepsHue};
        session.setDisplay(keepsHue);
        session.submit(scene, false);
        const auto frame = screen.await([](const Frame& shown) { return shown.status.samplesPerPixel >= 4; });
        QVERIFY(frame && frame->display == keepsHue);
        const Film film = test::render(scene, frame->status.samplesPerPixel);
        QVERIFY(frame->rgba == toneMap(film, keepsHue) && frame->rgba != toneMap(film, {.exposure = 0.3f}));
        session.setPaused(true);
        session.setDisplay({.exposure = 0.3f});  // the curve alone
        QVERIFY(screen.await([&](const Frame& shown) { return shown.display.curve == ToneCurve::perChannel; }));
    }
};

QTEST_GUILESS_MAIN(SurveyTest)
#include "survey_test.moc"
