/// A scene that comes back, as after undo, shows its converged image at once, and its film goes on as if it had never
/// been put away.

// First: it includes TBB, of whose names Qt takes some for keywords.
#include "tests/support/network/nearby_worker.h"

#include <QTest>

#include <atomic>
#include <functional>
#include <future>

#include "render/film/display/tone_map.h"
#include "render/tiles/shared_device.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/reel.h"
#include "tests/support/patience.h"
#include "tests/support/scenes/images.h"

using namespace pdr;
using test::Reel;

namespace {

constexpr std::uint64_t kEnough = 40;

/// The scene of one view, under another number.
Scene view(int which, std::uint64_t revision) {
    static const std::shared_ptr<const Volume> volume = test::largeScene(1).volume;
    Scene scene = test::largeScene(std::uint64_t(which));
    scene.volume = volume;
    scene.film = {96, 64};
    scene.revision = revision;
    return scene;
}

/// A clock on which everything takes a while, however fast the machine is.
SessionClock ticking() {
    return [seconds = std::make_shared<double>(0)] { return *seconds += 0.02; };
}

std::unique_ptr<Device> deviceNamed(const QString& name) {
    return name == "cpu" ? makeCpuDevice(1) : test::failing(std::make_shared<test::Mishaps>());
}

bool isFull(const Frame& frame) {
    return !frame.coarse && !frame.rgba.empty();
}

/// A session and all that it has shown.
struct Rendering {
    Reel reel;
    Session session;

    /// `seen` gets each frame on the render thread.
    explicit Rendering(
        std::unique_ptr<Device> device, DeviceOpener fallback = {},
        std::function<void(const Frame&)> seen = [](const Frame&) {})
        : session(
              std::move(device),
              [sink = reel.sink(), seen = std::move(seen)](const std::shared_ptr<const Frame>& frame) {
                  sink(frame);
                  seen(*frame);
              },
              std::move(fallback), ticking()) {}

    /// Renders a view until its image has so many samples.
    void render(int which, std::uint64_t revision, std::uint64_t samples = kEnough) {
        session.submit(view(which, revision), false);
        session.goOn();
        QTRY_VERIFY_WITH_TIMEOUT(reel.full(revision) && last(revision)->status.samplesPerPixel >= samples,
                                 test::kPatience);
    }
    /// Submits a view and waits for its first frame.
    std::shared_ptr<const Frame> firstOf(int which, std::uint64_t revision) {
        session.submit(view(which, revision), false);
        return QTest::qWaitFor([&] { return !reel.of(revision).empty(); }, test::kPatience) ? reel.of(revision).front()
                                                                                            : nullptr;
    }
    std::shared_ptr<const Frame> last(std::uint64_t revision) { return reel.of(revision).back(); }
    /// Returns the film of that revision.
    Film film(std::uint64_t revision) {
        auto film = std::make_shared<std::promise<Film>>();
        auto future = film->get_future();
        session.requestSnapshot(revision, [film](const Result<FilmView>& seen) { film->set_value(seen->film); });
        if (future.wait_for(std::chrono::minutes(30)) != std::future_status::ready)
            qFatal("nobody looks at the film");
        return future.get();
    }
};

}  // namespace

class ReturningFilmsTest : public QObject {
    Q_OBJECT

  private slots:
    void itsImageIsBackAtOnceAndItsBitsAreThoseOfAFilmNeverLeft_data() {
        QTest::addColumn<QString>("device");
        QTest::newRow("cpu") << "cpu";
        QTest::newRow("gpu") << "gpu";
    }
    void itsImageIsBackAtOnceAndItsBitsAreThoseOfAFilmNeverLeft() {
        QFETCH(const QString, device);
        Rendering shown(deviceNamed(device));
        shown.render(1, 1);
        shown.render(2, 2);
        const std::shared_ptr<const Frame> before = shown.last(1), back = shown.firstOf(1, 3);
        QVERIFY(back && isFull(*back));
        QVERIFY(back->status.samplesPerPixel >= before->status.samplesPerPixel);
        QVERIFY(back->rgba == before->rgba && back->camera == before->camera);
        QCOMPARE(back->status.displayError, before->status.displayError);
        QVERIFY(back->seconds >= before->seconds && back->history.size() >= before->history.size());
        shown.session.goOn();
        const std::uint64_t more = before->status.samplesPerPixel + 70;
        QTRY_VERIFY_WITH_TIMEOUT(shown.last(3)->status.samplesPerPixel >= more, test::kPatience);
        const Film film = shown.film(3);
        QVERIFY(film.samplesPerPixel() >= more);
        QVERIFY(test::sameBits(film, test::render(view(1, 1), film.samplesPerPixel())));
        for (const auto& frame : shown.reel.of(3))
            QVERIFY(isFull(*frame) && frame->status.samplesPerPixel >= before->status.samplesPerPixel);
    }

