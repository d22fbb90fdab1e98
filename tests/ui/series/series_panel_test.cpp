/// The list of series: what it shows, what it hides, and what it emits.

#include <QSignalSpy>
#include <QTest>

#include "ui/series/series_delegate.h"
#include "ui/series/series_panel.h"
#include "ui/text/series_text.h"

namespace pdr::ui {

static dicom::Series seriesOf(const char* description, dicom::Stack stack, const char* reason) {
    dicom::Series series;
    series.patient.name = "Family^Given=ideographic";
    series.study.date = "20240131";
    series.series.description = description;
    series.verdict.stack = stack;
    series.verdict.reason = reason;
    series.geometry = VolumeGeometry::aligned({512, 256, 100}, {0.9, 0.9, 2.5}, {0, 0, 0});
    return series;
}

/// Returns two series that can be shown, and between them one that cannot.
static dicom::ScanResult threeSeries() {
    dicom::ScanResult scan;
    scan.series = {seriesOf("Thorax", dicom::Stack::even, ""),
                   seriesOf("Head", dicom::Stack::gap, "a.dcm and b.dcm are 10 mm apart, the others 5 mm"),
                   seriesOf("Abdomen", dicom::Stack::even, "")};
    scan.series[0].verdict.notes = {{"copies", "1 copy of a slice left out"}};
    scan.problems = {{"/somewhere/broken.dcm", "it ends early"}};
    return scan;
}

class TestSeriesPanel : public QObject {
    Q_OBJECT

  private slots:
    void aSeriesIsDescribedInWords();
    void aSeriesWithoutNameOrDateIsStillDescribed();
    void aModalityOtherThanCtIsNamed();
    void aTitleNamesTheSeriesAndNotThePatient();
    void toReachTheListByTabChoosesNothing();
    void theListShowsAllSeriesAndTheirVerdicts();
    void choosingALoadableSeriesAsksForIt();
    void theListWorksByTheKeyboardAlone();
    void anUnloadableSeriesGivesItsReasonInsteadOfAnImage();
    void thePatientNamedIsTheOneInTheImage();
    void namesAreHiddenEverywhereInTheList();
    void seriesSettersAreSilent();
};

void TestSeriesPanel::aSeriesIsDescribedInWords() {
    const dicom::Series series = threeSeries().series[0];
    QCOMPARE(seriesTitle(series), "Thorax");
    QCOMPARE(seriesFacts(series), QStringList({"100 slices · 2.50 mm", "512 × 256"}));
    QCOMPARE(studyText(series, false), "2024-01-31");
    QCOMPARE(patientName(series.patient), "Family, Given");
}

void TestSeriesPanel::aModalityOtherThanCtIsNamed() {
    dicom::Series series = threeSeries().series[0];
    series.series.number = 4;
    series.series.modality = "PT";
    QCOMPARE(seriesFacts(series).front(), "PET · 100 slices · 2.50 mm");
    QCOMPARE(seriesNumber(series), "PET series 4");
    series.series.modality = "MR";
    QCOMPARE(seriesFacts(series).front(), "MR · 100 slices · 2.50 mm");
    QCOMPARE(seriesNumber(series), "MR series 4");
    series.series.modality = "NIfTI";  // a volume file, whose name says it
    QCOMPARE(seriesFacts(series).front(), "100 slices · 2.50 mm");
}

void TestSeriesPanel::aSeriesWithoutNameOrDateIsStillDescribed() {
    dicom::Series series;
    series.series.number = 7;
    series.verdict.stack = dicom::Stack::noGeometry;
    QCOMPARE(seriesTitle(series), "Series 7");
    QCOMPARE(seriesFacts(series), QStringList("0 images"));
    QCOMPARE(studyText(series, false), "");
    QCOMPARE(patientName(series.patient), "Name not given");
    series.series.date = "sometime";
    QCOMPARE(studyText(series, false), "sometime");
}

/// Descriptions sometimes contain names, and title bars are visible in task lists and recordings.
void TestSeriesPanel::aTitleNamesTheSeriesAndNotThePatient() {
    dicom::Series series = seriesOf("Thorax", dicom::Stack::even, "");
    series.series.number = 3;
    series.patient.id = "4711";
    QCOMPARE(windowSubject(series), "Thorax");
    for (const char* description : {"Thorax FAMILY", "Thorax given", "Thorax 4711", ""}) {
        series.series.description = description;
        QCOMPARE(windowSubject(series), "CT series 3");
    }
    series.patient.name = "No^O";  // shorter than what tells a person
    series.series.description = "Contrast";
    QCOMPARE(windowSubject(series), "Contrast");
}

void TestSeriesPanel::toReachTheListByTabChoosesNothing() {
    SeriesPanel panel;
    panel.show();
    panel.setScan(threeSeries());
    QSignalSpy chosen(&panel, &SeriesPanel::seriesChosen);
    panel.activateWindow();
    const_cast<QListView&>(panel.list()).setFocus(Qt::TabFocusReason);
    QTRY_VERIFY(panel.list().hasFocus());
    QCOMPARE(chosen.count(), 0);
    QTest::keyClick(const_cast<QListView*>(&panel.list()), Qt::Key_Space);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.first().first().toInt(), 0);
}

