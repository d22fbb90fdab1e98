/// Recovery in the window: after a run that ended without notice, its plan is back when its scan is opened.

#include <QDir>
#include <QLocale>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include "app/presenters/plan_presenter.h"
#include "app/presenters/recovery_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/phantom_series.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

void measureIn(Document& document) {
    Plan plan = document.plan();
    plan.measurements.push_back({plan.measurements.size() + 1,
                                 MeasureKind::distance,
                                 "defect",
                                 {measure::typedPlace({1, 2, 3}), measure::typedPlace({4, 6, 3})}});
    document.edit(plan);
}

QStringList filesIn(const QString& folder) {
    return QDir(folder).entryList({"*.plan.json"}, QDir::Files);
}

/// Copies what a run has kept to where another one looks: what a run that is killed leaves.
void leaveBehind(const QString& from, const QString& to) {
    QVERIFY(QDir().mkpath(to));
    for (const QString& file : filesIn(from))
        QVERIFY(QFile::copy(from + '/' + file, to + '/' + file));
}

}  // namespace

class RecoveryInWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        left_ = folder_.filePath("left");
        const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
        QVERIFY2(written, written ? "" : written.error().text().c_str());
    }

    void whatIsDoneIsKeptUntilItIsSafe() {
        Trial trial;
        const QString plans = trial.folder.filePath("plans");
        trial.openAndWait(series_);
        auto& autosave = trial.desktop.presenter<RecoveryPresenter>().autosave();
        QSignalSpy kept(&autosave, &AutosaveJob::kept);
        measureIn(trial.desktop.document());
        QTRY_COMPARE_WITH_TIMEOUT(kept.size(), 1, test::kPatience);
        QCOMPARE(filesIn(plans).size(), 1);
        leaveBehind(plans, left_);
        // Undone: nothing would be lost
        trial.desktop.document().undo();
        QTRY_VERIFY_WITH_TIMEOUT(filesIn(plans).isEmpty(), test::kPatience);
        // Moved through the slices: as if nothing had been done
        trial.desktop.document().moveCrosshair({1, 2, 3});
        QTest::qWait(1300);
        QVERIFY(filesIn(plans).isEmpty());
        trial.desktop.document().undo();
        // Saved: a file of the user holds it
        measureIn(trial.desktop.document());
        QTRY_COMPARE_WITH_TIMEOUT(filesIn(plans).size(), 1, test::kPatience);
        trial.desktop.presenter<PlanPresenter>().save(folder_.filePath("mine"));
        QTRY_VERIFY_WITH_TIMEOUT(filesIn(plans).isEmpty(), test::kPatience);
        // Edited again
        measureIn(trial.desktop.document());
        QTRY_COMPARE_WITH_TIMEOUT(filesIn(plans).size(), 1, test::kPatience);
    }

    void itComesBackWithItsScan() {
        Trial trial;
        const QString plans = trial.folder.filePath("plans");
        leaveBehind(left_, plans);
        Document& document = trial.desktop.document();
        bool isOnlyInMemory = false;
        connect(&document, &Document::changed, this, [&] {
            isOnlyInMemory = isOnlyInMemory || (!document.plan().measurements.empty() && filesIn(plans).isEmpty());
        });
        trial.openAndWait(series_);
        QTRY_COMPARE_WITH_TIMEOUT(document.plan().measurements.size(), std::size_t(1), test::kPatience);
        QVERIFY(!isOnlyInMemory);
        QCOMPARE(document.plan().measurements[0].name, std::string("defect"));
        const ui::MainWindow& window = trial.desktop.window();
        QVERIFY2(const_cast<ui::MainWindow&>(window).message().text().contains("has been restored"),
                 qPrintable(const_cast<ui::MainWindow&>(window).message().text()));
        // This run keeps it now, in place of what was left
        QTRY_VERIFY_WITH_TIMEOUT(filesIn(plans).size() == 1 && filesIn(plans) != filesIn(left_), test::kPatience);
        document.undo();
        QVERIFY(document.plan().measurements.empty() && !document.canUndo());
    }

    void theWindowSaysWhatWasLeftAndDeletesItOnRequest() {
        QTemporaryDir folder;
        leaveBehind(left_, folder.filePath("plans"));
        Desktop desktop(*bundledLooks(), makeCpuDevice(1), folder.filePath("settings.ini"), 1);
        ui::MessageBar& message = desktop.window().message();
        QTRY_VERIFY_WITH_TIMEOUT(message.text().contains("1 measurement"), test::kPatience);
        for (QPushButton* button : message.findChildren<QPushButton*>())
            if (button->text() == "Delete it")
                button->click();
        QVERIFY(filesIn(folder.filePath("plans")).isEmpty());
        QVERIFY(message.isHidden());
    }

    void anotherScanBringsNothingBack() {
        const QString other = folder_.filePath("other");
        const Volume head = headPhantom({64, 57, 64}, {3.9, 4.9, 3.8});
        QVERIFY(
            dicom::writeSeries(head, {"Phantom^Two", "TWO", "Test", "Two", "Made."}, ui::fromQt(other), noProgress));
        Trial trial;
        leaveBehind(left_, trial.folder.filePath("plans"));
        trial.openAndWait(other);
        QTRY_VERIFY_WITH_TIMEOUT(!trial.desktop.presenter<RecoveryPresenter>().recovery().isRunning(), test::kPatience);
        QVERIFY(trial.desktop.document().plan().measurements.empty());
        QCOMPARE(filesIn(trial.folder.filePath("plans")), filesIn(left_));
    }

    void whereNothingCanBeKeptItIsSaidOnce() {
        Trial trial;
        QFile inTheWay(trial.folder.filePath("plans"));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        trial.openAndWait(series_);
        auto& autosave = trial.desktop.presenter<RecoveryPresenter>().autosave();
        QSignalSpy failed(&autosave, &AutosaveJob::failed);
        ui::MessageBar& message = trial.desktop.window().message();
        measureIn(trial.desktop.document());
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, test::kPatience);
        QVERIFY2(message.text().contains("save the plan yourself"), qPrintable(message.text()));
        message.clear();
        measureIn(trial.desktop.document());
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 2, test::kPatience);
        QVERIFY(message.isHidden());
    }

  private:
    QTemporaryDir folder_;
    QString series_, left_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::RecoveryInWindowTest)
#include "recovery_in_window_test.moc"
