/// A scan whose values are no HU in the window: it is shown, and nothing says or needs HU.

#include <QAction>
#include <QCheckBox>
#include <QMenu>
#include <QTemporaryDir>
#include <QTest>

#include "app/presenters/slices_presenter.h"
#include "dicom/write/export.h"
#include "render/volume/value_unit.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/scenes/scenes.h"
#include "ui/looks/look_panel.h"
#include "ui/text/to_qt.h"
#include "ui/tissue/tissue_panel.h"

namespace pdr::app {

class ValuesInWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        const auto ball = test::makeVolume({24, 24, 24}, dvec3(4), [](int i, int j, int k) {
            return glm::distance(dvec3(i, j, k), dvec3(11.5)) < 8 ? 900 : 20 + (i + j + k) % 7;
        });
        const Volume volume(ball->geometry(), Voxels(ball->voxels().begin(), ball->voxels().end()), {},
                            unitWord(ValueUnit::other("", 0.5, 0)));
        series_ = folder_.filePath("series");
        const dicom::ExportFacts facts{"Phantom^Ball", "BALL", "Test", "Ball", "Made from formulas."};
        const auto written = dicom::writeSeries(volume, facts, ui::fromQt(series_), noProgress);
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        trial_ = std::make_unique<Trial>();
        trial_->openAndWait(series_);
    }
    void cleanupTestCase() { trial_.reset(); }

    void itIsShownAndSaidThatItIsNoHu() {
        QVERIFY(document().hasVolume());
        QCOMPARE(unitOf(*document().seen()), ValueUnit::other("", 0.5, 0));
        const QString said = window().message().text();
        QVERIFY2(said.contains("do not say that the values are HU"), qPrintable(said));
        QVERIFY(!document().looks().areInHu());
        QCOMPARE(document().setup().lookName, std::string("Bright values, solid"));
    }

    void slicesShowValuesWithoutHu() {
        trial_->desktop.presenter<SlicesPresenter>().showSlices();
        ui::SliceView& view = trial_->desktop.presenter<SlicesPresenter>().view(AnatomicalPlane::axial);
        QTRY_VERIFY_WITH_TIMEOUT(view.slice(), test::kPatience);
        const QString texts = view.slice()->texts.join(' ');
        QVERIFY2(texts.contains("(no unit)") && !texts.contains("HU"), qPrintable(texts));
        // The whole range: from 10 to 450
        const GreyWindow shown = document().plan().navigation.window;
        QVERIFY(std::abs(shown.centre - 460) < 10 && std::abs(shown.width - 880) < 20);
        QTest::keyClick(&view, Qt::Key_4);
        QCOMPARE(document().plan().navigation.window, shown);  // bone is a window in HU
    }

    void windowsForTissuesAreNotOffered() {
        int offered = 0, reasons = 0;
        for (const QMenu* menu : window().findChildren<QMenu*>())
            for (const QAction* entry : menu->actions()) {
                offered += entry->isVisible() && entry->text().contains("Bone\t");
                reasons += entry->isVisible() && entry->text().contains("no HU");
            }
        QCOMPARE(offered, 0);
        QVERIFY(reasons >= 1);
    }

    void theTissuePanelCountsInValues() {
        const auto* panel = window().findChild<ui::TissuePanel*>();
        QVERIFY(panel);
        for (const QWidget* part : panel->findChildren<QWidget*>())
            for (const QString& text : {part->accessibleName(), part->accessibleDescription()})
                QVERIFY2(!text.contains("HU") && !text.contains("Hounsfield"), qPrintable(text));
    }

    void theirNoiseIsNotTakenOff() {
        QVERIFY(!window().findChild<ui::LookPanel*>()->findChild<QCheckBox*>()->isEnabled());
    }

    /// A plan or a look may want it: that is refused with the reason, and is no step to undo.
    void whoWantsThatIsTold() {
        const Text undo = document().undoText();
        document().setCtDenoised(true);
        QTRY_VERIFY_WITH_TIMEOUT(!document().setup().look.ctDenoised, test::kPatience);
        QVERIFY2(window().message().text().contains("only values in HU can be denoised", Qt::CaseInsensitive),
                 qPrintable(window().message().text()));
        QVERIFY(document().undoText() == undo && !document().scene().ctDenoised);
        QVERIFY(document().scene().volume == document().seen());
    }

    void aLookIsNotKept() {
        const auto before = document().looks().drawn().size();
        emit window().findChild<ui::LookPanel*>()->menu().saveWanted("Mine");
        QCOMPARE(document().looks().drawn().size(), before);
        QVERIFY(window().message().text().contains("no HU"));
    }

  private:
    Document& document() { return trial_->desktop.document(); }
    ui::MainWindow& window() { return trial_->desktop.window(); }

    QTemporaryDir folder_;
    QString series_;
    std::unique_ptr<Trial> trial_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::ValuesInWindowTest)
#include "values_in_window_test.moc"
