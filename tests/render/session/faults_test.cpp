/// A device that fails, refuses or is replaced: rendering continues, and no sample counts that was not taken.

#include <QTest>
#include <chrono>
#include <future>
#include <thread>

#include "render/edit/first_samples.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/screen.h"
#include "tests/support/patience.h"
#include "tests/support/scenes/images.h"

using namespace pdr;
using namespace std::chrono_literals;

namespace {

/// Looks at the film for the next edit, after its first samples.
constexpr int kFirstImages = int(FirstSamples::kMarks.size());

const DeviceOpener kCpu = [] { return makeCpuDevice(1); };

DeviceOpener opener(const std::shared_ptr<test::Mishaps>& mishaps) {
    return [mishaps] { return test::failing(mishaps); };
}

Scene someScene(std::uint64_t revision = 1) {
    Scene scene = test::plainScene(test::bumpyVolume({20, 20, 20}, dvec3(1), 3), 1);
    scene.transferFunction.nodes = {{.hu = 0, .opacity = 0}, {.hu = 600, .opacity = 1}};
    scene.film = {12, 8};
    scene.revision = revision;
    return scene;
}

/// Starts rendering a scene, and continues however good its image is already.
void begin(Session& session) {
    session.submit(someScene(), false);
    session.goOn();
}

/// Returns the current film.
Film filmOf(Session& session) {
    auto film = std::make_shared<std::promise<Film>>();
    auto future = film->get_future();
    session.requestSnapshot(1, [film](const Result<FilmView>& view) { film->set_value(view->film); });
    if (future.wait_for(1800s) != std::future_status::ready)
        qFatal("nobody looks at the film");
    return future.get();
}

/// Returns whether `film` is, bit by bit, that of its samples taken without a break on the CPU.
bool neverInterrupted(const Film& film) {
    return film.samplesPerPixel() > 0 && test::sameBits(film, test::render(someScene(), film.samplesPerPixel()));
}

auto samples(std::uint64_t least) {
    return [least](const Frame& frame) { return frame.status.samplesPerPixel >= least; };
}
bool onCpu(const Frame& frame) {
    return frame.device == "cpu" && !frame.rgba.empty();
}

}  // namespace

class FaultsTest : public QObject {
    Q_OBJECT

  private slots:
    void aDeviceThatFailsHandsOver_data() {
        QTest::addColumn<int>("uploads");
        QTest::addColumn<int>("iterates");
        QTest::addColumn<int>("shows");
        QTest::addColumn<int>("takes");
        QTest::addColumn<int>("films");
        QTest::addColumn<int>("ahead");
        const int never = test::Mishaps::kNever;
        for (const int ahead : {1, 3}) {
            const auto row = [&](const char* what) -> QTestData& {
                return QTest::newRow(qPrintable(QString("%1, %2 ahead").arg(what).arg(ahead)));
            };
            row("upload") << 0 << never << never << never << never << ahead;
            row("first iteration") << never << 0 << never << never << never << ahead;
            row("70th iteration") << never << 70 << never << never << never << ahead;
            row("resolve") << never << never << 5 << never << never << ahead;
            row("readback") << never << never << never << 5 << never << ahead;
            row("look") << never << never << never << never << 0 << ahead;
        }
    }

    void aDeviceThatFailsHandsOver() {
        auto mishaps = std::make_shared<test::Mishaps>();
        QFETCH(int, uploads);
        QFETCH(int, iterates);
        QFETCH(int, shows);
        QFETCH(int, takes);
        QFETCH(int, films);
        QFETCH(int, ahead);
        mishaps->uploads = uploads;
        mishaps->accumulates = iterates;
        mishaps->resolves = shows;
        mishaps->readbacks = takes;
        mishaps->films = films;
        mishaps->maxInFlight = ahead;
        test::Screen screen;
        Session session(test::failing(mishaps), screen.sink(), kCpu);
        begin(session);
        const Film film = filmOf(session);
        QVERIFY(neverInterrupted(film));
        QVERIFY(screen.await(onCpu));
        QVERIFY(neverInterrupted(filmOf(session)));
        QCOMPARE(screen.notices().size(), std::size_t(1));
        const QString notice = QString::fromStdString(screen.notices().front());
        QVERIFY2(notice.startsWith("The GPU failing ") && notice.contains("the device is lost") &&
                     notice.endsWith("Rendering continues on the CPU."),
                 qPrintable(notice));
    }

