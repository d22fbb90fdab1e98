/// Look-ups of places: askers share one prepared scene, and none of them cancels another.

#include <QSignalSpy>
#include <QTest>

#include "app/jobs/place_job.h"
#include "tests/support/patience.h"
#include "tests/support/scenes/scenes.h"

namespace pdr::app {
namespace {

Scene imageOfABlock() {
    return test::plainScene(test::makeVolume({16, 16, 16}, dvec3(1), [](int, int, int) { return 100; }), 1);
}

}  // namespace

class PlaceJobTest : public QObject {
    Q_OBJECT

  private slots:
    /// Two that look and two that pick, as the window's features do.
    void fourAskersPrepareAnImageOnce() {
        PlaceScenes scenes;
        PlaceJob crosshair(scenes), marks(scenes), click(scenes), menu(scenes);
        QSignalSpy seenByCrosshair(&crosshair, &PlaceJob::seen), seenByMarks(&marks, &PlaceJob::seen);
        QSignalSpy foundByClick(&click, &PlaceJob::found), foundByMenu(&menu, &PlaceJob::found);
        Scene scene = imageOfABlock();
        const auto askAll = [&] {
            crosshair.look(scene, {dvec3(0)});
            marks.look(scene, {dvec3(1), dvec3(2)});
            click.pick(scene, {0.5, 0.5});
            menu.pick(scene, {0.25, 0.5});
        };
        for (int edits = 1; edits <= 2; ++edits) {
            askAll();
            for (const QSignalSpy* answers : {&seenByCrosshair, &seenByMarks, &foundByClick, &foundByMenu})
                QTRY_COMPARE_WITH_TIMEOUT(answers->size(), edits, test::kPatience);
            QCOMPARE(scenes.current()->preparations(), edits);
            ++scene.revision;
        }
        QCOMPARE(seenByCrosshair[0][0].value<std::vector<dvec3>>().size(), std::size_t(1));  // each has its own answer
        QCOMPARE(seenByMarks[0][0].value<std::vector<dvec3>>().size(), std::size_t(2));
    }

    /// The newest question of an asker is the one that is answered.
    void anAskerIsAnsweredOnce() {
        PlaceScenes scenes;
        PlaceJob job(scenes);
        QSignalSpy seen(&job, &PlaceJob::seen), finished(&job, &PlaceJob::finished);
        const Scene scene = imageOfABlock();
        job.look(scene, {dvec3(1)});
        job.look(scene, {dvec3(2)});
        QTRY_COMPARE_WITH_TIMEOUT(seen.size(), 1, test::kPatience);
        QCOMPARE(seen[0][0].value<std::vector<dvec3>>().front(), dvec3(2));
        QCOMPARE(finished.size(), 1);
    }

    void droppedVolumesAreReleased() {
        PlaceScenes scenes;
        PlaceJob one(scenes), other(scenes);
        Scene scene = imageOfABlock();
        const std::weak_ptr<const Volume> held = scene.volume;
        one.look(scene, {dvec3(1)});
        other.pick(scene, {0.5, 0.5});
        scene = {};
        one.drop();
        other.drop();
        QTRY_VERIFY_WITH_TIMEOUT(held.expired(), test::kPatience);
    }
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::PlaceJobTest)
#include "place_job_test.moc"