void TestSeriesPanel::theListShowsAllSeriesAndTheirVerdicts() {
    SeriesPanel panel;
    panel.setScan(threeSeries());
    const QAbstractItemModel& model = *panel.list().model();
    QCOMPARE(model.rowCount(), 4);
    QCOMPARE(model.index(0, 0).data(kTitleRole).toString(), "Family, Given");
    QCOMPARE(model.index(0, 0).data(kLinesRole).toStringList(), QStringList("2024-01-31"));
    QCOMPARE(panel.rowOf(1).row(), 3);  // refused series are last
    const QString label = panel.rowOf(1).data(Qt::AccessibleTextRole).toString();
    for (const char* part : {"Head", "a slice is missing", "10 mm apart"})
        QVERIFY2(label.contains(part), part);
    QVERIFY(panel.rowOf(1).data(Qt::ToolTipRole).toString().contains("10 mm apart"));
}

void TestSeriesPanel::choosingALoadableSeriesAsksForIt() {
    SeriesPanel panel;
    panel.resize(330, 500);
    panel.show();
    panel.setScan(threeSeries());
    QSignalSpy chosen(&panel, &SeriesPanel::seriesChosen);
    const QRect third = panel.list().visualRect(panel.rowOf(2));
    QTest::mouseClick(panel.list().viewport(), Qt::LeftButton, {}, third.center());
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.first().first().toInt(), 2);
    QTest::mouseDClick(panel.list().viewport(), Qt::LeftButton, {}, third.center());
    QCOMPARE(chosen.count(), 1);
}

/// A heading is passed over, a mark loads nothing, and a refused series is never asked for.
void TestSeriesPanel::theListWorksByTheKeyboardAlone() {
    SeriesPanel panel;
    panel.resize(330, 500);
    panel.show();
    panel.setScan(threeSeries());
    QSignalSpy chosen(&panel, &SeriesPanel::seriesChosen);
    auto* list = panel.findChild<QListView*>("seriesList");
    const auto press = [&](int key) {
        QTest::keyClick(list, Qt::Key(key));
        return list->currentIndex();
    };
    list->setFocus();
    QCOMPARE(press(Qt::Key_Home), panel.rowOf(0));
    QCOMPARE(panel.detail(), "1 copy of a slice left out.");
    QCOMPARE(press(Qt::Key_Up), panel.rowOf(0));
    QCOMPARE(press(Qt::Key_Down), panel.rowOf(2));
    QCOMPARE(panel.detail(), "");
    QCOMPARE(press(Qt::Key_Down), panel.rowOf(1));
    QCOMPARE(panel.detail(), "a.dcm and b.dcm are 10 mm apart, the others 5 mm.");
    press(Qt::Key_Return);
    press(Qt::Key_Space);
    QCOMPARE(chosen.count(), 0);
    press(Qt::Key_Up);
    press(Qt::Key_Return);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(chosen.first().first().toInt(), 2);
}