    /// All samples taken up to two seconds before the device was lost are still known after it, and the image stands
    /// still for no longer than that.
    void onlySecondsAreLost() {
        const auto clock = std::make_shared<test::FakeClock>();
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->clock = clock;
        mishaps->iterationSeconds = 0.002;
        mishaps->goneAt = clock->seconds() + 3;
        test::Screen screen;
        std::atomic<std::uint64_t> last = 0;
        const FrameSink sink = [&last, shown = screen.sink()](std::shared_ptr<const Frame> frame) {
            if (frame->device == "failing")
                last = frame->status.samplesPerPixel;
            shown(std::move(frame));
        };
        Session session(test::failing(mishaps), sink, kCpu, test::readingOf(clock));
        begin(session);
        const auto first = screen.await(onCpu);
        QVERIFY(first);
        QCOMPARE(mishaps->filmsRead.load(), 1 + kFirstImages);
        QCOMPARE(std::uint64_t(last), std::uint64_t(1500));  // 3 s
        QVERIFY2(first->status.samplesPerPixel > 1000, qPrintable(QString::number(first->status.samplesPerPixel)));
        QVERIFY(neverInterrupted(filmOf(session)));
        QCOMPARE(screen.notices().size(), std::size_t(1));
    }

    void theHostNeedsNoCheckpoint() {
        // The CPU behind the same counters; it says that its film is lost only with the program.
        class Host final : public Device {
          public:
            explicit Host(std::shared_ptr<test::Mishaps> mishaps) : inner_(std::move(mishaps)) {}
            DeviceInfo info() const override { return {"host", "", true}; }
            Result<void> upload(const Scene& scene) override { return inner_.upload(scene); }
            Result<void> unload() override { return inner_.unload(); }
            Result<std::unique_ptr<Accumulator>> film(const Tile& area, std::uint64_t revision,
                                                      const Schedule& schedule) override {
                return inner_.film(area, revision, schedule);
            }

          private:
            test::FailingDevice inner_;
        };
        const auto clock = std::make_shared<test::FakeClock>();
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->clock = clock;
        mishaps->iterationSeconds = 0.01;
        test::Screen screen;
        Session session(std::make_unique<Host>(mishaps), screen.sink(), DeviceOpener(), test::readingOf(clock));
        begin(session);
        QVERIFY(screen.await(samples(1000)));  // 10 s
        QCOMPARE(mishaps->filmsRead.load(), kFirstImages);
    }

    void aFaultWhilePausedIsHealedToo() {
        auto mishaps = std::make_shared<test::Mishaps>();
        test::Screen screen;
        Session session(test::failing(mishaps), screen.sink(), kCpu);
        begin(session);
        QVERIFY(screen.await(samples(10)));
        session.setPaused(true);
        std::this_thread::sleep_for(50ms);
        mishaps->gone = true;
        session.setDisplay({.exposure = 2});
        QVERIFY(screen.await(onCpu));  // one image, as of a new scene
        std::this_thread::sleep_for(100ms);
        const std::uint64_t held = filmOf(session).samplesPerPixel();
        std::this_thread::sleep_for(100ms);
        QCOMPARE(filmOf(session).samplesPerPixel(), held);
        session.setPaused(false);
        QVERIFY(screen.await(samples(held + 3)));
        QVERIFY(neverInterrupted(filmOf(session)));
    }

