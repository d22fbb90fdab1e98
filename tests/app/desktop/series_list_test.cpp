/// Whose images they are is said before one is shown, and nobody's are shown unasked.

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QStandardItemModel>
#include <QTest>
#include <cstdlib>

#include "app/jobs/series_images.h"
#include "app/presenters/series_presenter.h"
#include "app/scan/grid_series.h"
#include "app/scan/series_choice.h"
#include "dicom/import.h"
#include "dicom/write/export.h"
#include "render/volume/phantom.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/grid_files.h"
#include "tests/support/patience.h"
#include "ui/series/series_delegate.h"
#include "ui/series/series_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// A small series of that patient in a folder of its own, with slices 9 mm apart; so many are missing in the middle.
static void writeSeries(const QString& folder, const std::string& name, const std::string& id, int missing = 0) {
    QVERIFY(QDir().mkpath(folder));
    const Volume head = headPhantom({32, 28, 24}, {7.8, 9.8, 9});
    const dicom::ExportFacts facts{name, id, "Study", "Thorax", "Made from formulas."};
    QVERIFY(dicom::writeSeries(head, facts, ui::fromQt(folder), noProgress));
    const QStringList files = QDir(folder).entryList(QDir::Files);
    for (int i = 0; i < missing; ++i)
        QVERIFY(QFile::remove(folder + "/" + files[files.size() / 2 + i]));
}

static QVariant itemOf(Trial& trial, int series, int role) {
    return test::the<ui::SeriesPanel>(trial.desktop.window()).rowOf(series).data(role);
}

class TestSeriesList : public QObject {
    Q_OBJECT

  private slots:
    void init() { place_ = std::make_unique<QTemporaryDir>(); }
    void severalPatientsAreToBeChosenFrom();
    void theOnlySeriesIsShown();
    void oneLoadableAmongSeveralPatientsIsToBeChosen();
    void aRefusedFolderShowsItsListAndItsReasons();
    void aSeriesWithASmallHoleIsShownResampledOnRequest();
    void whoItIsStandsInTheImage();
    void thumbnailsComeInTheOrderOfTheList();
    void noThumbnailComesOnceTheyAreCancelled();
    void volumeFilesHaveThumbnailsAsRadiologistsSeeThem();

  private:
    QString at(const QString& name) const { return place_->filePath(name); }

    std::unique_ptr<QTemporaryDir> place_;
};

void TestSeriesList::severalPatientsAreToBeChosenFrom() {
    writeSeries(at("all/a"), "Doe^Jane", "4711");
    writeSeries(at("all/b"), "Roe^Richard", "4712");
    Trial trial;
    ui::MainWindow& window = trial.desktop.window();
    trial.desktop.open(at("all"));
    QTRY_COMPARE_WITH_TIMEOUT(test::the<ui::SeriesPanel>(window).order().size(), std::size_t(2), test::kPatience);
    QVERIFY(test::the<ui::SeriesPanel>(window).isVisible());
    QVERIFY2(window.viewport().message().contains("Choose a series"), qPrintable(window.viewport().message()));
    QTRY_VERIFY_WITH_TIMEOUT(!itemOf(trial, 1, Qt::DecorationRole).value<QPixmap>().isNull(), test::kPatience);
    QVERIFY(!itemOf(trial, 0, Qt::DecorationRole).value<QPixmap>().isNull());
    const QString first = itemOf(trial, 0, Qt::AccessibleTextRole).toString();
    QVERIFY2(first.contains("Thorax") && first.contains("ID 471"), qPrintable(first));
    QVERIFY(!trial.desktop.presenter<SeriesPresenter>().import().isRunning() && !trial.desktop.document().hasVolume());
    const QRect second =
        test::the<ui::SeriesPanel>(window).list().visualRect(test::the<ui::SeriesPanel>(window).rowOf(1));
    QTest::mouseClick(test::the<ui::SeriesPanel>(window).list().viewport(), Qt::LeftButton, {}, second.center());
    QTRY_VERIFY_WITH_TIMEOUT(!trial.frames.empty(), test::kPatience);
    QVERIFY(window.patient().front() == itemOf(trial, 1, ui::kPatientRole).toString());
}

