/// Slices beside the image: from a key to three slices that agree on one place, while the image goes on.

#include <QDeadlineTimer>
#include <QMenu>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include "app/presenters/crosshair_presenter.h"
#include "app/presenters/slices_presenter.h"
#include "render/scene/edit/view_geometry.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class SlicesInWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        trial_ = std::make_unique<Trial>();
        trial_->openAndWait(series_);
    }
    void cleanupTestCase() { trial_.reset(); }

    void oneKeyShowsThreeSlicesAndTheImageStays() {
        const std::uint64_t revision = document().scene().revision;
        QTest::keyClick(&trial_->desktop.window(), Qt::Key_L);
        for (const AnatomicalPlane plane : kAnatomicalPlanes) {
            QVERIFY(view(plane).isVisible());
            QTRY_VERIFY_WITH_TIMEOUT(view(plane).slice(), test::kPatience);
            QTRY_VERIFY_WITH_TIMEOUT(view(plane).slice()->plane.size == view(plane).sizeInPixels(), test::kPatience);
            QVERIFY(holdsCrosshair(plane));
        }
        QCOMPARE(document().scene().revision, revision);
    }

    void aClickMovesTheOtherSlicesAndUndoBringsThemBack() {
        const dvec3 before = crosshair();
        const std::uint64_t revision = document().scene().revision;
        const std::uint64_t samples = trial_->frames.back()->status.samplesPerPixel;
        ui::SliceView& axial = view(AnatomicalPlane::axial);
        const QPoint place(axial.width() / 3, axial.height() / 2);
        const SlicePlane shown = axial.slice()->plane;
        const dvec2 pixel = dvec2(place.x(), place.y()) * axial.devicePixelRatioF() - 0.5;
        QTest::mouseClick(&axial, Qt::LeftButton, {}, place);
        QVERIFY(glm::length(crosshair() - shown.mmAt(pixel)) < 1e-9);
        for (const AnatomicalPlane plane : kAnatomicalPlanes)
            QTRY_VERIFY_WITH_TIMEOUT(holdsCrosshair(plane), test::kPatience);
        QTest::keyClick(&axial, Qt::Key_Up);
        QTest::keyClick(&axial, Qt::Key_4);
        QCOMPARE(document().undoText(), Text("Undo moving through the slices"));
        document().undo();  // all of it is one step
        QCOMPARE(crosshair(), before);
        QVERIFY(!document().canUndo());
        QCOMPARE(document().scene().revision, revision);  // the image went on
        QTRY_VERIFY_WITH_TIMEOUT(trial_->frames.back()->status.samplesPerPixel > samples, test::kPatience);
    }

    /// Each pixel of the slice is what the renderer meets at its place.
    void theWheelScrollsToVoxelCentres() {
        ui::SliceView& axial = view(AnatomicalPlane::axial);
        const QPointF middle = QPointF(axial.rect().center());
        QWheelEvent event(middle, axial.mapToGlobal(middle), {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&axial, &event);
        const VolumeGeometry& geometry = document().seen()->geometry();
        const double k = (glm::inverse(geometry.patientFromIndex) * dvec4(crosshair(), 1)).z;
        QVERIFY(std::abs(k - std::round(k)) < 1e-9);
        QTRY_VERIFY_WITH_TIMEOUT(holdsCrosshair(AnatomicalPlane::axial), test::kPatience);
    }

    void windowsAreChosenByDigits() {
        QTest::keyClick(&view(AnatomicalPlane::coronal), Qt::Key_5);
        QCOMPARE(document().plan().navigation.window, (GreyWindow{-600, 1500}));
        QTest::keyClick(&view(AnatomicalPlane::coronal), Qt::Key_0);
        QVERIFY(document().plan().navigation.window.width > 100);
        QTest::keyClick(&view(AnatomicalPlane::coronal), Qt::Key_9);
        QCOMPARE(document().plan().navigation.window, GreyWindow());  // the files ask for none
    }

    /// The place is the one that the image shows there, and the image goes on.
    void aClickOnTheImageMovesTheSlices() {
        ui::Viewport& viewport = trial_->desktop.window().viewport();
        const std::uint64_t revision = document().scene().revision;
        const dvec3 before = crosshair();
        const QPoint middle = viewport.rect().center();
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, middle);
        QTRY_VERIFY_WITH_TIMEOUT(crosshair() != before, test::kPatience);
        const Camera& camera = trial_->frames.back()->camera;
        const ivec2 size = trial_->frames.back()->size;
        const auto at = ViewGeometry(camera, double(size.x) / size.y).at(crosshair());
        const double pixel = 1.0 / viewport.height();
        QVERIFY(at && std::abs(at->y - 0.5) < 1.5 * pixel);
        QCOMPARE(document().scene().revision, revision);
        ui::CrosshairLayer& layer = trial_->desktop.presenter<CrosshairPresenter>().layer();
        QVERIFY(layer.place() == crosshair());
        QTRY_VERIFY_WITH_TIMEOUT(layer.inFront() == ui::InFront::little, test::kPatience);  // it is what is seen
    }

    void whatLiesBehindTheSkullIsSaidToBeHidden() {
        ui::CrosshairLayer& layer = trial_->desktop.presenter<CrosshairPresenter>().layer();
        Navigation navigation = document().plan().navigation;
        navigation.crosshairMm = document().bodyBox().centreMm();
        document().navigate(navigation);
        QVERIFY(layer.inFront() == ui::InFront::unknown);
        QTRY_VERIFY_WITH_TIMEOUT(layer.inFront() == ui::InFront::cut, test::kPatience);  // the look shows bones alone
        document().chooseLook(int(document().looks().fitted().size()) - 1);
        QTRY_VERIFY_WITH_TIMEOUT(layer.inFront() == ui::InFront::tissue, test::kPatience);  // behind the skin
        document().undo();
        trial_->waitForNewest();
    }

    /// A radiograph shows no place, and a sentence says so.
    void aClickThatShowsNoPlaceMovesNothing() {
        const dvec3 before = crosshair();
        document().setModel(Model::absorption);
        trial_->waitForNewest();
        ui::Viewport& viewport = trial_->desktop.window().viewport();
        QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.rect().center());
        const QString says = trial_->desktop.window().status().text();
        QTRY_VERIFY_WITH_TIMEOUT(trial_->desktop.window().status().text() != says, test::kPatience);
        QCOMPARE(crosshair(), before);
        document().undo();
        trial_->waitForNewest();
    }

    /// What follows a step at once is a move. Its large slices are coarse, and full soon after: in the same bits as one
    /// that was made at rest. A single step, and what is copied, is always full.
    void largeSlicesAreCoarseOnlyWhileTheyMove() {
        ui::SliceView& axial = view(AnatomicalPlane::axial);
        trial_->desktop.window().resize(1500, 1000);
        trial_->desktop.window().views().toggleAlone(&axial);
        QTRY_VERIFY_WITH_TIMEOUT(isFull(axial), test::kPatience);
        QVERIFY(axial.sizeInPixels().x * axial.sizeInPixels().y > 1024 * 768);
        const auto move = [&] {
            QDeadlineTimer patience(test::kPatience);
            for (int i = 0; !axial.slice()->isCoarse() && !patience.hasExpired(); ++i) {
                QTest::keyClick(&axial, i % 2 ? Qt::Key_Down : Qt::Key_Up);
                QTest::qWait(5);
            }
            QVERIFY(axial.slice()->isCoarse());
            QVERIFY(axial.slice()->plane.size == axial.sizeInPixels());
        };
        RenderBridge& bridge = trial_->desktop.bridge();
        QVERIFY(!bridge.isYielding());
        move();
        QVERIFY(bridge.isYielding() && !bridge.paused());
        QTRY_VERIFY_WITH_TIMEOUT(isFull(axial), test::kPatience);
        QVERIFY(!bridge.isYielding());
        const SlicePlane plane = axial.slice()->plane;
        QVERIFY(axial.slice()->image ==
                SliceJob::madeNow({document().seen(), plane, document().plan().navigation.window}));
        QTest::keyClick(&axial, Qt::Key_Up);
        QTRY_VERIFY_WITH_TIMEOUT(holdsCrosshair(AnatomicalPlane::axial), test::kPatience);
        QVERIFY(!axial.slice()->isCoarse());
        move();
        emit axial.menuRequested({10, 10});
        auto* menu = axial.findChild<QMenu*>("sliceMenu");
        menu->actions().last()->trigger();
        QVERIFY(!axial.slice()->isCoarse());
        menu->close();
        trial_->desktop.window().views().toggleAlone(&axial);
    }

    /// The second series waits until all have let go of the first.
    void anotherSeriesHasItsOwnSlices() {
        const QImage before = view(AnatomicalPlane::axial).slice()->image;
        QVERIFY(!document().plan().navigation.framings[0].panMm.x);
        trial_->frames.clear();
        trial_->openAndWait(series_);
        QTRY_VERIFY_WITH_TIMEOUT(view(AnatomicalPlane::axial).slice(), test::kPatience);
        // Where the body is; but if a slice was on the screen while others were read, it did not move
        const double fromBody = glm::length(crosshair() - document().bodyBox().centreMm());
        const double fromScan = glm::length(crosshair() - document().scan()->geometry().centreMm());
        QVERIFY(std::min(fromBody, fromScan) < 1e-9);
    }

    void closingClearsTheSlices() {
        document().close();
        for (const AnatomicalPlane plane : kAnatomicalPlanes)
            QVERIFY(!view(plane).slice());
        QTest::keyClick(&view(AnatomicalPlane::axial), Qt::Key_0);  // and nothing happens
        QTest::keyClick(&view(AnatomicalPlane::axial), Qt::Key_Up);
    }

  private:
    Document& document() { return trial_->desktop.document(); }
    dvec3 crosshair() { return document().plan().navigation.crosshairMm; }
    ui::SliceView& view(AnatomicalPlane plane) { return trial_->desktop.presenter<SlicesPresenter>().view(plane); }
    static bool isFull(const ui::SliceView& view) {
        return view.slice() && view.slice()->plane.size == view.sizeInPixels() && !view.slice()->isCoarse();
    }
    bool holdsCrosshair(AnatomicalPlane plane) {
        return std::abs(view(plane).slice()->plane.depthMm(crosshair())) < 1e-9;
    }

    QTemporaryDir folder_;
    QString series_;
    std::unique_ptr<Trial> trial_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::SlicesInWindowTest)
#include "slices_in_window_test.moc"
