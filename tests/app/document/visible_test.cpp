/// Which part of the patient is shown: an edit of the look, whose mask is made beside the window.

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QImage>
#include <QSignalSpy>
#include <QTest>

#include "app/jobs/mask_job.h"
#include "dicom/write/export.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/desktop/told_document.h"
#include "tests/support/dicom/lying_patients.h"
#include "tests/support/program_run.h"
#include "tests/support/scenes/masks.h"
#include "ui/looks/visible_row.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

const Visible kLungs{{"lungs"}};
const Visible kPeeled{{}, {}, 7};

/// A document, and what it wanted masks of.
struct Wanting : Told {
    std::vector<Visible> wanted;
    std::shared_ptr<const Mask> mask = test::evenMask(*cube(), kSeen / 2);

    Wanting() {
        QObject::connect(&document, &Document::maskWanted,
                         [this](const std::shared_ptr<const segment::BodyParts>& parts, const Visible& visible) {
                             QCOMPARE(&parts->volume(), document.scene().volume.get());
                             wanted.push_back(visible);
                         });
    }
};

}  // namespace

class VisibleTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        const dicom::ExportFacts facts{"Phantom^Trunk", "TRUNK", "Test", "Trunk", "Made from formulas."};
        const auto patient = test::lying(test::trunk, {64, 48, 24}, dvec3(2.5));
        const auto written = dicom::writeSeries(*patient.volume, facts, ui::fromQt(series_), noProgress);
        QVERIFY2(written, written ? "" : written.error().text().c_str());
    }

    void theMaskComesAfterTheChoice() {
        Wanting told;
        told.document.setVisible(kLungs);
        QCOMPARE(told.wanted, std::vector<Visible>{kLungs});
        QVERIFY(told.document.scene().mask == nullptr && told.document.scene().visible == kLungs);
        QVERIFY(told.document.scene().maskAwaited);
        const std::uint64_t before = told.document.scene().revision;
        told.document.setMask(kLungs, told.mask);
        QVERIFY(told.document.scene().mask == told.mask && told.document.scene().revision > before);
        QVERIFY(!told.document.scene().maskAwaited);
        QVERIFY(told.document.scene().check());
        told.document.setVisible(kPeeled);
        QVERIFY(told.document.scene().mask == told.mask);  // until the new one is there
        QCOMPARE(told.wanted.size(), std::size_t(2));
    }

    void undoBringsBackTheMaskThatIsKnown() {
        Wanting told;
        told.document.setVisible(kLungs);
        told.document.setMask(kLungs, told.mask);
        told.document.undo();
        QVERIFY(told.document.scene().mask == nullptr && told.document.scene().visible.all());
        told.document.redo();
        QVERIFY(told.document.scene().mask == told.mask);
        QCOMPARE(told.wanted.size(), std::size_t(1));
    }

    void aMaskThatComesTooLateIsKeptButNotShown() {
        Wanting told;
        told.document.setVisible(kLungs);
        told.document.setVisible({});
        told.document.setMask(kLungs, told.mask);
        QVERIFY(told.document.scene().mask == nullptr);
        told.document.setVisible(kLungs);
        QVERIFY(told.document.scene().mask == told.mask);
    }

    void whatTheScanDoesNotHaveShowsAll() {
        Wanting told;
        told.document.setVisible(kLungs);
        told.document.setMask(kLungs, nullptr);
        QVERIFY(told.document.scene().mask == nullptr && told.document.setup().look.visible.all());
        QVERIFY(!told.document.canUndo() && told.document.look() == 0);
        told.document.setView(StandardView::left);
        QCOMPARE(told.wanted.size(), std::size_t(1));  // and it is not asked for again
        told.document.setVisible(kPeeled);
        told.document.setMask(kPeeled, told.mask);
        told.document.setVisible(kLungs);
        told.document.setMask(kPeeled, nullptr);  // not what is wanted any more
        QVERIFY(told.document.setup().look.visible == kLungs);
        told.document.setMask(kLungs, nullptr);
        QVERIFY(told.document.setup().look.visible.all());
        told.document.undo();
        QVERIFY(told.document.setup().look.visible == kPeeled && told.document.scene().mask == told.mask);
    }

    void withoutAMaskTheChoiceIsWhatIsSeen() {
        Wanting told;
        told.document.setVisible(kPeeled);
        told.document.setMask(kPeeled, told.mask);
        told.document.setVisible(kLungs);
        told.document.keepVisible();
        QVERIFY(told.document.setup().look.visible == kPeeled && told.document.scene().mask == told.mask);
        told.document.undo();  // the peeling
        QVERIFY(told.document.setup().look.visible.all() && !told.document.canUndo());
    }

    void anotherVolumeHasMasksOfItsOwn() {
        Wanting told;
        told.document.setVisible(kLungs);
        told.document.setMask(kLungs, told.mask);
        told.document.open(cube());
        QVERIFY(told.document.scene().mask == nullptr);
        QCOMPARE(told.wanted, (std::vector<Visible>{kLungs, kLungs}));
    }

    void theJobMakesMasksOrSaysWhyNot() {
        MaskJob job;
        QSignalSpy made(&job, &MaskJob::made), refused(&job, &MaskJob::refused);
        const auto body =
            std::make_shared<const segment::BodyParts>(test::makeVolume({40, 40, 20}, dvec3(2), [](int i, int j, int) {
                return std::hypot(i - 19.5, j - 19.5) < 17 ? 40 : -1000;
            }));
        job.make(body, kPeeled);
        QVERIFY(made.wait());
        QVERIFY(made[0][0].value<Visible>() == kPeeled);
        const auto mask = made[0][1].value<std::shared_ptr<const Mask>>();
        QVERIFY(mask->at({19.5, 19.5, 10}) == 1 && mask->at({3.5, 19.5, 10}) == 0);
        job.make(body, kLungs);
        QVERIFY(refused.wait());
        QVERIFY(refused[0][1].value<Error>().kind == ErrorKind::refused);
    }

    /// Peeling is computed off the window's thread, reported in the panel and in saved images, and is one step to undo.
    void theWindowPeelsAndSaysSo() {
        Trial trial;
        trial.openAndWait(series_);
        const Document& document = trial.desktop.document();
        ui::VisibleRow& row = test::the<ui::VisibleRow>(trial.desktop.window());
        auto* peel = row.findChild<QDoubleSpinBox*>();
        const auto says = [&row] {
            for (const QLabel* label : row.findChildren<QLabel*>())
                if (label->text().startsWith("Peeled 10 mm"))
                    return !label->isHidden();
            return false;
        };
        peel->setValue(10);
        QTRY_VERIFY_WITH_TIMEOUT(document.scene().mask != nullptr, test::kPatience);
        QVERIFY(says());
        trial.waitForNewest();
        trial.desktop.document().undo();
        QVERIFY(document.scene().mask == nullptr && peel->value() == 0 && !says());
        trial.desktop.document().redo();
        QVERIFY(document.scene().mask != nullptr && peel->value() == 10);
    }

    /// All is shown, and the window says why.
    void theWindowSaysWhatTheScanDoesNotHave() {
        Trial trial;
        trial.openAndWait(series_);
        auto* part = test::the<ui::VisibleRow>(trial.desktop.window()).findChild<QComboBox*>();
        part->setCurrentIndex(part->findText("Only the lungs"));
        emit part->activated(part->currentIndex());
        QTRY_VERIFY_WITH_TIMEOUT(trial.desktop.window().message().text().contains("150 ml"), test::kPatience);
        const Document& document = trial.desktop.document();
        QVERIFY(document.scene().mask == nullptr && document.scene().visible.all());
        QCOMPARE(part->currentText(), QString("Everything"));
        QVERIFY(!document.canUndo());
        trial.waitForNewest();
    }

    void theCommandLinePeelsAndRefuses() {
        const QString file = folder_.filePath("picture.png");
        const auto run = [&](const QStringList& more) {
            return test::runProgram(
                "pdrender-cli", QStringList{"render", series_, "-o", file, "--samples", "1", "--size", "32x32"} + more);
        };
        QCOMPARE(run({"--peel", "10"}).code, 0);
        QVERIFY(QImage(file).text("pdrender/notShown").startsWith("Peeled 10 mm"));
        QVERIFY(QImage(file).text("pdrender/effects").contains("hidden parts"));
        QCOMPARE(run({}).code, 0);
        QVERIFY(QImage(file).text("pdrender/notShown").isEmpty());
        QVERIFY(run({"--show", "lungs"}).err.contains("150 ml"));
        QVERIFY(run({"--show", "liver"}).err.contains("bones, lungs"));
        QVERIFY(run({"--hide", "lungs"}).err.contains("150 ml"));
        QVERIFY(run({"--peel", "51"}).code != 0);
    }

  private:
    QTemporaryDir folder_;
    QString series_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::VisibleTest)
#include "visible_test.moc"