    void bothWaysAgainAndAgain() {
        Rendering shown(makeCpuDevice(1));
        shown.render(1, 1);
        shown.render(2, 2);
        for (std::uint64_t revision = 3; revision < 9; ++revision) {
            const int which = revision % 2 == 0 ? 2 : 1;
            const std::uint64_t had = shown.last(revision - 2)->status.samplesPerPixel;
            const std::shared_ptr<const Frame> back = shown.firstOf(which, revision);
            QVERIFY(back && isFull(*back) && back->status.samplesPerPixel >= had);
        }
        shown.session.goOn();
        const std::uint64_t more = shown.last(8)->status.samplesPerPixel + 2;
        QTRY_VERIFY_WITH_TIMEOUT(shown.last(8)->status.samplesPerPixel >= more, test::kPatience);
        const Film film = shown.film(8);
        QVERIFY(test::sameBits(film, test::render(view(2, 2), film.samplesPerPixel())));
    }

    void anotherSceneBeginsAnew() {
        Rendering shown(makeCpuDevice(1));
        shown.render(1, 1);
        shown.render(2, 2);
        Scene other = view(1, 3);
        other.seed = 2;
        shown.session.submit(other, false);
        QTRY_VERIFY_WITH_TIMEOUT(shown.reel.full(3), test::kPatience);
        QVERIFY(shown.reel.of(3).front()->status.samplesPerPixel < kEnough / 2);
        const Film film = shown.film(3);
        QVERIFY(test::sameBits(film, test::render(other, film.samplesPerPixel())));
    }

    void closingTheSeriesDropsAllFilms() {
        Rendering shown(makeCpuDevice(1));
        shown.render(1, 1);
        shown.render(2, 2);
        shown.session.clear();
        const std::shared_ptr<const Frame> again = shown.firstOf(1, 3);
        QVERIFY(again && again->status.samplesPerPixel < kEnough / 2);
    }

    void withoutMemoryNoneComesBack() {
        Rendering shown(makeCpuDevice(1));
        shown.session.setKeptMemory(0);
        shown.render(1, 1);
        shown.render(2, 2);
        const std::shared_ptr<const Frame> again = shown.firstOf(1, 3);
        QVERIFY(again && again->status.samplesPerPixel < kEnough / 2);
    }

    /// The image that was shown last is another one then; it is made anew, of all samples.
    void onAnotherDisplayItIsThatDisplays() {
        Rendering shown(makeCpuDevice(1));
        shown.session.setDisplay({.exposure = 1});
        shown.render(1, 1);
        shown.render(2, 2);
        shown.session.setPaused(true);
        shown.session.setDisplay({.exposure = 3});
        const std::shared_ptr<const Frame> back = shown.firstOf(1, 3);
        QVERIFY(back && isFull(*back));
        QCOMPARE(back->display.exposure, 3.0f);
        const Film film = shown.film(3);
        QCOMPARE(back->status.samplesPerPixel, film.samplesPerPixel());
        QVERIFY(back->rgba == toneMap(film, {.exposure = 3}));
    }

    void aPausedSessionShowsItAndHolds() {
        Rendering shown(makeCpuDevice(1));
        shown.render(1, 1);
        shown.render(2, 2);
        shown.session.setPaused(true);
        const std::shared_ptr<const Frame> back = shown.firstOf(1, 3);
        QVERIFY(back && isFull(*back));
        const std::uint64_t samples = shown.film(3).samplesPerPixel();
        QTest::qWait(100);
        QCOMPARE(shown.film(3).samplesPerPixel(), samples);
        QVERIFY(samples >= back->status.samplesPerPixel);
    }

