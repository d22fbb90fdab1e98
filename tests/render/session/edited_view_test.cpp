/// The image after an edit of the look, in a session: sharp at once, and gone without a trace.

#include <QTest>
#include <atomic>
#include <future>
#include <map>

#include "render/session/featured_view.h"
#include "render/session/resolution_ladder.h"
#include "tests/support/devices/failing_device.h"
#include "tests/support/devices/forwarding_device.h"
#include "tests/support/devices/reel.h"
#include "tests/support/patience.h"
#include "tests/support/scenes/featured_images.h"
#include "tests/support/scenes/images.h"
#include "tests/support/scenes/tissue_scene.h"

using namespace pdr;
using test::Reel;

namespace {

constexpr Display kDisplay{1, true};

/// A clock by which every device is fast.
SessionClock unhurried() {
    return [now = std::make_shared<std::atomic<double>>(0)] { return *now += 1e-4; };
}

/// A scene, and the same with darker colours and a node moved: edits of one view.
Scene sceneOf(std::uint64_t revision) {
    static const Scene first = [] {
        Scene scene = test::tissueScene();
        scene.film = {80, 64};
        scene.background = vec3(0);  // light beside the patient would hide the change of coarse pixels
        return scene;
    }();
    Scene scene = first;
    scene.revision = revision;
    scene.transferFunction.nodes[1].hu += 20.0f * float(revision - 1);
    for (TransferNode& node : scene.transferFunction.nodes)
        node.albedo *= 1 - 0.15f * float(revision - 1);
    return scene;
}

/// The scene with darker colours alone.
Scene darkened(std::uint64_t revision) {
    Scene scene = sceneOf(1);
    scene.revision = revision;
    for (TransferNode& node : scene.transferFunction.nodes)
        node.albedo *= 1 - 0.15f * float(revision - 1);
    return scene;
}

/// Returns the root mean square difference of the levels of two images.
double apart(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double squares = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        squares += (double(a[i]) - b[i]) * (double(a[i]) - b[i]);
    return std::sqrt(squares / double(a.size()));
}

/// Returns the part of the change from `old` to `truth` that `shown` shows.
double partOfChange(const std::vector<std::uint8_t>& old, const std::vector<std::uint8_t>& shown,
                    const std::vector<std::uint8_t>& truth) {
    double product = 0, squares = 0;
    for (std::size_t i = 0; i < old.size(); ++i) {
        const double change = double(truth[i]) - old[i];
        product += (double(shown[i]) - old[i]) * change;
        squares += change * change;
    }
    return product / squares;
}

Result<Film> filmOf(Session& session, std::uint64_t revision) {
    std::promise<Result<Film>> film;
    session.requestSnapshot(revision, [&](const Result<FilmView>& view) {
        film.set_value(view ? Result<Film>(view->film) : Result<Film>(view.error()));
    });
    return film.get_future().get();
}

/// A CPU device that counts its guides that are as fine as the film.
class GuideCounter final : public test::ForwardingDevice {
  public:
    explicit GuideCounter(std::atomic<int>& guides) : ForwardingDevice(makeCpuDevice()), guides_(guides) {}

    std::shared_ptr<const denoise::Guide> guide(const denoise::GuideRays& rays, const std::stop_token& stop) override {
        guides_ += rays.finer == 1 && rays.place == vec2(0.5f);
        return ForwardingDevice::guide(rays, stop);
    }

  private:
    std::atomic<int>& guides_;
};

/// Returns the mishaps of a device so slow that only coarse films come in time, by a clock of its own.
std::shared_ptr<test::Mishaps> slowness() {
    auto mishaps = std::make_shared<test::Mishaps>();
    mishaps->clock = std::make_shared<test::FakeClock>();
    mishaps->sampleSeconds = 1 / 40e3;
    return mishaps;
}

/// A session whose first scene has an image of many samples, which was judged.
struct Edited {
    Reel reel;
    Session session;

    explicit Edited(std::unique_ptr<Device> device = makeCpuDevice(), SessionClock clock = unhurried())
        : session(std::move(device), reel.sink(), {}, std::move(clock)) {
        begin();
    }

    void begin() {
        session.setDisplay(kDisplay);
        session.setIterationsPerFrame(40);
        session.submit(sceneOf(1), false);
        session.setStop({.levels = 1e-3});
        rest(1, 40);
    }
    /// Waits for that many samples, for the judgement of their image, and until the next edit is prepared.
    void rest(std::uint64_t revision, std::uint64_t samples) {
        waitFor(revision, samples);
        session.setPaused(true);
        for (int i = 0; i < 2; ++i)
            QVERIFY(filmOf(session, revision));  // the first comes after the judgement, the second after what follows
        session.setPaused(false);
    }
    void waitFor(std::uint64_t revision, std::uint64_t samples) {
        (void)QTest::qWaitFor(
            [&] {
                const auto frames = reel.of(revision);
                return !frames.empty() && frames.back()->status.samplesPerPixel >= samples;
            },
            test::kPatience);
    }
};

}  // namespace

class EditedViewTest : public QObject {
    Q_OBJECT

