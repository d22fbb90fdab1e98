/// Series, look, status and messages: what they show and what they emit.

#include <QAbstractButton>
#include <QProgressBar>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include "ui/accuracy/status_line.h"
#include "ui/looks/look_panel.h"
#include "ui/rendering/render_panel.h"
#include "ui/series/series_delegate.h"
#include "ui/series/series_panel.h"
#include "ui/text/series_text.h"
#include "ui/text/status_text.h"
#include "ui/window/message_bar.h"

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

class TestPanels : public QObject {
    Q_OBJECT

  private slots:
    void aSeriesIsDescribedInWords();
    void aSeriesWithoutNameOrDateIsStillDescribed();
    void aTitleNamesTheSeriesAndNotThePatient();
    void toReachTheListByTabChoosesNothing();
    void theListShowsAllSeriesAndTheirVerdicts();
    void choosingALoadableSeriesAsksForIt();
    void theListWorksByTheKeyboardAlone();
    void anUnloadableSeriesGivesItsReasonInsteadOfAnImage();
    void thePatientNamedIsTheOneInTheImage();
    void namesAreHiddenEverywhereInTheList();
    void seriesSettersAreSilent();
    void lookControlsEmitWhatTheHandChose();
    void lookSettersAreSilent();
    void brightnessBeyondTheSliderIsKeptAtItsEnd();
    void aDenoisedImageIsMarkedWithItsError();
    void tissueThatWasNotSeenYetIsSaid();
    void theStatusNamesTheDeviceAndItsIterations();
    void theStatusSaysWhatIsForComparison();
    void theStatusSaysWhatIsTrueOfABox();
    void aLongStatusDoesNotWidenTheWindow();
    void progressHasACancelButton();
    void anErrorSaysWhatAndWhatNextAndWhere();
    void anOfferIsTakenOnceAndGoesWithItsMessage();
    void everyControlHasAnAccessibleName();
};

void TestPanels::aSeriesIsDescribedInWords() {
    const dicom::Series series = threeSeries().series[0];
    QCOMPARE(seriesTitle(series), "Thorax");
    QCOMPARE(seriesFacts(series), QStringList({"100 slices · 2.50 mm", "512 × 256"}));
    QCOMPARE(studyText(series, false), "2024-01-31");
    QCOMPARE(patientName(series.patient), "Family, Given");
}

