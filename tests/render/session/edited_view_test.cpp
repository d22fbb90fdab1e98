/// The image after an edit of the look, in a session: sharp at once, and gone without a trace.

#include <QTest>
#include <atomic>
#include <future>

#include "tests/support/devices/reel.h"
#include "tests/support/patience.h"
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
        return scene;
    }();
    Scene scene = first;
    scene.revision = revision;
    scene.transferFunction.nodes[1].hu += 20.0f * float(revision - 1);
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

/// A session whose first scene has an image of many samples, which was judged.
struct Edited {
    Reel reel;
    Session session{makeCpuDevice(), reel.sink(), {}, unhurried()};

    void begin() {
        session.setDisplay(kDisplay);
        session.setIterationsPerFrame(40);
        session.submit(sceneOf(1), false);
        session.setStop({.levels = 1e-3});
        waitFor(1, 40);
        session.setPaused(true);  // its image is judged now
        QTest::qWait(300);
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
        edited.begin();
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
        QVERIFY(shown > 0.1);  // one sample tells little of it in so small an image
    }

    void whileTheHandMovesTheImageIsFull() {
        Edited edited;
        edited.begin();
        for (std::uint64_t revision = 2; revision <= 5; ++revision) {
            edited.session.submit(sceneOf(revision), true);
            QTRY_VERIFY_WITH_TIMEOUT(!edited.reel.of(revision).empty(), test::kPatience);
            const auto first = edited.reel.of(revision).front();
            QVERIFY(!first->coarse);
            QCOMPARE(first->size.x, sceneOf(1).film.x);
        }
    }

    /// The film of the edited scene never knows of the old image, nor does the image in the end.
    void inTheEndNothingIsLeftOfTheOldImage() {
        Edited edited;
        edited.begin();
        edited.session.submit(sceneOf(2), false);
        edited.waitFor(2, 50);
        edited.session.setPaused(true);
        QTest::qWait(500);
        const Result<Film> film = filmOf(edited.session, 2);
        QVERIFY(film);
        QVERIFY(test::sameBits(*film, test::render(sceneOf(2), film->samplesPerPixel())));
        const auto last = edited.reel.of(2).back();
        QCOMPARE(last->status.samplesPerPixel, film->samplesPerPixel());
        QVERIFY(last->rgba == imageOf(*film, {kDisplay.exposure, last->denoised}).rgba);
    }

    /// Another view begins as it always did: the old image is of other places.
    void anotherViewForgetsTheOldImage() {
        Edited edited;
        edited.begin();
        Scene turned = sceneOf(2);
        turned.camera.eyeMm.x += 30;
        edited.session.submit(turned, false);
        QTRY_VERIFY_WITH_TIMEOUT(edited.reel.full(2), test::kPatience);
        const auto first = edited.reel.of(2).front();
        const Film film = test::render(turned, first->status.samplesPerPixel);
        QVERIFY(first->rgba == imageOf(film, {kDisplay.exposure, first->denoised}).rgba);
    }
};

QTEST_GUILESS_MAIN(EditedViewTest)
#include "edited_view_test.moc"
