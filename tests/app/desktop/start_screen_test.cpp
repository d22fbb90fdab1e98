/// The start screen: recent plans open with their scan, are remembered only where the user wants that, and a plan that
/// is dropped opens on the scan that is open.

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QTemporaryDir>
#include <QTest>

#include "app/presenters/plan_presenter.h"
#include "app/presenters/series_presenter.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/named_widget.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class StartScreenTest : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        file_ = folder_.filePath("head.plan.json");
        const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
        QVERIFY2(written, written ? "" : written.error().text().c_str());
        Trial trial;
        trial.openAndWait(series_);
        measureAndSave(trial);
        QVERIFY(trial.desktop.settings().recentPlans().isEmpty());  // nobody has asked for that
    }

    void aRecentPlanOpensWithItsScan() {
        Trial trial;
        Settings& settings = trial.desktop.settings();
        settings.keepRemembersFolders(true);
        trial.openAndWait(series_);
        measureAndSave(trial);
        QCOMPARE(settings.recentPlans(), (QList<RecentPlan>{{file_, series_}}));
        trial.desktop.presenter<SeriesPresenter>().close();
        trial.frames.clear();
        QVERIFY(!trial.desktop.document().hasVolume());
        QSignalSpy opened(&trial.desktop.presenter<PlanPresenter>().job(), &PlanJob::opened);
        auto& recent = test::named<QPushButton>(trial.desktop.window().start(), "Open " + file_);
        QVERIFY(recent.isVisible());
        recent.click();
        QTRY_COMPARE_WITH_TIMEOUT(opened.size(), 1, test::kPatience);
        QVERIFY(trial.desktop.document().hasVolume());
        QCOMPARE(trial.desktop.document().plan().measurements.size(), std::size_t(1));
        settings.forgetFolders();
        QVERIFY(settings.recentPlans().isEmpty() && settings.recentFolders().isEmpty());
    }

    void theNewestEightPlansAreRememberedOnce() {
        Trial trial;
        Settings& settings = trial.desktop.settings();
        settings.keepRemembersFolders(true);
        for (int i = 0; i < 10; ++i)
            settings.keepPlan({QString("/%1").arg(i), "/scan"});
        settings.keepPlan({"/7", "/other"});
        QCOMPARE(settings.recentPlans().size(), 8);
        QCOMPARE(settings.recentPlans().first(), (RecentPlan{"/7", "/other"}));
        QCOMPARE(settings.recentPlans().count(RecentPlan{"/7", "/scan"}), 0);
        settings.keepRemembersFolders(false);
        QVERIFY(settings.recentPlans().isEmpty());
        settings.keepPlan({"/7", "/scan"});
        QVERIFY(settings.recentPlans().isEmpty());
    }

    void aDroppedPlanOpensOnItsScan() {
        Trial trial;
        ui::MainWindow& window = trial.desktop.window();
        drop(window, file_);
        QVERIFY2(window.message().text().contains("Open the folder of the scan first"),
                 qPrintable(window.message().text()));
        trial.openAndWait(series_);
        QVERIFY(trial.desktop.document().plan().measurements.empty());
        drop(window, file_);
        QTRY_COMPARE_WITH_TIMEOUT(trial.desktop.document().plan().measurements.size(), std::size_t(1), test::kPatience);
    }

  private:
    void measureAndSave(Trial& trial) {
        Plan plan = trial.desktop.document().plan();
        plan.measurements = {
            {42, MeasureKind::distance, "", {measure::typedPlace({1, 2, 3}), measure::typedPlace({4, 6, 3})}}};
        trial.desktop.document().edit(plan);
        auto& plans = trial.desktop.presenter<PlanPresenter>();
        QSignalSpy done(&plans.job(), &PlanJob::saved);
        plans.save(file_);
        QTRY_COMPARE_WITH_TIMEOUT(done.size(), 1, test::kPatience);
    }

    static void drop(ui::MainWindow& window, const QString& file) {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(file)});
        QDragEnterEvent enter(QPoint(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &enter);
        QDropEvent event(QPointF(50, 50), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&window, &event);
    }

    QTemporaryDir folder_;
    QString series_, file_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::StartScreenTest)
#include "start_screen_test.moc"
