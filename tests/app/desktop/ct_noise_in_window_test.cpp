/// The CT with less noise in the window: an edit of the look, whose volume is made beside it. Only the image shows it.

#include <QCheckBox>
#include <QSignalSpy>
#include <QTest>
#include <random>

#include "app/presenters/ct_noise_presenter.h"
#include "dicom/write/export.h"
#include "render/smooth/non_local_means.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/desktop/told_document.h"
#include "tests/support/scenes/scenes.h"
#include "ui/looks/look_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

/// A document, and the scans that it wanted with less noise.
struct Wanting : Told {
    std::vector<std::shared_ptr<const Volume>> wanted;
    std::shared_ptr<const Volume> denoised = std::make_shared<const Volume>(*ctDenoised(*document.scan(), noProgress));

    Wanting() {
        QObject::connect(&document, &Document::denoisedCtWanted,
                         [this](const std::shared_ptr<const Volume>& scan) { wanted.push_back(scan); });
    }
};

/// A ball of tissue with noise of 30 HU.
std::shared_ptr<const Volume> noisyBall() {
    std::mt19937 random(7);
    return test::makeVolume({48, 48, 24}, dvec3(3), [&](int i, int j, int k) {
        const int noise = int(random() % 104) - 52;
        return (std::hypot(i - 23.5, j - 23.5, 2 * k - 23.5) < 20 ? 60 : -940) + noise;
    });
}

QCheckBox& box(Trial& trial) {
    return *test::the<ui::LookPanel>(trial.desktop.window()).findChild<QCheckBox*>();
}

}  // namespace

class CtNoiseInWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        const dicom::ExportFacts facts{"Phantom^Ball", "BALL", "Test", "Ball", "Made from formulas."};
        const auto written = dicom::writeSeries(*noisyBall(), facts, ui::fromQt(series_), noProgress);
        QVERIFY2(written, written ? "" : written.error().text().c_str());
    }

    /// Slices and measurements read what is seen, which stays the scan.
    void onlyTheSceneTakesIt() {
        Wanting told;
        Document& document = told.document;
        const std::shared_ptr<const Volume> scan = document.seen();
        document.setCtDenoised(true);
        QCOMPARE(told.wanted, std::vector{scan});
        QVERIFY(document.scene().volume == scan && document.scene().ctDenoised);
        document.takeDenoisedCt(scan, told.denoised);
        QVERIFY(document.scene().volume == told.denoised && document.scene().check());
        QVERIFY(document.seen() == scan && document.scan() == scan);
        QCOMPARE(&document.parts()->volume(), scan.get());
    }

    void undoAndRedoShowWhatIsKnown() {
        Wanting told;
        Document& document = told.document;
        const std::shared_ptr<const Volume> scan = document.seen();
        document.setCtDenoised(true);
        document.takeDenoisedCt(scan, told.denoised);
        QCOMPARE(document.undoText(), Text(phrase("Undo switching CT denoising")));
        document.undo();
        QVERIFY(document.scene().volume == scan && !document.canUndo());
        document.redo();
        QVERIFY(document.scene().volume == told.denoised);
        QCOMPARE(told.wanted.size(), std::size_t(1));
        document.open(cube());  // another scan, which the look wants with less noise, too
        QVERIFY(document.scene().volume == document.seen());
        QCOMPARE(told.wanted.size(), std::size_t(2));
        told.scenes.clear();
        QCOMPARE(told.denoised.use_count(), 1L);  // the one before is not held any longer
    }

    void withoutItTheSwitchIsOff() {
        Wanting told;
        told.document.setCtDenoised(true);
        told.document.keepNoise();
        QVERIFY(!told.document.setup().look.ctDenoised && !told.document.scene().ctDenoised);
        QVERIFY(!told.document.canUndo() && told.document.look() == 0);
        told.document.takeDenoisedCt(told.document.seen(), told.denoised);  // it comes too late
        QVERIFY(told.document.scene().volume == told.document.seen());
    }

    void theWindowDenoisesAndSaysSo() {
        Trial trial;
        trial.openAndWait(series_);
        Document& document = trial.desktop.document();
        const std::shared_ptr<const Volume> scan = document.seen();
        QVERIFY(box(trial).isEnabled() && !box(trial).isChecked());
        box(trial).click();
        QTRY_VERIFY_WITH_TIMEOUT(document.scene().volume != scan, test::kPatience);
        QVERIFY(isCtDenoised(*document.scene().volume) && document.seen() == scan);
        QVERIFY(document.scene().volume->voxels().size() == scan->voxels().size());
        trial.waitForNewest();
        QVERIFY(trial.frames.back()->ctDenoised);
        document.undo();
        QVERIFY(document.scene().volume == scan && !box(trial).isChecked());
        trial.waitForNewest();
        QVERIFY(!trial.frames.back()->ctDenoised);
    }

    /// Esc ends it: all is as it was, and there is no step to undo.
    void escLeavesTheScanAsItIs() {
        Trial trial;
        trial.openAndWait(series_);
        Document& document = trial.desktop.document();
        const CtNoiseJob& job = trial.desktop.presenter<CtNoisePresenter>().job();
        QSignalSpy made(&job, &CtNoiseJob::made);
        box(trial).click();
        QVERIFY(job.isRunning() && box(trial).isChecked());  // what it makes is taken by the event loop
        QTest::keyClick(&trial.desktop.window(), Qt::Key_Escape);
        QVERIFY(!job.isRunning() && !box(trial).isChecked() && made.isEmpty());
        QVERIFY(!document.scene().ctDenoised && document.scene().volume == document.seen());
        QVERIFY(!document.canUndo() && document.look() >= 0);
        trial.waitForNewest();
        QVERIFY(!trial.frames.back()->ctDenoised);
        box(trial).click();  // and it may be asked for again
        QTRY_COMPARE_WITH_TIMEOUT(made.count(), 1, test::kPatience);
        QVERIFY(isCtDenoised(*document.scene().volume));
    }

    void theNewestScanIsMade() {
        CtNoiseJob job;
        QSignalSpy made(&job, &CtNoiseJob::made), finished(&job, &CtNoiseJob::finished);
        const auto scan = noisyBall();
        job.reduce(scan);
        job.reduce(scan);
        QVERIFY(made.wait());
        QCOMPARE(made[0][0].value<std::shared_ptr<const Volume>>(), scan);
        QVERIFY(isCtDenoised(*made[0][1].value<std::shared_ptr<const Volume>>()));
        const auto other = noisyBall();
        job.reduce(scan);
        job.reduce(other);
        QVERIFY(made.wait());
        QCOMPARE(made[1][0].value<std::shared_ptr<const Volume>>(), other);
        job.reduce(scan);
        job.cancel();
        QVERIFY(!job.isRunning() && made.count() == 2 && finished.count() == 3);
    }

  private:
    QTemporaryDir folder_;
    QString series_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::CtNoiseInWindowTest)
#include "ct_noise_in_window_test.moc"
