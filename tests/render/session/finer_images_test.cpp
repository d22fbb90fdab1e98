/// From the first image of an edit to the full one: an image is never worse than the one before, whatever the user
/// does, and the film at rest is that of the scene alone.

#include <QTest>
#include <algorithm>
#include <atomic>
#include <future>
#include <random>
#include <thread>

#include "render/session/resolution_ladder.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/reel.h"
#include "tests/support/patience.h"
#include "tests/support/processor_time.h"
#include "tests/support/scenes/images.h"

using namespace pdr;
using namespace std::chrono_literals;
using test::largeScene;
using test::Reel;

namespace {

/// Returns a clock that advances with each reading, by which every device is so slow that it needs bands.
SessionClock hurrying() {
    return [now = std::make_shared<std::atomic<double>>(0)] { return *now += 0.03; };
}

/// The CPU makes the first full image on features of the scene: one sample is then better than the coarse image
/// (featured_view_test).
bool isWorse(const Frame& after, const Frame& before) {
    const bool onFeatures = before.coarse && !after.coarse && after.denoised && after.device == "cpu";
    return after.size.x < before.size.x || after.size.y < before.size.y ||
           (!onFeatures && after.status.samplesPerPixel < before.status.samplesPerPixel);
}

/// Returns whether no image of one scene has fewer pixels than the one before, or fewer samples in each of them.
bool growsNoWorse(const std::vector<std::shared_ptr<const Frame>>& frames) {
    return std::adjacent_find(frames.begin(), frames.end(), [](const auto& before, const auto& after) {
               return isWorse(*after, *before);
           }) == frames.end();
}

Result<Film> filmOf(Session& session, std::uint64_t revision) {
    std::promise<Result<Film>> film;
    session.requestSnapshot(revision, [&](const Result<FilmView>& view) {
        film.set_value(view ? Result<Film>(view->film) : Result<Film>(view.error()));
    });
    return film.get_future().get();
}

}  // namespace

class FinerImagesTest : public QObject {
    Q_OBJECT

  private slots:
    void noImageIsWorseThanTheOneBefore_data() { devices(); }
    void noImageIsWorseThanTheOneBefore() {
        QFETCH(QString, device);
        Reel reel;
        Session session(made(device), reel.sink());
        session.setDisplay({.denoised = true});
        for (std::uint64_t revision = 1; revision <= 4; ++revision) {
            session.submit(largeScene(revision), false);
            QTRY_VERIFY_WITH_TIMEOUT(reel.full(revision, 2), test::kPatience);
        }
        for (std::uint64_t revision = 1; revision <= 4; ++revision) {
            QVERIFY(reel.of(revision).front()->coarse);
            QVERIFY(growsNoWorse(reel.of(revision)));
            QVERIFY(reel.of(revision).front()->denoised);
        }
    }

    /// The brightness changes while the film is not yet as good as the image.
    void anotherDisplayIsNeverWorseEither_data() { devices(); }
    void anotherDisplayIsNeverWorseEither() {
        QFETCH(QString, device);
        Reel reel;
        Session session(made(device), reel.sink());
        session.submit(largeScene(1), false);
        std::mt19937 random(1);
        for (float exposure = 1; !reel.full(1, 3); exposure *= 1.01f) {
            session.setDisplay({.exposure = exposure});
            std::this_thread::sleep_for(std::chrono::milliseconds(random() % 20));
        }
        QVERIFY(growsNoWorse(reel.of(1)));
    }

