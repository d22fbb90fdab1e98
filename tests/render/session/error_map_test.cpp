/// Images come with a map of their error if one is requested; otherwise nothing is computed for it.

#include <QTest>
#include <future>

#include "render/film/error/error_map_view.h"
#include "tests/support/devices/fake_clock.h"
#include "tests/support/devices/reel.h"
#include "tests/support/devices/screen.h"

using namespace pdr;

namespace {

/// A session that stops at its image of revision 1.
struct Held {
    test::Screen screen;
    Session session{makeCpuDevice(2), screen.sink()};
    std::shared_ptr<const Frame> frame;

    Held() {
        session.setIterationsPerFrame(20);
        session.setStop({.levels = 8});
        Scene scene = test::largeScene(1);
        scene.film = {48, 32};
        session.submit(scene, false);
        frame = screen.await([](const Frame& f) { return f.reached; });
    }
    std::shared_ptr<const Frame> mapped() {
        return screen.await([](const Frame& f) { return f.errorMap != nullptr; });
    }
    LevelErrorMap truth(double exposure) {
        std::promise<LevelErrorMap> made;
        session.requestSnapshot(
            1, [&](const Result<FilmView>& view) { made.set_value(levelErrorMap(view->film, exposure)); });
        return made.get_future().get();
    }
};

}  // namespace

class ErrorMapTest : public QObject {
    Q_OBJECT

  private slots:
    void thereIsNoneUntilItIsWanted() {
        Held held;
        QVERIFY(held.frame && !held.frame->errorMap);
    }

    void anImageThatIsHeldGetsItAtOnceAndLosesItAgain() {
        Held held;
        held.session.setErrorMap(true);
        const auto mapped = held.mapped();
        QVERIFY(mapped && mapped->status.samplesPerPixel == held.frame->status.samplesPerPixel);
        QVERIFY(mapped->errorMap->size == mapped->size);
        QVERIFY(mapped->errorMap->bins == held.truth(1).bins);
        held.session.setErrorMap(false);
        QVERIFY(held.screen.await([](const Frame& f) { return f.errorMap == nullptr; }));
    }

    void itIsThatOfTheDisplay() {
        Held held;
        held.session.setErrorMap(true);
        QVERIFY(held.mapped());
        held.session.setPaused(true);
        held.session.setDisplay({.exposure = 8});
        const auto dark = held.screen.await([](const Frame& f) { return f.display.exposure == 8; });
        QVERIFY(dark->errorMap->bins == held.truth(8).bins);
    }

    /// A map is made for the first image, then at each quarter more samples from 32 on, where errors are first known.
    /// No time passes, so maps take none.
    void itIsMadeAnewSeldom() {
        test::Reel reel;
        Session session(makeCpuDevice(1), reel.sink(), {}, test::readingOf(std::make_shared<test::FakeClock>()));
        session.setIterationsPerFrame(1);
        session.setErrorMap(true);
        Scene scene = test::largeScene(1);
        scene.film = {24, 16};
        session.submit(scene, false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1, 150), 1'800'000);
        std::shared_ptr<const LevelErrorMap> last;
        double madeAt = 0;
        for (const auto& frame : reel.of(1)) {
            const double samples = double(frame->status.samplesPerPixel), next = std::max(1.25 * madeAt, 32.0);
            QCOMPARE(frame->errorMap == nullptr, frame->coarse);
            if (frame->errorMap && frame->errorMap != last) {
                QVERIFY(madeAt == 0 || samples >= next);
                madeAt = samples;
            }
            QVERIFY(frame->coarse || samples < std::max(1.25 * madeAt, 32.0) + 1);
            last = frame->errorMap;
        }
    }

    void whereItTakesLongItIsMadeMoreSeldom() {
        ErrorMapView view;
        constexpr ErrorOf kFilm = ErrorOf::film;
        QVERIFY(view.isDue(kFilm, 1, 1, 1.25));
        view.keep(levelErrorMap(Film(ivec2(8, 8), 1), 1), kFilm, 40, 1);
        QVERIFY(!view.isDue(kFilm, 49, 1, 1.25) && view.isDue(kFilm, 50, 1, 1.25));
        QVERIFY(!view.isDue(kFilm, 79, 1, 2) && view.isDue(kFilm, 80, 1, 2));
        QVERIFY(view.isDue(kFilm, 41, 2, 2));              // another display
        QVERIFY(view.isDue(kFilm, 39, 1, 2));              // another part
        QVERIFY(view.isDue(ErrorOf::denoised, 41, 1, 2));  // another image
    }
};

QTEST_GUILESS_MAIN(ErrorMapTest)
#include "error_map_test.moc"