    void aVolumeThatIsRefusedIsRenderedOnTheCpu() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->tooSmall = true;
        test::Screen screen;
        Session session(test::failing(mishaps), screen.sink(), kCpu);
        begin(session);
        QVERIFY(screen.await(onCpu));
        QCOMPARE(screen.notices().size(), std::size_t(1));
        const QString notice = QString::fromStdString(screen.notices().front());
        QVERIFY2(notice.contains("9.3 GB") && notice.contains("6.0 GB") && notice.contains("on the CPU"),
                 qPrintable(notice));
        QVERIFY(neverInterrupted(filmOf(session)));
    }

    void aFallbackThatFailsTooIsAnErrorAndTheNextDeviceGoesOn() {
        std::atomic<int> opened = 0;
        const auto frail = [&opened] {
            ++opened;
            auto mishaps = std::make_shared<test::Mishaps>();
            mishaps->accumulates = 5;
            return test::failing(mishaps);
        };
        test::Screen screen;
        Session session(frail(), screen.sink(), frail);
        begin(session);
        const auto failed = screen.await([](const Frame& frame) { return !frame.error.empty(); });
        QVERIFY(failed && failed->revision == 1);
        QVERIFY(failed->error.find("the device is lost") != std::string::npos);
        QCOMPARE(screen.notices().size(), std::size_t(1));
        QCOMPARE(opened.load(), 2);  // the device and its fallback; they do not alternate for ever
        session.setDevice(kCpu);
        QVERIFY(screen.await(onCpu));
        QVERIFY(neverInterrupted(filmOf(session)));
    }

    void aDeviceChosenAfterAFaultMayFailToo() {
        auto first = std::make_shared<test::Mishaps>(), second = std::make_shared<test::Mishaps>();
        first->gone = true;
        test::Screen screen;
        Session session(test::failing(first), screen.sink(), kCpu);
        begin(session);
        QVERIFY(screen.await(onCpu));
        session.setDevice(opener(second));
        QVERIFY(screen.await([](const Frame& frame) { return frame.device == "failing"; }));
        second->gone = true;
        QVERIFY(screen.await(onCpu));
        QCOMPARE(screen.notices().size(), std::size_t(2));
        QVERIFY(neverInterrupted(filmOf(session)));
    }

    void aFallbackThatCannotBeOpenedOrRefusesIsAnError() {
        auto small = std::make_shared<test::Mishaps>();
        small->tooSmall = true;
        const DeviceOpener none = [] { return Error{"there is no such device", "cuda:7", ""}; };
        for (const DeviceOpener& fallback : {none, opener(small), DeviceOpener()}) {
            auto mishaps = std::make_shared<test::Mishaps>();
            mishaps->readbacks = 2;
            test::Screen screen;
            Session session(test::failing(mishaps), screen.sink(), fallback);
            begin(session);
            const auto failed = screen.await([](const Frame& frame) { return !frame.error.empty(); });
            QVERIFY(failed && failed->error.find("the device is lost") != std::string::npos);
            QVERIFY(screen.notices().empty());
        }
    }

    void devicesChangedTwentyTimesLoseNothing() {
        auto one = std::make_shared<test::Mishaps>(), other = std::make_shared<test::Mishaps>();
        other->maxInFlight = 3;
        test::Screen screen;
        Session session(test::failing(one), screen.sink(), kCpu);
        session.setIterationsPerFrame(7);
        begin(session);
        std::uint64_t before = 0;
        for (int i = 0; i < 20; ++i) {
            session.setDevice(i % 3 == 0 ? kCpu : opener(i % 3 == 1 ? one : other));
            const Film film = filmOf(session);
            QVERIFY(film.samplesPerPixel() >= before);
            before = film.samplesPerPixel();
            std::this_thread::sleep_for(std::chrono::milliseconds(i));
        }
        QVERIFY(screen.await(samples(before + 1)));
        QVERIFY(screen.notices().empty());
        QVERIFY(neverInterrupted(filmOf(session)));
    }

    void aDeviceThatRefusesChangesNothing() {
        auto small = std::make_shared<test::Mishaps>();
        small->tooSmall = true;
        const DeviceOpener none = [] { return Error{"there is no such device", "cuda:7", "Choose cpu."}; };
        test::Screen screen;
        Session session(makeCpuDevice(1), screen.sink(), kCpu);
        begin(session);
        QVERIFY(screen.await(samples(20)));
        session.setDevice(opener(small));
        QTRY_COMPARE_WITH_TIMEOUT(screen.notices().size(), std::size_t(1), test::kPatience);
        const std::uint64_t before = filmOf(session).samplesPerPixel();
        QVERIFY(before >= 20);
        session.setDevice(none);
        QVERIFY(screen.await(samples(before + 5)));
        QTRY_COMPARE_WITH_TIMEOUT(screen.notices().size(), std::size_t(2), test::kPatience);
        QVERIFY(screen.notices()[0].find("6.0 GB are free") != std::string::npos);
        QVERIFY(screen.notices()[1].find("cuda:7") != std::string::npos);
        QVERIFY(neverInterrupted(filmOf(session)));
    }

    void samplesOfTexturesAndOfTheCpuAreNotMixed_data() {
        QTest::addColumn<bool>("isLost");
        QTest::newRow("another device is chosen") << false;
        QTest::newRow("the device is lost") << true;
    }
    /// What the CPU says of its film's bias would be wrong with a GPU's samples in it.
    void samplesOfTexturesAndOfTheCpuAreNotMixed() {
        QFETCH(const bool, isLost);
        Scene scene = someScene();
        scene.filtering = Filtering::fast;
        const auto clock = std::make_shared<test::FakeClock>();
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->clock = clock;
        mishaps->iterationSeconds = 0.1;
        test::Screen screen;
        Session session(test::failing(mishaps), screen.sink(), kCpu, test::readingOf(clock));
        session.submit(scene, false);
        session.goOn();
        QVERIFY(screen.await(samples(50)));  // 5 s: there is a checkpoint
        if (isLost)
            mishaps->gone = true;
        else
            session.setDevice(kCpu);
        QVERIFY(screen.await(onCpu));
        const Film film = filmOf(session);
        QVERIFY(test::sameBits(film, test::render(scene, film.samplesPerPixel())));
        QCOMPARE(screen.notices().size(), std::size_t(1));
        const QString notice = QString::fromStdString(screen.notices().front());
        QVERIFY2(notice.endsWith("The image begins anew on the CPU, which filters the volume in another way."),
                 qPrintable(notice));
    }

    void aLongFrameDoesNotHoldTheChangeUp() {
        const auto clock = std::make_shared<test::FakeClock>();
        auto slow = std::make_shared<test::Mishaps>();
        slow->clock = clock;
        slow->iterationSeconds = 0.02;
        test::Screen screen;
        Session session(test::failing(slow), screen.sink(), kCpu, test::readingOf(clock));
        begin(session);
        QVERIFY(screen.await(samples(2)));  // its speed is known by now
        session.setIterationsPerFrame(1000);
        session.setDevice(kCpu);
        const double asked = clock->seconds();
        QVERIFY(screen.await(onCpu));
        QVERIFY(clock->seconds() - asked < 2);  // a frame takes 20 s
        QVERIFY(neverInterrupted(filmOf(session)));
    }

    void itEndsInTheMiddleOfAnything() {
        for (int i = 0; i < 60; ++i) {
            auto mishaps = std::make_shared<test::Mishaps>();
            mishaps->accumulates = i;
            mishaps->maxInFlight = 1 + i % 3;
            mishaps->tooSmall = i % 7 == 0;
            test::Screen screen;
            Session session(test::failing(mishaps), screen.sink(), i % 5 == 0 ? opener(mishaps) : kCpu);
            session.setIterationsPerFrame(1 + i % 4);
            session.submit(someScene(), i % 4 == 0);
            std::this_thread::sleep_for(std::chrono::microseconds(i * 200));
            session.setDevice(kCpu);
            Scene old = someScene();
            old.schedule.kind = Schedule::Kind::kroes;
            session.submit(old, false);
            session.requestSnapshot(1, [](const Result<FilmView>&) {});
            std::this_thread::sleep_for(std::chrono::microseconds(i % 6 * 300));
        }
    }
};

QTEST_GUILESS_MAIN(FaultsTest)
#include "faults_test.moc"