    /// The brightness changes in each launch, on a device on which an image takes several launches: so it also changes
    /// while a coarser image waits for the finer one.
    void everyDisplayOfADenoisedImageIsDenoised() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->clock = std::make_shared<test::FakeClock>();
        mishaps->iterationSeconds = 0.03;
        std::atomic<Session*> changed = nullptr;
        mishaps->before = [&, exposure = 1.0f](const std::string& verb) mutable {
            if (verb == "accumulate" && changed != nullptr)
                changed.load()->setDisplay({.exposure = exposure += 0.1f, .denoised = true});
        };
        Reel reel;
        Session session(test::failing(mishaps), reel.sink(), {}, test::readingOf(mishaps->clock));
        session.setDisplay({.denoised = true});
        changed = &session;
        session.submit(largeScene(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1), test::kPatience);
        QVERIFY(growsNoWorse(reel.of(1)));
        for (const auto& frame : reel.of(1))
            QVERIFY(frame->denoised);
    }

    /// Each sample would have to be denoised anew. Half of the displays may come too late for the film to wait.
    void aDenoisedFilmWaitsForAHandThatChangesItsBrightness() {
        Reel reel;
        Session session(makeCpuDevice(2), reel.sink());
        session.setDisplay({.denoised = true});
        session.submit(largeScene(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1), test::kPatience);
        int waited = 0;
        for (int i = 1; i <= 20; ++i) {
            const auto before = reel.frames().back();
            const Display display{.exposure = 1 + 0.1f * float(i), .denoised = true};
            session.setDisplay(display);
            while (reel.frames().back()->display.exposure != display.exposure)
                std::this_thread::sleep_for(1ms);
            const FilmStatus& status = reel.frames().back()->status;
            waited += status.meanSamplesPerPixel == before->status.meanSamplesPerPixel;
        }
        QVERIFY(waited >= 10);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1, 30), test::kPatience);  // and then goes on
    }

    /// The display changes after denoising of more samples has begun: the previously denoised image is shown on the new
    /// display first.
    void denoisingIsBrokenOffForAnotherDisplay() {
        const Display dark{.exposure = 4, .denoised = true};
        Reel reel;
        Session session(changingIn("resolve", dark, session, reel), reel.sink());
        session.setDisplay({.denoised = true});
        session.submit(largeScene(1), false);
        const auto [before, after] = around(reel, dark);
        QVERIFY(!before->coarse && before->status.samplesPerPixel < after->status.samplesPerPixel);
        Development development;
        (void)development.image(test::render(largeScene(1), before->status.samplesPerPixel), before->display);
        QVERIFY(after->rgba ==
                development.image(test::render(largeScene(1), after->status.samplesPerPixel), dark).rgba);
        const Result<Film> film = filmOf(session, 1);  // nor is a sample lost
        QVERIFY(film && test::sameBits(*film, test::render(largeScene(1), film->samplesPerPixel())));
        QTRY_VERIFY_WITH_TIMEOUT(reel.frames().back()->status.samplesPerPixel > after->status.samplesPerPixel,
                                 test::kPatience);
    }

    /// Until the first full image exists, the coarser one is shown on another display. A first run tells which image it
    /// is.
    void theFirstFullImageGivesWayToAnotherDisplay() {
        const Display dark{.exposure = 4, .denoised = true};
        int full = 0;
        for (const bool changes : {false, true}) {
            auto mishaps = std::make_shared<test::Mishaps>();
            mishaps->clock = std::make_shared<test::FakeClock>();
            mishaps->iterationSeconds = 0.03;
            Reel reel;
            std::atomic<Session*> changed = nullptr;
            mishaps->before = [&, images = 0](const std::string& verb) mutable {
                if (verb != "resolve" || reel.full(1))
                    return;
                ++images;
                if (!changes)
                    full = images;
                else if (images == full)
                    changed.load()->setDisplay(dark);
            };
            Session session(test::failing(mishaps), reel.sink(), {}, test::readingOf(mishaps->clock));
            changed = &session;
            session.setDisplay({.denoised = true});
            session.submit(largeScene(1), false);
            QTRY_VERIFY_WITH_TIMEOUT(reel.full(1), test::kPatience);
            const bool gaveWay = std::ranges::any_of(
                reel.frames(), [&](const auto& frame) { return frame->coarse && frame->display == dark; });
            QCOMPARE(gaveWay, changes);
            QVERIFY(growsNoWorse(reel.of(1)));
        }
    }

    void aDisplayThatChangesInALaunchIsShownOnce() {
        const Display dark{.exposure = 4, .denoised = true};
        Reel reel;
        Session session(changingIn("accumulate", dark, session, reel), reel.sink());
        session.setDisplay({.denoised = true});
        session.submit(largeScene(1), false);
        const auto after = around(reel, dark).second;
        QTRY_VERIFY_WITH_TIMEOUT(reel.frames().back()->status.samplesPerPixel > after->status.samplesPerPixel,
                                 test::kPatience);
        // In a launch of another film, one for the next edit, there is already an image of as many on the old display
        const auto isAgain = [&](const auto& frame) {
            return frame->display == dark && frame->status.samplesPerPixel == after->status.samplesPerPixel;
        };
        QCOMPARE(std::ranges::count_if(reel.frames(), isAgain), 1);
    }

    void aChangedDisplayIsShownAtOnce_data() { devices(); }
    void aChangedDisplayIsShownAtOnce() {
        QFETCH(QString, device);
        Reel reel;
        Session session(made(device), reel.sink());
        session.setIterationsPerFrame(10000);  // the next frame is far away
        session.submit(largeScene(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(!reel.of(1).empty(), test::kPatience);
        for (int i = 1; i <= 20; ++i) {
            const Display display{.exposure = 1 + 0.1f * float(i)};
            session.setDisplay(display);
            QTRY_VERIFY_WITH_TIMEOUT(reel.frames().back()->display == display, test::kPatience);
        }
        QVERIFY(reel.frames().back()->status.samplesPerPixel < 10000);
        QVERIFY(growsNoWorse(reel.of(1)));
    }

    void whatIsShownBetweenTheBandsOfAnIterationIsTheFilm() {
        Reel reel;
        Session session(makeCpuDevice(2), reel.sink(), {}, hurrying());
        session.submit(largeScene(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1), test::kPatience);
        const auto uneven = [&] {
            const FilmStatus& status = reel.frames().back()->status;
            return status.mostSamplesPerPixel == status.samplesPerPixel + 1;
        };
        const auto many = [&] { return reel.frames().back()->status.samplesPerPixel > 200; };
        bool seen = false;
        const test::ProcessorTime spent;
        for (float exposure = 1; !seen && !many() && spent.seconds() < 20; exposure *= 1.001f) {
            session.setDisplay({.exposure = exposure});
            std::this_thread::sleep_for(1ms);
            seen = uneven();
        }
        QVERIFY(seen);
        const Result<Film> film = filmOf(session, 1);
        QVERIFY(film);
        QCOMPARE(film->samples().most, film->samplesPerPixel());
        QVERIFY(test::sameBits(*film, test::render(largeScene(1), film->samplesPerPixel())));
    }

    /// The device is changed between two bands.
    void anotherDeviceGoesOnWithinAnIteration() {
        Reel reel;
        Session session(makeCpuDevice(2), reel.sink(), {}, hurrying());
        session.submit(largeScene(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1), test::kPatience);
        for (int i = 0; i < 12; ++i) {
            session.setDevice([i]() -> Result<std::unique_ptr<Device>> {
                if (i % 2)
                    return makeCpuDevice(1);
                return test::failing(std::make_shared<test::Mishaps>());
            });
            std::this_thread::sleep_for(std::chrono::milliseconds(7 * i));
        }
        const Result<Film> film = filmOf(session, 1);
        QVERIFY(film);
        QVERIFY(test::sameBits(*film, test::render(largeScene(1), film->samplesPerPixel())));
    }

    /// The clock makes films as coarse as they may be.
    void aMovingImageIsFinerThanItsFilm() {
        const auto first = [](bool denoised) {
            Reel reel;
            Session session(makeCpuDevice(2), reel.sink(), {}, hurrying());
            session.setDisplay({.denoised = denoised});
            for (const std::uint64_t revision : {1, 2}) {
                session.submit(largeScene(revision), true);
                while (reel.of(revision).empty())
                    std::this_thread::sleep_for(1ms);
            }
            return reel.of(2).front();
        };
        const std::shared_ptr<const Frame> raw = first(false), smooth = first(true);
        QVERIFY(raw->coarse && smooth->coarse && smooth->denoised);
        QCOMPARE(smooth->size.x, ResolutionLadder::kGuide * raw->size.x);
        QCOMPARE(smooth->size.y, ResolutionLadder::kGuide * raw->size.y);
        QCOMPARE(smooth->rgba.size(), std::size_t(4 * smooth->size.x * smooth->size.y));
    }

    /// The device is not asked again for each brightness of the same film.
    void aDeviceThatHasNoGuideIsAskedOnce() {
        std::atomic<int> asked = 0;
        std::promise<void> paused;
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->before = [&asked, held = paused.get_future().share()](const std::string& verb) {
            if (verb == "guide" && asked++ == 0)
                held.wait();
        };
        Reel reel;
        Session session(test::failing(mishaps), reel.sink(), {}, hurrying());
        session.setDisplay({.denoised = true});
        session.submit(largeScene(1), true);
        QTRY_VERIFY_WITH_TIMEOUT(asked > 0, test::kPatience);
        session.setPaused(true);
        paused.set_value();
        for (int i = 1; i <= 3; ++i) {
            const Display display{.exposure = 1 + 0.1f * float(i), .denoised = true};
            session.setDisplay(display);
            QTRY_VERIFY_WITH_TIMEOUT(!reel.of(1).empty() && reel.of(1).back()->display == display, test::kPatience);
        }
        QVERIFY(reel.of(1).back()->coarse);
        QCOMPARE(asked.load(), 1);
    }

    void aHandThatHoldsStillSeesTheFullImage() {
        Reel reel;
        Session session(makeCpuDevice(2), reel.sink());
        session.submit(largeScene(1), true);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1), test::kPatience / 10);  // short: a planted fault waits this long
        QVERIFY(reel.of(1).front()->coarse && growsNoWorse(reel.of(1)));
    }

    void aHandThatRestsKeepsWhatIsThere() {
        Reel reel;
        Session session(makeCpuDevice(2), reel.sink());
        session.submit(largeScene(1), true);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1, 5), test::kPatience);
        session.submit(largeScene(1), false);
        const Result<Film> film = filmOf(session, 1);
        QVERIFY(film && test::sameBits(*film, test::render(largeScene(1), film->samplesPerPixel())));
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1, 10), test::kPatience);
        QVERIFY(growsNoWorse(reel.of(1)));
    }

    /// A scene that costs a hundred times as much as the one before shows its first image with the samples that exist
    /// in time.
    void aFirstImageThatWouldBeLateHasFewerSamples() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->clock = std::make_shared<test::FakeClock>();
        Reel reel;
        Session session(test::failing(mishaps), reel.sink(), {}, test::readingOf(mishaps->clock));
        session.submit(largeScene(1), false);
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(1), test::kPatience);
        mishaps->iterationSeconds = 0.06;
        session.submit(largeScene(2), true);
        QTRY_VERIFY_WITH_TIMEOUT(!reel.of(2).empty(), test::kPatience);
        QVERIFY(reel.of(2).front()->coarse);
        QCOMPARE(reel.of(2).front()->status.samplesPerPixel, std::uint64_t(1));
    }

  private:
    using Frames = std::vector<std::shared_ptr<const Frame>>;

    /// Returns a device that changes the display of `session` once: in the first call of that name after an image of
    /// more samples than those that are shown twice, before their error is known and with it.
    static std::unique_ptr<Device> changingIn(const std::string& name, const Display& display, Session& session,
                                              Reel& reel) {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->before = [=, &session, &reel, left = 1](const std::string& verb) mutable {
            if (verb != name || !reel.full(1) || left == 0)
                return;
            if (reel.frames().back()->status.samplesPerPixel > ResolutionLadder::kSamples) {
                session.setDisplay(display);
                --left;
            }
        };
        return test::failing(mishaps);
    }
    /// Waits for the first image on that display; returns it and the one before.
    static std::pair<Frames::value_type, Frames::value_type> around(Reel& reel, const Display& display) {
        const auto isOn = [&](const auto& frame) { return frame->display == display; };
        Frames frames;
        while (std::ranges::none_of(frames = reel.frames(), isOn))
            std::this_thread::sleep_for(1ms);
        const auto after = std::ranges::find_if(frames, isOn);
        return {*(after - 1), *after};
    }
    static void devices() {
        QTest::addColumn<QString>("device");
        QTest::newRow("cpu") << "cpu";
        QTest::newRow("gpu") << "gpu";
        QTest::newRow("gpu with work behind") << "behind";
    }
    static std::unique_ptr<Device> made(const QString& device) {
        if (device == "cpu")
            return makeCpuDevice(2);
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->iterationSeconds = 0.02;
        mishaps->maxInFlight = device == "behind" ? 2 : 1;
        return test::failing(mishaps);
    }
};

QTEST_GUILESS_MAIN(FinerImagesTest)
#include "finer_images_test.moc"
