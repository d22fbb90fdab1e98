/// Look, status and messages: what they show and what they emit.

#include <QAbstractButton>
#include <QProgressBar>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTest>

#include "ui/accuracy/status_line.h"
#include "ui/looks/look_panel.h"
#include "ui/rendering/render_panel.h"
#include "ui/series/series_panel.h"
#include "ui/text/status_text.h"
#include "ui/window/message_bar.h"

namespace pdr::ui {

class TestPanels : public QObject {
    Q_OBJECT

  private slots:
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