    /// Undo, pressed again before the device has taken the scene of the first.
    void aSceneThatPassesByCostsNoUpload() {
        auto mishaps = std::make_shared<test::Mishaps>();
        std::atomic<int> uploads = 0, before = 0;
        mishaps->before = [&](const std::string& call) { uploads += call == "upload"; };
        Session* session = nullptr;
        Rendering shown(test::failing(mishaps), {}, [&](const Frame& frame) {
            if (frame.revision != 4)
                return;
            before = uploads.load();
            session->submit(view(1, 5), false);
        });
        session = &shown.session;
        for (std::uint64_t revision = 1; revision <= 3; ++revision)
            shown.render(int(revision), revision);
        const std::shared_ptr<const Frame> passing = shown.firstOf(2, 4);
        QVERIFY(passing && isFull(*passing));
        QTRY_VERIFY_WITH_TIMEOUT(shown.reel.full(5), test::kPatience);
        QCOMPARE(shown.reel.of(4).size(), std::size_t(1));
        const std::uint64_t had = shown.last(1)->status.samplesPerPixel;
        QVERIFY(shown.reel.of(5).front()->status.samplesPerPixel >= had);
        const std::shared_ptr<const Frame> again = shown.firstOf(2, 6);
        QVERIFY(again && isFull(*again) && again->status.samplesPerPixel >= passing->status.samplesPerPixel);
        shown.session.goOn();
        const std::uint64_t more = again->status.samplesPerPixel + 2;
        QTRY_VERIFY_WITH_TIMEOUT(shown.last(6)->status.samplesPerPixel >= more, test::kPatience);
        QCOMPARE(uploads - before, 2);
        const Film film = shown.film(6);
        QVERIFY(test::sameBits(film, test::render(view(2, 2), film.samplesPerPixel())));
    }

    /// While the hand moves, images pass by; the film comes back where it comes to rest.
    void aGestureThatEndsWhereItBeganBringsItBack() {
        Rendering shown(makeCpuDevice(1));
        shown.render(1, 1);
        shown.session.submit(view(2, 2), true);
        QTRY_VERIFY_WITH_TIMEOUT(!shown.reel.of(2).empty(), test::kPatience);
        shown.session.submit(view(1, 3), true);
        shown.session.submit(view(1, 3), false);
        QTRY_VERIFY_WITH_TIMEOUT(shown.reel.full(3), test::kPatience);
        const auto frames = shown.reel.of(3);
        const auto full = std::ranges::find_if(frames, [](const auto& frame) { return isFull(*frame); });
        QVERIFY((*full)->status.samplesPerPixel >= kEnough);
    }

    void nodesGoOnWhereTheFilmStands() {
        const auto pool = std::make_shared<WorkerPool>(1);
        pool->setOwnHelps(false);
        test::NearbyWorker node(pool, "node");
        Rendering shown(shareDevice(makeCpuDevice(1), pool));
        shown.render(1, 1);
        shown.render(2, 2);
        const std::uint64_t had = shown.last(1)->status.samplesPerPixel;
        const std::shared_ptr<const Frame> back = shown.firstOf(1, 3);
        QVERIFY(back && isFull(*back) && back->status.samplesPerPixel >= had);
        shown.session.goOn();
        QTRY_VERIFY_WITH_TIMEOUT(shown.last(3)->status.samplesPerPixel >= had + 70, test::kPatience);
        const Film film = shown.film(3);
        QVERIFY(test::sameBits(film, test::render(view(1, 1), film.samplesPerPixel())));
    }

    void aFilmToWhichALiarHasContributedDoesNotComeBack() {
        const auto pool = std::make_shared<WorkerPool>(1);
        pool->setOwnHelps(false);
        test::NearbyWorker node(pool, "node");
        Rendering shown(shareDevice(makeCpuDevice(1), pool));
        shown.render(1, 1);
        // Until then every result has been checked, and the film can be trusted whatever becomes of the node.
        QTRY_VERIFY_WITH_TIMEOUT(node.status().isProved, test::kPatience);
        const std::uint64_t checked = shown.last(1)->status.samplesPerPixel;
        QTRY_VERIFY_WITH_TIMEOUT(shown.last(1)->status.samplesPerPixel > checked + 10, test::kPatience);
        shown.render(2, 2);
        pool->quarantine(node.status().id, "it lied");
        const std::shared_ptr<const Frame> again = shown.firstOf(1, 3);
        QVERIFY(again && again->status.samplesPerPixel < kEnough / 2);
    }

    void aDeviceThatIsLostOnTheWayBackLosesNoSample() {
        auto mishaps = std::make_shared<test::Mishaps>();
        Rendering shown(test::failing(mishaps), [] { return makeCpuDevice(1); });
        shown.render(1, 1);
        shown.render(2, 2);
        const std::uint64_t had = shown.last(1)->status.samplesPerPixel;
        mishaps->uploads = 0;
        QVERIFY(shown.firstOf(1, 3));
        QTRY_VERIFY_WITH_TIMEOUT(shown.last(3)->device == "cpu" && isFull(*shown.last(3)), test::kPatience);
        shown.session.goOn();
        QTRY_VERIFY_WITH_TIMEOUT(shown.last(3)->status.samplesPerPixel >= had + 2, test::kPatience);
        const Film film = shown.film(3);
        QVERIFY(test::sameBits(film, test::render(view(1, 1), film.samplesPerPixel())));
    }
};

QTEST_GUILESS_MAIN(ReturningFilmsTest)
#include "returning_films_test.moc"
