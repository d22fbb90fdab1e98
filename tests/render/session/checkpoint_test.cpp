/// A copy of the film is taken now and then, in a small fraction of the time, and survives a device that is lost.

#include <QTest>

#include "render/session/checkpoint.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/reel.h"

using namespace pdr;

namespace {

/// A film on a device that can be lost, with a clock of its own.
struct Rendered {
    std::shared_ptr<test::FakeClock> clock = std::make_shared<test::FakeClock>();
    std::shared_ptr<test::Mishaps> mishaps = std::make_shared<test::Mishaps>();
    std::unique_ptr<Device> device = test::failing(mishaps);
    std::unique_ptr<Accumulator> film;
    Checkpoint checkpoint{test::readingOf(clock)};

    Rendered() {
        Scene scene = test::largeScene(1);
        scene.film = {16, 16};
        film = *startFilm(*device, scene);
        checkpoint.reset(nullptr);
        (void)film->accumulate(3, {});
    }
    void wait(double seconds) { clock->advanceTo(clock->seconds() + seconds); }
};

}  // namespace

class CheckpointTest : public QObject {
    Q_OBJECT

  private slots:
    void aCopyIsDueTwoSecondsAfterTheFilmBegan() {
        Rendered rendered;
        rendered.wait(1.9);
        QVERIFY(!rendered.checkpoint.isDue());
        rendered.wait(0.2);
        QVERIFY(rendered.checkpoint.isDue() && !rendered.checkpoint.film());
        QVERIFY(rendered.checkpoint.take(*rendered.film));
        QVERIFY(!rendered.checkpoint.isDue());
        QCOMPARE(rendered.checkpoint.film()->samplesPerPixel(), std::uint64_t(3));
    }

    void aSlowCopyIsTakenInAHundredthOfTheTime() {
        Rendered rendered;
        rendered.mishaps->before = [&](const std::string& call) {
            if (call == "read")
                rendered.wait(0.5);
        };
        QVERIFY(rendered.checkpoint.take(*rendered.film));
        rendered.wait(49.9);
        QVERIFY(!rendered.checkpoint.isDue());
        rendered.wait(0.2);
        QVERIFY(rendered.checkpoint.isDue());
    }

    void theLastCopySurvivesTheDevice() {
        Rendered rendered;
        QVERIFY(rendered.checkpoint.take(*rendered.film));
        rendered.mishaps->gone = true;
        QVERIFY(!rendered.checkpoint.take(*rendered.film));
        QVERIFY(rendered.checkpoint.film());
        rendered.checkpoint.reset(nullptr);
        QVERIFY(!rendered.checkpoint.film());
    }
};

QTEST_GUILESS_MAIN(CheckpointTest)
#include "checkpoint_test.moc"