void TestSeriesList::theOnlySeriesIsShown() {
    writeSeries(at("one"), "Doe^Jane", "4711");
    Trial trial;
    trial.openAndWait(at("one"));
    QVERIFY(trial.desktop.document().hasVolume());
    QTRY_VERIFY_WITH_TIMEOUT(!itemOf(trial, 0, Qt::DecorationRole).value<QPixmap>().isNull(), test::kPatience);
}

void TestSeriesList::oneLoadableAmongSeveralPatientsIsToBeChosen() {
    dicom::Series good, bad;
    good.verdict.stack = dicom::Stack::even;
    bad.verdict.stack = dicom::Stack::gap;
    QCOMPARE(onlyLoadable({.series = {good, bad}}), 0);
    QCOMPARE(onlyLoadable({.series = {good, good}}), -1);
    QCOMPARE(onlyLoadable({.series = {bad}}), -1);
    QCOMPARE(onlyLoadable({}), -1);
    dicom::Series made = good;
    made.series.resampled = true;
    QCOMPARE(onlyLoadable({.series = {made, bad}}), -1);
    QCOMPARE(onlyLoadable({.series = {made, good}}), 1);
    bad.patient.birthDate = "19600517";
    QCOMPARE(onlyLoadable({.series = {good, bad}}), -1);
}

void TestSeriesList::aRefusedFolderShowsItsListAndItsReasons() {
    writeSeries(at("gap"), "Doe^Jane", "4711", 3);
    Trial trial;
    ui::MainWindow& window = trial.desktop.window();
    trial.desktop.open(at("gap"));
    QTRY_VERIFY_WITH_TIMEOUT(!window.message().text().isEmpty(), test::kPatience);
    QVERIFY(test::the<ui::SeriesPanel>(window).isVisible());
    QVERIFY2(test::the<ui::SeriesPanel>(window).detail().contains("mm apart"),
             qPrintable(test::the<ui::SeriesPanel>(window).detail()));
    QVERIFY2(window.viewport().message().contains("The list says why"), qPrintable(window.viewport().message()));
    QTRY_VERIFY_WITH_TIMEOUT(!itemOf(trial, 0, Qt::DecorationRole).value<QPixmap>().isNull(), test::kPatience);
}

void TestSeriesList::aSeriesWithASmallHoleIsShownResampledOnRequest() {
    writeSeries(at("gap"), "Doe^Jane", "4711", 1);
    Trial trial;
    ui::MainWindow& window = trial.desktop.window();
    trial.desktop.open(at("gap"));
    QTRY_VERIFY_WITH_TIMEOUT(window.message().text().contains("The list offers"), test::kPatience);
    QVERIFY2(window.message().text().contains("18 mm apart"), qPrintable(window.message().text()));
    QVERIFY(window.viewport().message().startsWith("Choose a series") && !trial.desktop.document().hasVolume());
    auto& panel = test::the<ui::SeriesPanel>(window);
    QCOMPARE(panel.list().model()->rowCount(), 3);  // the study, the resampled series, the refused one
    QTest::mouseClick(panel.list().viewport(), Qt::LeftButton, {}, panel.list().visualRect(panel.rowOf(0)).center());
    QTRY_VERIFY_WITH_TIMEOUT(!trial.frames.empty(), test::kPatience);
    QVERIFY2(window.message().text().contains("were resampled to 24"), qPrintable(window.message().text()));
    QCOMPARE(trial.desktop.document().scan()->size().z, 24);
}