  private slots:
    void theFirstImageAfterAnEditIsSharp() {
        Edited edited;
        edited.session.submit(sceneOf(2), false);
        QTRY_VERIFY_WITH_TIMEOUT(edited.reel.full(2), test::kPatience);
        const auto first = edited.reel.of(2).front();
        QVERIFY(!first->coarse && first->denoised);
        QCOMPARE(first->size.x, sceneOf(2).film.x);
        QCOMPARE(first->status.samplesPerPixel, std::uint64_t(1));
        const auto truth = imageOf(test::render(sceneOf(2), 256), kDisplay).rgba;
        const double off = apart(first->rgba, truth);
        const double alone = apart(imageOf(test::render(sceneOf(2), 1), kDisplay).rgba, truth);
        const double shown = partOfChange(imageOf(test::render(sceneOf(1), 256), kDisplay).rgba, first->rgba, truth);
        qInfo("off by %.2f levels; alone %.2f; %.2f of the change", off, alone, shown);
        QVERIFY(off < 0.5 * alone);
        QVERIFY(shown > 0.7 && shown < 1.3);  // one sample tells little of it in so small an image, guides much
    }

    void theGuideOfAnEditIsMadeOnce() {
        std::atomic<int> guides = 0;
        Edited edited(std::make_unique<GuideCounter>(guides));
        guides = 0;
        edited.session.submit(sceneOf(2), false);
        edited.waitFor(2, 16);
        edited.session.setPaused(true);
        QVERIFY(filmOf(edited.session, 2));  // nothing goes on meanwhile
        QCOMPARE(guides.load(), 1);
    }

    void whileTheHandMovesTheImageIsFull() {
        Edited edited;
        for (std::uint64_t revision = 2; revision <= 5; ++revision) {
            edited.session.submit(sceneOf(revision), true);
            QTRY_VERIFY_WITH_TIMEOUT(!edited.reel.of(revision).empty(), test::kPatience);
            const auto first = edited.reel.of(revision).front();
            QVERIFY(!first->coarse);
            QCOMPARE(first->size.x, sceneOf(1).film.x);
        }
    }

    /// Where there is no time for all pixels there is for the change, which is laid on all of them. The scene before
    /// has been rendered for it at rest.
    void onASlowDeviceTheImageIsFullToo() {
        const auto mishaps = slowness();
        std::atomic<int> uploads = 0;
        mishaps->before = [&](const std::string& call) { uploads += call == "upload"; };
        std::map<std::uint64_t, std::vector<std::uint8_t>> truths;  // first: the session goes on meanwhile
        for (std::uint64_t revision = 1; revision <= 5; ++revision)
            truths[revision] = imageOf(test::render(darkened(revision), 256), kDisplay).rgba;
        const auto& old = truths[1];
        Edited edited(test::failing(mishaps), test::readingOf(mishaps->clock));
        for (std::uint64_t revision = 2; revision <= 5; ++revision) {
            uploads = 0;
            edited.session.submit(darkened(revision), true);
            QTRY_VERIFY_WITH_TIMEOUT(!edited.reel.of(revision).empty(), test::kPatience);
            QCOMPARE(uploads.load(), 1);
            const auto first = edited.reel.of(revision).front();
            QVERIFY(first->coarse && first->denoised);
            QCOMPARE(first->status.samplesPerPixel, std::uint64_t(ResolutionLadder::kSamples));
            QCOMPARE(first->size.x, sceneOf(1).film.x);
            const auto& truth = truths[revision];
            const double shown = partOfChange(old, first->rgba, truth);
            qInfo("%llu: off by %.2f levels, the old image %.2f; %.2f of the change", (unsigned long long)revision,
                  apart(first->rgba, truth), apart(old, truth), shown);
            QVERIFY(apart(first->rgba, truth) < apart(old, truth));
            QVERIFY2(shown > 0.7 && shown < 1.3, qPrintable(QString::number(shown)));
        }
        edited.session.submit(darkened(5), false);
        QTRY_VERIFY_WITH_TIMEOUT(edited.reel.full(5), test::kPatience);
        const auto frames = edited.reel.of(5);
        const auto full = std::ranges::find(frames, false, [](const auto& frame) { return frame->coarse; });
        QCOMPARE((*full)->status.samplesPerPixel, std::uint64_t(1));  // better than four of each coarse pixel
        QVERIFY(!(*full)->denoisedError);                             // it did not wait for that
        for (const auto& frame : frames)
            QCOMPARE(frame->size.x, sceneOf(1).film.x);
        edited.rest(5, 64);
        uploads = 0;
        edited.session.submit(darkened(6), true);
        QTRY_VERIFY_WITH_TIMEOUT(!edited.reel.of(6).empty(), test::kPatience);
        QCOMPARE(uploads.load(), 1);
        QCOMPARE(edited.reel.of(6).front()->size.x, sceneOf(1).film.x);
    }