void TestPanels::aSeriesWithoutNameOrDateIsStillDescribed() {
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
void TestPanels::aTitleNamesTheSeriesAndNotThePatient() {
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

void TestPanels::toReachTheListByTabChoosesNothing() {
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

void TestPanels::theListShowsAllSeriesAndTheirVerdicts() {
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

void TestPanels::choosingALoadableSeriesAsksForIt() {
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
void TestPanels::theListWorksByTheKeyboardAlone() {
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

void TestPanels::anUnloadableSeriesGivesItsReasonInsteadOfAnImage() {
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

void TestPanels::thePatientNamedIsTheOneInTheImage() {
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

void TestPanels::namesAreHiddenEverywhereInTheList() {
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

void TestPanels::seriesSettersAreSilent() {
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

static const QList<LookCard> kLooks{{"Bone", "Bones", "No skin.", ""}, {"Heart", "Chest", "No fat.", ""}};

void TestPanels::lookControlsEmitWhatTheHandChose() {
    LookPanel panel;
    panel.gallery().setLooks(kLooks);
    QSignalSpy look(&panel, &LookPanel::lookChosen), brightness(&panel, &LookPanel::brightnessChosen);
    QSignalSpy pause(&panel, &LookPanel::pauseChosen);
    for (QAbstractButton* button : panel.findChildren<QAbstractButton*>())
        if (button->text() == "Heart" || button->text() == "Pause")
            button->click();
    panel.findChild<QSlider*>()->setValue(15);
    QCOMPARE(look.count(), 1);
    QCOMPARE(look.first().first().toInt(), 1);
    QCOMPARE(brightness.first().first().toDouble(), 1.5);
    QCOMPARE(pause.first().first().toBool(), true);
}

void TestPanels::lookSettersAreSilent() {
    LookPanel panel;
    QSignalSpy look(&panel, &LookPanel::lookChosen), brightness(&panel, &LookPanel::brightnessChosen);
    QSignalSpy pause(&panel, &LookPanel::pauseChosen);
    panel.gallery().setLooks(kLooks);
    panel.setLook(1);
    panel.setBrightness(-1.3);
    panel.setPaused(true);
    QCOMPARE(panel.findChild<QSlider*>()->value(), -13);
    QCOMPARE(look.count() + brightness.count() + pause.count(), 0);
}

void TestPanels::brightnessBeyondTheSliderIsKeptAtItsEnd() {
    LookPanel panel;
    panel.setBrightness(100);
    QCOMPARE(panel.findChild<QSlider*>()->value(), panel.findChild<QSlider*>()->maximum());
}

void TestPanels::aDenoisedImageIsMarkedWithItsError() {
    DenoisedError error{.levels = 4.2, .levelsAtMost = 6.9};
    QCOMPARE(denoisedTexts(error, 0), QStringList{QString::fromUtf8("Denoised, error ±7")});
    QCOMPARE(denoisedTexts(std::nullopt, 0), QStringList{"Denoised, error not known yet"});
    const QString thin = "thin structures may be further off";
    QCOMPARE(hiddenDetailTexts(error), QStringList{thin});
    error.hiddenContrast = 0.371;
    QCOMPARE(hiddenDetailTexts(error), (QStringList{thin, "detail below 38 % contrast may be missing"}));
    error.hiddenContrast = 1.2;
    QCOMPARE(hiddenDetailTexts(error), (QStringList{thin, "fine detail may be missing"}));
    QCOMPARE(denoisedTexts(error, 1).back(), "1 thin line hidden by denoising: E shows where");
    QCOMPARE(denoisedTexts(error, 3).back(), "3 thin lines hidden by denoising: E shows where");
    QCOMPARE(denoisedTexts(error, 200).back(), "200 or more thin lines hidden by denoising: E shows where");
}

void TestPanels::tissueThatWasNotSeenYetIsSaid() {
    QCOMPARE(unseenText({.samplesPerPixel = 32, .unseenTissue = 0.114}), "at least 11 % of the tissue not sampled yet");
    QCOMPARE(unseenText({.samplesPerPixel = 32, .unseenTissue = 0.004}), QString());
}

void TestPanels::theStatusNamesTheDeviceAndItsIterations() {
    QCOMPARE(makingText({"cpu", 10, 0.9951, 123456, 0.73}),
             QString::fromUtf8("123\u2009456 samples, 0.73 iterations/s, 10 iterations per frame on the CPU, "
                               "efficiency 99 %"));
    QCOMPARE(makingText({"cuda:1", 1, 0, 1, 31.4}), "1 sample, 31 iterations/s, 1 iteration per frame on cuda:1");
    QCOMPARE(deviceText("cpu", "2 threads"), "CPU (2 threads)");
    QCOMPARE(deviceText("cuda:1", ""), "cuda:1");
}

void TestPanels::theStatusSaysWhatIsForComparison() {
    const Schedule k0{.kind = Schedule::Kind::kroes, .redundant = true};
    const Schedule k1{.kind = Schedule::Kind::kroes, .filter = false};
    QCOMPARE(comparisonText({}, Estimator::unbiased), "");
    QCOMPARE(comparisonText(k0, Estimator::unbiased), "comparison: Exposure Render's schedule K0, blurred");
    QCOMPARE(comparisonText(k1, Estimator::kroesMarch),
             "comparison: Exposure Render's schedule K1, march of 3 voxels, biased");
}

void TestPanels::theStatusSaysWhatIsTrueOfABox() {
    FilmStatus box{.displayError = 3.9, .tissuePixels = 7}, image{.displayError = 18, .tissuePixels = 99};
    QCOMPARE(boxText(box, false, image), QString::fromUtf8("in the region ±4 (95 % of the tissue)"));
    QCOMPARE(boxText(box, true, image),
             QString::fromUtf8("whole image, waiting for the region: ±18 (95 % of the tissue)"));
    QCOMPARE(boxText(box, true, {}), "the rest of the image waits for the region");
    box.displayError = std::numeric_limits<double>::infinity();
    QCOMPARE(boxText(box, false, image), "the region is still black");
    QCOMPARE(boxText({}, false, image), "no tissue in the region");
}

void TestPanels::aLongStatusDoesNotWidenTheWindow() {
    StatusLine line;
    const int before = line.minimumSizeHint().width();
    line.setText(QString(500, 'm'));
    QCOMPARE(line.minimumSizeHint().width(), before);
}

void TestPanels::progressHasACancelButton() {
    StatusLine line;
    line.show();
    auto* cancel = line.findChild<QPushButton*>();
    QVERIFY(!cancel->isVisible());
    line.setProgress(0.25, "reading slices");
    QVERIFY(cancel->isVisible());
    QCOMPARE(line.findChild<QProgressBar*>()->value(), 250);
    QSignalSpy cancelled(&line, &StatusLine::cancelRequested);
    QTest::mouseClick(cancel, Qt::LeftButton);
    QCOMPARE(cancelled.count(), 1);
    line.endProgress();
    QVERIFY(!cancel->isVisible());
}

void TestPanels::anErrorSaysWhatAndWhatNextAndWhere() {
    MessageBar bar;
    bar.showError({"slices 3 and 4 are 6 mm apart", "/data/ct", "Choose another series"});
    QCOMPARE(bar.text(), "Slices 3 and 4 are 6 mm apart. Choose another series.\n/data/ct");
    bar.clear();
    QVERIFY(bar.isHidden());
}

void TestPanels::anOfferIsTakenOnceAndGoesWithItsMessage() {
    MessageBar bar;
    int taken = 0;
    const auto offer = [&] { bar.offer("Show", [&] { ++taken; }); };
    const auto* button = bar.findChild<QPushButton*>();
    bar.showError({"the table is hidden", "", ""});
    QVERIFY(button->isHidden());
    offer();
    QVERIFY(!button->isHidden());
    QCOMPARE(button->text(), "Show");
    bar.showError({"something else", "", ""});
    QVERIFY(button->isHidden());
    bar.withdraw("Show");
    QCOMPARE(bar.text(), "Something else.");
    offer();
    bar.withdraw("Something else");
    QVERIFY(!bar.isHidden());
    bar.withdraw("Show");
    QVERIFY(bar.isHidden());
    bar.showError({"the table is hidden", "", ""});
    offer();
    const_cast<QPushButton*>(button)->click();
    QCOMPARE(taken, 1);
    QVERIFY(bar.isHidden() && button->isHidden());
}

void TestPanels::everyControlHasAnAccessibleName() {
    SeriesPanel series;
    LookPanel look;
    look.gallery().setLooks(kLooks);
    RenderPanel rendering;
    StatusLine status;
    MessageBar message;
    for (QWidget* panel : std::initializer_list<QWidget*>{&series, &look, &rendering, &status, &message}) {
        for (const QWidget* widget : panel->findChildren<QWidget*>()) {
            const bool control =
                qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QListView*>(widget) ||
                qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget) ||
                qobject_cast<const QComboBox*>(widget);
            const bool own = !widget->objectName().startsWith("qt_") &&
                             !widget->inherits("QComboBoxListView");  // not the parts that Qt makes a control of
            if (control && own && !qobject_cast<const QScrollBar*>(widget))
                QVERIFY2(!widget->accessibleName().isEmpty(), widget->metaObject()->className());
        }
    }
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestPanels)
#include "panels_test.moc"