void TestSeriesPanel::anUnloadableSeriesGivesItsReasonInsteadOfAnImage() {
    SeriesPanel panel;
    panel.resize(330, 500);
    panel.show();
    panel.setScan(threeSeries());
    QSignalSpy chosen(&panel, &SeriesPanel::seriesChosen);
    const QRect second = panel.list().visualRect(panel.rowOf(1));
    QTest::mouseClick(panel.list().viewport(), Qt::LeftButton, {}, second.center());
    QCOMPARE(chosen.count(), 0);
    QCOMPARE(panel.detail(), "a.dcm and b.dcm are 10 mm apart, the others 5 mm.");
}

void TestSeriesPanel::thePatientNamedIsTheOneInTheImage() {
    dicom::ScanResult scan = threeSeries();
    scan.series[2].patient.name = "Other^Somebody";
    SeriesPanel panel;
    panel.resize(330, 500);
    panel.show();
    panel.setScan(scan);
    panel.setCurrent(0);
    QCOMPARE(panel.patient(), "Family, Given");
    // Marking another series is not yet showing it.
    const QRect third = panel.list().visualRect(panel.rowOf(2));
    QTest::mouseClick(panel.list().viewport(), Qt::LeftButton, {}, third.center());
    QCOMPARE(panel.patient(), "Family, Given");
    QVERIFY(panel.rowOf(2).data(Qt::AccessibleTextRole).toString().contains("Other, Somebody"));
    panel.setCurrent(2);
    QCOMPARE(panel.patient(), "Other, Somebody");
}

void TestSeriesPanel::namesAreHiddenEverywhereInTheList() {
    dicom::ScanResult scan = threeSeries();
    scan.series[2].patient = {"Other^Person", "4711", "19600517", ""};
    scan.series[2].study.description = "Check Other";
    SeriesPanel panel;
    panel.setScan(scan);
    panel.setCurrent(2);
    const auto all = [&] {
        QStringList words{panel.patient()};
        for (int row = 0; row < panel.list().model()->rowCount(); ++row)
            for (const int role : {int(kTitleRole), int(kLinesRole), int(Qt::AccessibleTextRole), int(Qt::ToolTipRole)})
                words << panel.list().model()->index(row, 0).data(role).toStringList();
        return words.join('\n');
    };
    for (const char* part :
         {"Other, Person, born 1960-05-17 · ID 4711, Abdomen", "Family, Given, Thorax", "Check Other"})
        QVERIFY2(all().contains(part), qPrintable(all()));
    panel.setNamesHidden(true);
    for (const char* part : {"Other", "Family", "4711", "1960"})
        QVERIFY2(!all().contains(part), qPrintable(all()));
    QVERIFY(all().contains("Patient 1 (name hidden), Head") && panel.patient() == "Patient 2 (name hidden)");
    panel.setScan(scan);
    QVERIFY(!all().contains("Family"));
    panel.setNamesHidden(false);
    QVERIFY(all().contains("Family, Given, Thorax"));
}

void TestSeriesPanel::seriesSettersAreSilent() {
    SeriesPanel panel;
    QSignalSpy chosen(&panel, &SeriesPanel::seriesChosen);
    panel.setScan(threeSeries());
    panel.setCurrent(0);
    QCOMPARE(panel.current(), 0);
    QCOMPARE(panel.detail(), "1 copy of a slice left out.");
    panel.setCurrent(2);
    panel.setCurrent(-1);
    panel.setScan({});
    QCOMPARE(panel.current(), -1);
    QCOMPARE(chosen.count(), 0);
}
}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestSeriesPanel)
#include "series_panel_test.moc"