    /// An edit without a drag gets more pixels, of which the scene before has been rendered at rest, too.
    void anEditAloneHasTimeForMorePixels() {
        const auto mishaps = slowness();
        std::atomic<int> uploads = 0;
        mishaps->before = [&](const std::string& call) { uploads += call == "upload"; };
        Edited edited(test::failing(mishaps), test::readingOf(mishaps->clock));
        const auto secondsOfFirst = [&](std::uint64_t revision, bool moving) {
            uploads = 0;
            edited.session.submit(darkened(revision), moving);
            (void)QTest::qWaitFor([&] { return !edited.reel.of(revision).empty(); }, test::kPatience);
            const auto frames = edited.reel.of(revision);
            return frames.empty() ? 0 : frames.front()->times.made - frames.front()->times.taken;
        };
        const double inDrag = secondsOfFirst(2, true);
        QCOMPARE(uploads.load(), 1);
        const double alone = secondsOfFirst(3, false);  // with a film of the scene before it would be twice as long
        qInfo("%.4f s in a drag, %.4f s alone", inDrag, alone);
        QVERIFY(inDrag > 0 && inDrag <= ResolutionLadder::kCoarseEditSeconds);
        QVERIFY(alone > ResolutionLadder::kCoarseEditSeconds && alone <= ResolutionLadder::kRestingEditSeconds);
    }

    /// Where there was no memory for that at rest, the scene before is rendered at the edit, once.
    void whatWasNotPreparedIsRenderedAtTheEdit() {
        const auto mishaps = slowness();
        std::atomic<int> uploads = 0;
        std::atomic<bool> rests = true;
        mishaps->before = [&](const std::string& call) {
            if (call == "upload")
                mishaps->tooSmall = ++uploads % 2 == 0 && rests;  // the scene itself is uploaded first, and after each
        };
        Edited edited(test::failing(mishaps), test::readingOf(mishaps->clock));
        QVERIFY(uploads >= 3);
        edited.session.setPaused(true);
        QVERIFY(filmOf(edited.session, 1));  // nothing goes on meanwhile
        rests = false;
        for (std::uint64_t revision = 2; revision <= 3; ++revision) {
            uploads = 0;
            edited.session.submit(darkened(revision), true);
            QTRY_VERIFY_WITH_TIMEOUT(!edited.reel.of(revision).empty(), test::kPatience);
            QCOMPARE(uploads.load(), revision == 2 ? 2 : 1);
            QCOMPARE(edited.reel.of(revision).front()->size.x, sceneOf(1).film.x);
        }
    }

    /// The film of the edited scene never knows of the old image, nor does the image in the end.
    void inTheEndNothingIsLeftOfTheOldImage() {
        Edited edited;
        edited.session.submit(sceneOf(2), false);
        edited.waitFor(2, FeaturedView::kEnoughAlone);
        edited.session.setPaused(true);
        const Result<Film> film = filmOf(edited.session, 2);
        QVERIFY(film);
        QVERIFY(test::sameBits(*film, test::render(sceneOf(2), film->samplesPerPixel())));
        const auto last = edited.reel.of(2).back();
        QCOMPARE(last->status.samplesPerPixel, film->samplesPerPixel());
        QVERIFY(last->rgba == imageOf(*film, {kDisplay.exposure, last->denoised}).rgba);
    }

    /// An image that undo brings back is the old image of the edit after it.
    void anEditAfterUndoIsSharpToo() {
        auto mishaps = std::make_shared<test::Mishaps>();
        mishaps->clock = std::make_shared<test::FakeClock>();
        mishaps->iterationSeconds = 0.02;
        Edited edited(test::failing(mishaps), test::readingOf(mishaps->clock));
        edited.session.submit(sceneOf(2), false);
        edited.rest(2, 40);
        Scene undone = sceneOf(1);
        undone.revision = 3;
        edited.session.submit(undone, false);
        edited.rest(3, 40);
        QVERIFY(edited.reel.of(3).front()->status.samplesPerPixel >= 40);  // it has come back
        Scene next = darkened(3);
        next.revision = 4;
        edited.session.submit(next, false);
        QTRY_VERIFY_WITH_TIMEOUT(edited.reel.full(4), test::kPatience);
        const auto first = edited.reel.of(4).front();
        QCOMPARE(first->status.samplesPerPixel, std::uint64_t(1));
        const auto truth = imageOf(test::render(next, 256), kDisplay).rgba;
        const double alone = apart(imageOf(test::render(next, 1), kDisplay).rgba, truth);
        QVERIFY(apart(first->rgba, truth) < 0.5 * alone);
    }

    /// Another view begins as it always did: the old image is of other places.
    void anotherViewForgetsTheOldImage() {
        Edited edited;
        Scene turned = sceneOf(2);
        turned.camera.eyeMm.x += 30;
        edited.session.submit(turned, false);
        QTRY_VERIFY_WITH_TIMEOUT(edited.reel.full(2), test::kPatience);
        const auto first = edited.reel.of(2).front();
        const Film film = test::render(turned, first->status.samplesPerPixel);
        QVERIFY(first->denoised);
        QVERIFY(first->rgba == test::featuredImageOf(film, turned, kDisplay).rgba);
    }
};

QTEST_GUILESS_MAIN(EditedViewTest)
#include "edited_view_test.moc"