void TestSeriesList::whoItIsStandsInTheImage() {
    writeSeries(at("one"), "Doe^Jane", "4711");
    Trial trial;
    ui::MainWindow& window = trial.desktop.window();
    QCOMPARE(window.patient(), QStringList());
    trial.openAndWait(at("one"));
    const QString said = window.patient().join('\n');
    for (const char* part : {"Doe, Jane", "ID 4711", "Thorax"})
        QVERIFY2(said.contains(part), qPrintable(said));
    QVERIFY2(window.windowTitle().startsWith("Thorax"), qPrintable(window.windowTitle()));
    QTest::keyClick(&window, Qt::Key_N);
    QVERIFY(!window.patient().join('\n').contains("Doe") && !window.patient().join('\n').contains("4711"));
    QVERIFY2(window.windowTitle().startsWith("CT series"), qPrintable(window.windowTitle()));
}

void TestSeriesList::thumbnailsComeInTheOrderOfTheList() {
    writeSeries(at("all/a"), "Doe^Jane", "4711");
    writeSeries(at("all/b"), "Roe^Richard", "4712");
    const auto scan = dicom::scanFolder(ui::fromQt(at("all")), noProgress);
    QVERIFY(scan && scan->series.size() == 2);
    SeriesImages images;
    QSignalSpy made(&images, &SeriesImages::made);
    images.make(*scan, {1, 0});
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 2, test::kPatience);
    QCOMPARE(made[0][0].toInt(), 1);
    QCOMPARE(made[1][0].toInt(), 0);
    // The shape is that of the patient: 32 x 28 pixels of 7.8 x 9.8 mm
    const QSize size = made[0][1].value<QImage>().size();
    QVERIFY2(size.height() == 96 && std::abs(size.width() - 87) <= 1, qPrintable(QString::number(size.width())));
}

void TestSeriesList::noThumbnailComesOnceTheyAreCancelled() {
    writeSeries(at("one"), "Doe^Jane", "4711");
    const auto scan = dicom::scanFolder(ui::fromQt(at("one")), noProgress);
    QVERIFY(scan);
    SeriesImages images;
    QSignalSpy made(&images, &SeriesImages::made), cancelled(&images, &SeriesImages::cancelled);
    images.make(*scan, std::vector<int>(100, 0));
    images.cancel();
    QCOMPARE(cancelled.count(), 1);
    images.make(*scan, {0});  // begins when the one before has ended
    QTRY_COMPARE_WITH_TIMEOUT(made.count(), 1, test::kPatience);
    QTest::qWait(20);
    QCOMPARE(made.count(), 1);
}

/// NIfTI and NRRD often store the patient's right and back first.
void TestSeriesList::volumeFilesHaveThumbnailsAsRadiologistsSeeThem() {
    const auto thumbnailOf = [&](const std::string& directions) {
        const std::string bytes = test::nrrdBytes({{"space directions", directions}});
        const auto series = gridSeries(test::written(ui::fromQt(at("scan.nrrd")), bytes), noProgress);
        return series ? seriesImage(*series) : QImage();
    };
    const auto looksLike = [](const QImage& a, const QImage& b) {  // but for rounding, which has a direction
        for (int y = 0; y < a.height(); ++y)
            for (int x = 0; x < a.width(); ++x)
                if (!b.valid(x, y) || std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 3)
                    return false;
        return !a.isNull();
    };
    const QImage usual = thumbnailOf("(0.8,0,0) (0,0.9,0) (0,0,1.5)");
    QVERIFY(!looksLike(usual, usual.mirrored(true, false)) && !looksLike(usual, usual.mirrored(false, true)));
    QVERIFY(looksLike(thumbnailOf("(-0.8,0,0) (0,0.9,0) (0,0,-1.5)"), usual.mirrored(true, false)));
    QVERIFY(looksLike(thumbnailOf("(0.8,0,0) (0,-0.9,0) (0,0,-1.5)"), usual.mirrored(false, true)));
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestSeriesList)
#include "series_list_test.moc"
