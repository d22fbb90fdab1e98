/// Slices of a series that is still being read, in the window.

#include <QAction>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include "app/presenters/series_presenter.h"
#include "app/presenters/slices_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/scenes/scenes.h"
#include "ui/text/to_qt.h"
#include "ui/view/viewport.h"

namespace pdr::app {
namespace {

constexpr QRgb kHatch = 0xff3a4256;

/// A ball of bone, and the same volume while it arrives.
struct Arrival {
    std::shared_ptr<const Volume> volume = test::makeVolume({32, 32, 40}, dvec3(2), [](int i, int j, int k) {
        return glm::distance(dvec3(i, j, k), dvec3(15.5, 15.5, 19.5)) < 12 ? 900 : -1000;
    });
    std::shared_ptr<ArrivingVolume> arriving = std::make_shared<ArrivingVolume>(volume->geometry());

    void slice(int k) const {
        constexpr std::size_t kSlice = 32 * 32;
        std::ranges::copy(volume->voxels().subspan(std::size_t(k) * kSlice, kSlice), arriving->slice(k).begin());
        arriving->arrive(k);
    }
    void slices(int first, int end) const {
        for (int k = first; k < end; ++k)
            slice(k);
    }
};

int hatched(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixel(x, y) == kHatch;
    return count;
}

}  // namespace

class ArrivingInWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        const Result<void> written = writePhantomSeries(ui::fromQt(series_));
        QVERIFY2(written, written ? "" : written.error().text().c_str());
    }
    void init() { trial_ = std::make_unique<Trial>(); }
    void cleanup() { trial_.reset(); }

    void whatHasArrivedIsShownAndTheRestIsHatched() {
        const Arrival arrival;
        showFourViews();
        document().arrive(arrival.arriving, {});
        arrival.slices(15, 25);
        awaitText("10 of 40 slices read");
        QCOMPARE(hatched(image(AnatomicalPlane::axial)), 0);
        QVERIFY(hatched(image(AnatomicalPlane::coronal)) > 100 && hatched(image(AnatomicalPlane::sagittal)) > 100);
        QVERIFY(!document().hasVolume());
        // Slices that are not there are no air, and may be scrolled to
        for (int i = 0; i < 12; ++i)
            QTest::keyClick(&view(AnatomicalPlane::axial), Qt::Key_Up);
        QTRY_VERIFY_WITH_TIMEOUT(hatched(image(AnatomicalPlane::axial)) > 100, test::kPatience);
        arrival.slices(25, 40);
        QTRY_COMPARE_WITH_TIMEOUT(hatched(image(AnatomicalPlane::axial)), 0, test::kPatience);
        arrival.slices(0, 15);
        QTRY_COMPARE_WITH_TIMEOUT(hatched(image(AnatomicalPlane::coronal)), 0, test::kPatience);
    }

    void theVolumeOpensWhereItsSlicesWereLookedAt() {
        const Arrival arrival;
        showFourViews();
        document().arrive(arrival.arriving, {40, 80});
        arrival.slices(0, 40);
        awaitText("40 of 40 slices read");
        QTest::keyClick(&view(AnatomicalPlane::axial), Qt::Key_PageUp);
        QTest::keyClick(&view(AnatomicalPlane::axial), Qt::Key_4);
        const Navigation seen = document().plan().navigation;
        QVERIFY(seen.window != (GreyWindow{40, 80}));
        arrival.arriving->take();
        segment::HiddenTable table;
        table.bodyBox = arrival.volume->geometry().part({8, 8, 8}, {12, 12, 12});
        document().open(arrival.volume, table, {}, {}, {40, 80});
        QVERIFY(view(AnatomicalPlane::axial).slice());  // what was seen stays until it is replaced
        QCOMPARE(document().plan().navigation, seen);
        QVERIFY(!document().canUndo());
        QTRY_VERIFY_WITH_TIMEOUT(!texts().contains("slices read"), test::kPatience);
        QTest::keyClick(&view(AnatomicalPlane::axial), Qt::Key_9);
        QCOMPARE(document().plan().navigation.window, (GreyWindow{40, 80}));
    }

    /// If nobody looks at slices, they begin where the body is.
    void unseenSlicesBeginInTheBody() {
        const Arrival arrival;
        document().arrive(arrival.arriving, {});
        arrival.slices(0, 40);
        arrival.arriving->take();
        segment::HiddenTable table;
        table.bodyBox = arrival.volume->geometry().part({8, 8, 8}, {12, 12, 12});
        document().open(arrival.volume, table);
        QCOMPARE(document().plan().navigation.crosshairMm, table.bodyBox.centreMm());
    }

    void aSliceStandsInForAnImageThatWillTakeLong() {
        const Arrival arrival;
        document().arrive(arrival.arriving, {});
        arrival.slice(20);
        QTRY_VERIFY_WITH_TIMEOUT(view(AnatomicalPlane::axial).isVisible(), test::kPatience);
        QVERIFY(!window().viewport().isVisible());
        awaitText("1 of 40 slices read");
        arrival.slices(0, 20);
        arrival.slices(21, 40);
        arrival.arriving->take();
        document().open(arrival.volume);
        QVERIFY(!view(AnatomicalPlane::axial).isVisible() && window().viewport().isVisible());
        QTRY_VERIFY_WITH_TIMEOUT(!trial_->frames.empty(), test::kPatience);
        trial_->waitForNewest();
    }

    void nothingCanBeMeasuredYet() {
        const Arrival arrival;
        showFourViews();
        document().arrive(arrival.arriving, {});
        arrival.slices(0, 40);
        awaitText("40 of 40 slices read");
        QVERIFY(!window().findChild<QAction*>("distance")->isEnabled());
        ui::SliceView& axial = view(AnatomicalPlane::axial);
        emit axial.menuRequested({10, 10});
        QVERIFY(!axial.findChild<QMenu*>("sliceMenu"));
        QTest::mouseClick(&axial, Qt::LeftButton, {}, axial.rect().center() + QPoint(9, 4));
        QVERIFY(document().plan().measurements.empty() && !document().canUndo());
    }

    void whatWasShownGoesWithASentenceIfReadingEnds() {
        const Arrival arrival;
        showFourViews();
        document().arrive(arrival.arriving, {});
        arrival.slices(0, 30);
        awaitText("30 of 40 slices read");
        auto& presenter = trial_->desktop.presenter<SeriesPresenter>();
        presenter.open(series_);
        QVERIFY(presenter.cancelJob());
        QVERIFY(!document().arriving());
        QVERIFY(!view(AnatomicalPlane::axial).slice());
        QStringList said;
        for (const QLabel* label : window().findChildren<QLabel*>())
            said << label->text();
        QVERIFY2(said.join('\n').contains("not read to its end"), qPrintable(said.join('\n')));
    }

    /// All of it: a folder is read, and its slices pass through the window.
    void aSeriesThatWasSeenWhileItArrivedOpens() {
        showFourViews();
        QSignalSpy arriving(&trial_->desktop.presenter<SeriesPresenter>().import(), &ImportJob::arriving);
        trial_->openAndWait(series_);
        QCOMPARE(arriving.size(), 1);
        QVERIFY(!document().arriving());
        QTRY_VERIFY_WITH_TIMEOUT(view(AnatomicalPlane::axial).slice(), test::kPatience);
        QTRY_VERIFY_WITH_TIMEOUT(!texts().contains("slices read"), test::kPatience);
    }

  private:
    Document& document() const { return trial_->desktop.document(); }
    ui::MainWindow& window() const { return trial_->desktop.window(); }
    ui::SliceView& view(AnatomicalPlane plane) const {
        return trial_->desktop.presenter<SlicesPresenter>().view(plane);
    }
    QImage image(AnatomicalPlane plane) const { return view(plane).slice() ? view(plane).slice()->image : QImage(); }
    QString texts() const {
        const auto& slice = view(AnatomicalPlane::axial).slice();
        return slice ? slice->texts.join('\n') : QString();
    }
    void awaitText(const char* text) const {
        for (const AnatomicalPlane plane : kAnatomicalPlanes)
            if (view(plane).isVisible())
                QTRY_VERIFY_WITH_TIMEOUT(view(plane).slice() && view(plane).slice()->texts.join('\n').contains(text),
                                         test::kPatience);
    }
    void showFourViews() const {
        Navigation navigation = document().plan().navigation;
        navigation.layout = ViewLayout::quarters;
        document().navigate(navigation);
    }

    QTemporaryDir folder_;
    QString series_;
    std::unique_ptr<Trial> trial_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::ArrivingInWindowTest)
#include "arriving_in_window_test.moc"
