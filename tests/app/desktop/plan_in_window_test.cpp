/// Plans in the window: what was measured is there again after the window was closed, on its scan alone, and is not
/// lost without a question.

#include <QMessageBox>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QTreeWidget>

#include "app/presenters/marks_presenter.h"
#include "app/presenters/plan_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/text/to_qt.h"

namespace pdr::app {
namespace {

Measurement someDistance() {
    return {42, MeasureKind::distance, "defect", {measure::typedPlace({1, 2, 3}), measure::typedPlace({4, 6, 3})}};
}

void measureIn(Document& document) {
    Plan plan = document.plan();
    plan.measurements.push_back(someDistance());
    plan.navigation.crosshairMm = {1, 2, 3};
    document.edit(plan);
}

void press(Trial& trial, const char* action) {
    trial.desktop.window().findChild<QAction*>(action)->trigger();
}

/// Answers the next question, and counts it.
struct Answer {
    int asked = 0;
    QTimer timer;

    explicit Answer(QMessageBox::StandardButton button) {
        QObject::connect(&timer, &QTimer::timeout, [this, button] {
            if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
                ++asked;
                box->button(button)->click();
            }
        });
        timer.start(20);
    }
};

}  // namespace

class PlanInWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        file_ = folder_.filePath("head.plan.json");
        const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
        QVERIFY2(written, written ? "" : written.error().text().c_str());
    }

    void itIsStillThereTomorrow() {
        Plan saved;
        {
            Trial evening;
            evening.openAndWait(series_);
            measureIn(evening.desktop.document());
            evening.desktop.document().setView(StandardView::left);
            press(evening, "nextLayout");
            saved = evening.desktop.document().plan();
            auto& plans = evening.desktop.presenter<PlanPresenter>();
            QSignalSpy done(&plans.job(), &PlanJob::saved);
            plans.save(file_);
            QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, test::kPatience);
            QVERIFY(evening.desktop.window().confirmsLoss());  // nothing to ask
        }
        Trial morning;
        morning.openAndWait(series_);
        Document& document = morning.desktop.document();
        auto& plans = morning.desktop.presenter<PlanPresenter>();
        QSignalSpy done(&plans.job(), &PlanJob::opened);
        plans.open(file_);
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, test::kPatience);
        QCOMPARE(planText({{}, document.plan()}), planText({{}, saved}));
        QVERIFY(document.plan().measurements == saved.measurements && document.plan().navigation == saved.navigation);
        const ui::ViewGrid& views = morning.desktop.window().views();
        QVERIFY(saved.navigation.layout == ViewLayout::beside && views.layout() == ViewLayout::beside);
        QVERIFY(morning.desktop.window().confirmsLoss());
        document.undo();  // opening is one step
        QVERIFY(document.plan().measurements.empty() && !document.canUndo());
        QVERIFY(views.layout() == ViewLayout::image);
        morning.waitForNewest();
    }

    /// The next scan is shown as the one before, and so is the first one after a choice on the start screen.
    void anotherScanKeepsTheLayout() {
        Trial trial;
        press(trial, "nextLayout");
        for (int scan = 0; scan < 2; ++scan) {
            trial.frames.clear();
            trial.openAndWait(series_);
            QVERIFY(trial.desktop.window().views().layout() == ViewLayout::beside);
            QVERIFY(trial.desktop.document().plan().navigation.layout == ViewLayout::beside);
        }
        press(trial, "nextLayout");
        QCOMPARE(trial.desktop.document().undoText(), Text("Undo changing the layout"));
        trial.desktop.document().undo();
        QVERIFY(trial.desktop.window().views().layout() == ViewLayout::beside);
    }

    void nothingOfThePatientIsInIt() {
        QFile file(file_);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray text = file.readAll();
        for (const char* canary : {"Phantom", "PHANTOM", "Head", "1.2.826", "series", "/tmp"})
            QVERIFY2(!text.contains(canary), canary);
    }

    /// The files say what the list says, and neither whose it is nor where it lies.
    void measurementsAreExportedAsTheListHasThem() {
        Trial trial;
        trial.openAndWait(series_);
        QAction* action = trial.desktop.window().menuActions().exportMarks;
        QVERIFY(!action->isEnabled());
        measureIn(trial.desktop.document());
        QVERIFY(action->isEnabled());
        const auto* list = trial.desktop.presenter<MarksPresenter>().panel().findChild<QTreeWidget*>();
        const QByteArray value = list->topLevelItem(0)->text(1).section(' ', 0, 0).toUtf8();
        QCOMPARE(value, QByteArray("5.0"));
        auto& plans = trial.desktop.presenter<PlanPresenter>();
        for (const char* ending : {".csv", ".mrk.json"}) {
            QSignalSpy done(&plans.job(), &PlanJob::exported);
            plans.exportMarks(file_ + ending);
            QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, test::kPatience);
            QFile file(file_ + ending);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QByteArray text = file.readAll();
            QVERIFY(text.contains("defect"));
            QVERIFY2(text.contains(value), value.constData());
            for (const char* canary : {"Phantom", "PHANTOM", "Head", "1.2.826", "series", "/tmp"})
                QVERIFY2(!text.contains(canary), canary);
        }
        Answer no(QMessageBox::No);
        QVERIFY(!trial.desktop.window().confirmsLoss());  // no plan holds them yet
        QCOMPARE(no.asked, 1);
    }

    void anExportThatFailsIsSaid() {
        Trial trial;
        trial.openAndWait(series_);
        measureIn(trial.desktop.document());
        auto& plans = trial.desktop.presenter<PlanPresenter>();
        for (const char* file : {"/no/such/folder/a.csv", "a.txt"}) {
            QSignalSpy failed(&plans.job(), &PlanJob::failed);
            plans.exportMarks(folder_.filePath(file));
            QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, test::kPatience);
            QVERIFY(!trial.desktop.window().message().text().isEmpty());
        }
        QVERIFY(!QFile::exists(folder_.filePath("a.txt")));
    }

    void anotherScanIsRefusedAndNothingChanges() {
        const QString other = folder_.filePath("other");
        const Volume head = headPhantom({64, 57, 63}, {3.9, 4.9, 3.9});
        QVERIFY(
            dicom::writeSeries(head, {"Phantom^Two", "TWO", "Test", "Two", "Made."}, ui::fromQt(other), noProgress));
        Trial trial;
        trial.openAndWait(other);
        const Plan before = trial.desktop.document().plan();
        auto& plans = trial.desktop.presenter<PlanPresenter>();
        QSignalSpy failed(&plans.job(), &PlanJob::failed);
        plans.open(file_);
        QTRY_COMPARE_WITH_TIMEOUT(failed.size(), 1, test::kPatience);
        QVERIFY(trial.desktop.document().plan() == before);
        QVERIFY2(trial.desktop.window().message().text().contains("64 x 57 x 63"),
                 qPrintable(trial.desktop.window().message().text()));
    }

    void unsavedMeasurementsAreNotLostWithoutAQuestion() {
        Trial trial;
        trial.openAndWait(series_);
        measureIn(trial.desktop.document());
        {
            Answer no(QMessageBox::No);
            QVERIFY(!trial.desktop.window().close());
            trial.desktop.open(series_);
            QTest::qWait(100);
            QCOMPARE(no.asked, 2);
            QCOMPARE(trial.desktop.document().plan().measurements.size(), std::size_t(1));
        }
        trial.desktop.document().undo();
        QVERIFY(trial.desktop.window().confirmsLoss());  // nothing is left to lose
        trial.desktop.document().redo();
        Answer yes(QMessageBox::Yes);
        trial.frames.clear();
        trial.openAndWait(series_);
        QCOMPARE(yes.asked, 1);
        QVERIFY(trial.desktop.document().plan().measurements.empty());
    }

  private:
    QTemporaryDir folder_;
    QString series_, file_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::PlanInWindowTest)
#include "plan_in_window_test.moc"
