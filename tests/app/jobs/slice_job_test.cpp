/// Slices in the background: the newest request is answered, the same one once, and volumes are released.

#include <QSignalSpy>
#include <QTest>

#include "app/jobs/slice_job.h"
#include "render/slice/slice_stack.h"
#include "tests/support/patience.h"
#include "tests/support/scenes/part_scenes.h"
#include "tests/support/scenes/scenes.h"

namespace pdr::app {
namespace {

std::shared_ptr<const Volume> ramp() {
    return test::makeVolume({40, 30, 20}, dvec3(1), [](int i, int j, int k) { return i + 10 * j - 20 * k; });
}

SliceJob::Request requestOf(const std::shared_ptr<const Volume>& volume, int slice) {
    return {volume, SliceStack(volume->geometry(), AnatomicalPlane::axial).slice(slice), {}};
}

}  // namespace

class SliceJobTest : public QObject {
    Q_OBJECT

  private slots:
    void theNewestRequestIsAnsweredLast() {
        SliceJob job;
        const auto volume = ramp();
        std::vector<SlicePlane> made;
        connect(&job, &SliceJob::made, [&](const QImage&, const SlicePlane& plane) { made.push_back(plane); });
        for (int slice = 0; slice < 20; ++slice)
            job.make(requestOf(volume, slice));
        QTRY_VERIFY_WITH_TIMEOUT(!made.empty() && made.back() == requestOf(volume, 19).plane, test::kPatience);
        QVERIFY(made.size() >= 2);  // the first one is never cancelled
        QVERIFY(made.front() == requestOf(volume, 0).plane);
    }

    /// The window may be closed at any moment. Slices are large, so that work is in progress then.
    void aJobEndsInTheMiddleOfItsWork() {
        const auto volume = ramp();
        SliceJob::Request large = requestOf(volume, 3);
        large.plane.size = {1600, 1600};
        for (int trial = 0; trial < 20; ++trial) {
            SliceJob job;
            QSignalSpy made(&job, &SliceJob::made);
            job.make(large);
            QTRY_COMPARE_WITH_TIMEOUT(made.size(), 1, test::kPatience);
            large.plane.originMm.z += 0.01;
            job.make(large);
        }
    }

    void theSameRequestIsAnsweredOnce() {
        SliceJob job;
        const auto volume = ramp();
        QSignalSpy made(&job, &SliceJob::made);
        job.make(requestOf(volume, 3));
        job.make(requestOf(volume, 3));
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 1, test::kPatience);
        job.make(requestOf(volume, 3));
        job.make(requestOf(volume, 4));
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 2, test::kPatience);
        QVERIFY(made[1][1].value<SlicePlane>() == requestOf(volume, 4).plane);
        job.drop();
        job.make(requestOf(volume, 4));  // the view may have been cleared since
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 3, test::kPatience);
    }

    /// A coarse request comes after one in full whenever another view moves.
    void aSliceThatIsShownInFullIsNotMadeCoarse() {
        SliceJob job;
        QSignalSpy made(&job, &SliceJob::made);
        SliceJob::Request request = requestOf(ramp(), 3);
        request.coarse = true;
        job.make(request);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 1, test::kPatience);
        QCOMPARE(made[0][0].value<QImage>().size(), QSize(20, 15));
        QVERIFY(made[0][1].value<SlicePlane>() == request.plane);
        request.coarse = false;
        job.make(request);
        QTRY_COMPARE_WITH_TIMEOUT(made.size(), 2, test::kPatience);
        QCOMPARE(made[1][0].value<QImage>(), SliceJob::madeNow(request));
        request.coarse = true;
        job.make(request);
        QVERIFY(!job.isRunning());
    }

    /// A pixel has the colour of the voxel on which it lies; other parts, and all that is in none, stay grey.
    void partsHaveTheirColours() {
        const auto volume = ramp();
        const auto map = test::labelled(*volume, 2, [](ivec3 at) { return at.x < 10 ? 1 : at.x < 20 ? 2 : 0; });
        SliceJob::Request request = requestOf(volume, 3);
        request.window = {0, 4000};
        request.plane.originMm.x -= 0.3;  // pixels lie between the centres of voxels
        const QImage grey = SliceJob::madeNow(request);
        request.tint = {map, {LabelColour{255, 0, 0}, std::nullopt}};
        const QImage tinted = SliceJob::madeNow(request);
        QCOMPARE(grey.size(), QSize(40, 30));
        for (int x = 0; x < 40; ++x) {
            const double along = request.plane.mmAt({x, 7}).x - volume->geometry().patientFromIndex[3].x;
            const QColor colour = tinted.pixelColor(x, 7);
            if (along < 9.4)
                QVERIFY2(colour.red() > colour.green() + 50, qPrintable(QString::number(x)));
            else if (along > 9.6)
                QCOMPARE(colour, grey.pixelColor(x, 7));
        }
    }

    void droppedVolumesAreReleased() {
        SliceJob job;
        auto volume = ramp();
        const std::weak_ptr<const Volume> held = volume;
        for (int slice = 0; slice < 5; ++slice)
            job.make(requestOf(volume, slice));
        volume.reset();
        job.drop();
        QTRY_VERIFY_WITH_TIMEOUT(held.expired(), test::kPatience);
    }
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::SliceJobTest)
#include "slice_job_test.moc"
