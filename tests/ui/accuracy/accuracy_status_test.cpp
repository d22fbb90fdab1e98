/// The status bar: its sentence, its strip, and that both keep their room.

#include <QFontMetrics>
#include <QLabel>
#include <QPalette>
#include <QSignalSpy>
#include <QTest>

#include "tests/support/desktop/mouse.h"
#include "ui/accuracy/accuracy_status.h"
#include "ui/theme/theme.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

class TestAccuracyStatus : public QObject {
    Q_OBJECT

  private slots:
    void theSentenceSaysWordNumberAndPrice_data();
    void theSentenceSaysWordNumberAndPrice();
    void theSentenceSaysWhatIsNotKnown();
    void aPreviewSaysThatItIsOne();
    void stepsAreToldInWords();
    void onePlaceIsToldInWords();
    void theAxisIsLogarithmicFromASecondToAnHour();
    void labelsNeverOverlapAndKeepTheirOrder();
    void laterStepsStandFartherRight();
    void stepsBeyondTheHourHaveTheirPlace();
    void theKnobIsDraggedToTheNearestStep();
    void theArrowKeysMoveTheKnob();
    void theTargetIsSetSilently();
    void theKnobCanStandBetweenTwoSteps();
    void withoutAForecastTheKnobStays();
    void theStripTellsItsValueToThoseWhoCannotSeeIt();
    void theStripIsFilledUpToNow();
    void nothingIsCutOffInASmallWindow();
};

static FilmStatus statusOf(double levels) {
    return {.samplesPerPixel = 64, .relativeError = 0.1, .displayError = levels, .tissuePixels = 100};
}

/// Returns an accuracy for which each step takes four times as long as the one before; ±32 takes `first` seconds, and
/// the present is a little after the last step reached.
static Accuracy accuracyAt(double levels, double first = 3) {
    Accuracy accuracy{statusOf(levels)};
    double seconds = first;
    for (const double step : kQualitySteps) {
        const bool reached = levels <= step;
        if (reached)
            accuracy.seconds = 1.2 * seconds;
        accuracy.steps.push_back({step, reached, {seconds, reached ? seconds : 0.8 * seconds, 1.3 * seconds}});
        seconds *= 4;
    }
    return accuracy;
}

void TestAccuracyStatus::theSentenceSaysWordNumberAndPrice_data() {
    QTest::addColumn<Accuracy>("accuracy");
    QTest::addColumn<QString>("expected");
    const auto row = [](const char* name, const Accuracy& accuracy, const char* expected) {
        QTest::newRow(name) << accuracy << QString::fromUtf8(expected);
    };
    row("rough", accuracyAt(26), "Rough · Image error ±26 of 255 grey levels (95 % of the tissue) · ±16 in 8 s");
    row("orientation", accuracyAt(15.2),
        "Good for orientation · Image error ±16 of 255 grey levels (95 % of the tissue) · ±8 in 34 s");
    row("planning", accuracyAt(4.4),
        "Good for planning · Image error ±5 of 255 grey levels (95 % of the tissue) · ±4 in 2.2 min");
    row("reference", accuracyAt(0.9), "Reference · Image error ±0.9 of 255 grey levels (95 % of the tissue)");
    Accuracy held = accuracyAt(7.9);
    held.holding = Holding::reached;
    row("target reached", held,
        "Good for planning · Image error ±8 of 255 grey levels (95 % of the tissue) · target reached (Space: "
        "continue)");
    held.holding = Holding::paused;
    row("paused", held, "Good for planning · Image error ±8 of 255 grey levels (95 % of the tissue) · paused");
    Accuracy rare = accuracyAt(26);
    rare.steps[1].seconds.high = std::numeric_limits<double>::infinity();
    row("at least", rare, "Rough · Image error ±26 of 255 grey levels (95 % of the tissue) · ±16 in at least 8 s");
    Accuracy denoised = accuracyAt(26);
    denoised.of = ErrorOf::denoised;
    row("denoised", denoised, "Rough · Denoised, image error ±26 of 255 grey levels (95 % of the tissue) · ±16 in 8 s");
    denoised.of = ErrorOf::beforeDenoising;
    row("not known of the denoised image", denoised,
        "Rough · Image error ±26 of 255 grey levels before denoising (95 % of the tissue) · ±16 in 8 s");
    row("no forecast", {statusOf(12)},
        "Good for orientation · Image error ±12 of 255 grey levels (95 % of the tissue)");
    row("nothing", {}, "");
}

void TestAccuracyStatus::theSentenceSaysWordNumberAndPrice() {
    QFETCH(Accuracy, accuracy);
    QFETCH(QString, expected);
    QCOMPARE(accuracyText(accuracy), expected);
}

void TestAccuracyStatus::theSentenceSaysWhatIsNotKnown() {
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    Accuracy accuracy{{.samplesPerPixel = 31}};
    QCOMPARE(accuracyText(accuracy), "Estimating how good the image is");
    accuracy.planningSeconds = 90;
    QCOMPARE(accuracyText(accuracy),
             QString::fromUtf8("Estimating how good the image is · ±8 took 1.5 min the last time"));
    accuracy.coarse = true;
    QCOMPARE(accuracyText(accuracy),
             QString::fromUtf8("Coarse preview; the full image follows · ±8 took 1.5 min the last time"));
    accuracy.planningSeconds.reset();
    QCOMPARE(accuracyText(accuracy), "Coarse preview; the full image follows");
    accuracy = {{.samplesPerPixel = 40}};
    QCOMPARE(accuracyText(accuracy), "No tissue is in view");
    accuracy.status.relativeError = kUnknown;
    QCOMPARE(accuracyText(accuracy), QString::fromUtf8("Estimating · the error is not known yet"));
    accuracy.status.unseenShare = 1e-3;
    QCOMPARE(accuracyText(accuracy), QString::fromUtf8("Estimating · image still black"));
    accuracy.holding = Holding::paused;
    QCOMPARE(accuracyText(accuracy), QString::fromUtf8("Estimating · image still black · paused"));
    accuracy.box = true;
    QCOMPARE(accuracyText(accuracy), QString::fromUtf8("In the region: Estimating · image still black · paused"));
    accuracy.status = {};
    QCOMPARE(accuracyText(accuracy), QString());
}

/// The sentence goes with an image that leaves the program, until it is as accurate as requested.
void TestAccuracyStatus::aPreviewSaysThatItIsOne() {
    const auto text = [](const FilmStatus& status, ErrorOf of) { return previewText({status, of}, 4); };
    QCOMPARE(text(statusOf(12), ErrorOf::film),
             QString::fromUtf8(
                 "Preview, not converged · image error ±12 of 255 grey levels (95 % of the tissue), target ±4"));
    QVERIFY(text(statusOf(12), ErrorOf::denoised).contains("denoised, image error"));
    QVERIFY(text(statusOf(12), ErrorOf::beforeDenoising)
                .contains(QString::fromUtf8("±12 of 255 grey levels before denoising")));
    QVERIFY(text({.samplesPerPixel = 31}, ErrorOf::film).startsWith("Preview, not converged"));
    QCOMPARE(text(statusOf(4), ErrorOf::film), QString());
    QCOMPARE(text(statusOf(3.9), ErrorOf::denoised), QString());
}

void TestAccuracyStatus::stepsAreToldInWords() {
    const Accuracy accuracy = accuracyAt(15);
    QCOMPARE(stepForecastText(accuracy.steps[0], accuracy.seconds), QString::fromUtf8("±32 since 3 s of rendering"));
    QCOMPARE(stepForecastText(accuracy.steps[2], accuracy.seconds),
             QString::fromUtf8("±8 in 34 s, to 95 % between 24 s and 48 s"));
    QCOMPARE(durationText(0.2), "1 s");
    QCOMPARE(durationText(90), "1.5 min");
    QCOMPARE(durationText(7200), "2.0 h");
}

void TestAccuracyStatus::onePlaceIsToldInWords() {
    constexpr float kUnknown = std::numeric_limits<float>::infinity();
    QCOMPARE(hereText({true, 11.2f, 3, 2.81f}, ErrorOf::film),
             QString::fromUtf8("This pixel ±12; mean over 1 mm ±2.9"));
    QCOMPARE(hereText({true, 11.2f, 3, 2.81f}, ErrorOf::beforeDenoising),
             QString::fromUtf8("This pixel ±12; mean over 1 mm ±2.9, before denoising"));
    QCOMPARE(hereText({true, 5.2f, 3, 2.81f}, ErrorOf::denoised), QString::fromUtf8("This pixel ±6"));
    QCOMPARE(hereText({true, 11.2f, 3, kUnknown}, ErrorOf::film),
             QString::fromUtf8("This pixel ±12; mean over 1 mm not known yet"));
    QCOMPARE(hereText({true, 11.2f, 0, 11.2f}, ErrorOf::film),
             QString::fromUtf8("This pixel ±12; it is larger than 1 mm"));
    QCOMPARE(hereText({true, kUnknown, 3, kUnknown}, ErrorOf::beforeDenoising), "This pixel: not known yet");
    QCOMPARE(hereText({false, 0, 3, 0}, ErrorOf::film), QString());
}

void TestAccuracyStatus::theAxisIsLogarithmicFromASecondToAnHour() {
    const StripAxis axis;
    QCOMPARE(axis.at(1), 0.0);
    QCOMPARE(axis.at(0), 0.0);
    QCOMPARE(axis.at(60), 0.5);
    QCOMPARE(axis.at(3600), 1.0);
    QCOMPARE(axis.at(1e9), 1.0);
    QCOMPARE(StripAxis(1, 3600.0 * 3600).at(3600), 0.5);
    QCOMPARE(StripAxis(1, std::numeric_limits<double>::infinity()).at(3600), 1.0);
    QVERIFY(StripAxis(0.1).at(0.2) > 0);  // a fast device
    QCOMPARE(StripAxis(0).at(0), 0.0);
}

void TestAccuracyStatus::labelsNeverOverlapAndKeepTheirOrder() {
    for (int seed = 0; seed < 200; ++seed) {
        std::srand(unsigned(seed));
        std::vector<StripLabel> labels;
        double middle = 0;
        for (int i = 0; i < 6; ++i)
            labels.push_back({middle += std::rand() % 120, 30.0 + std::rand() % 40, i == seed % 6 ? 1 : 0});
        placeLabels(labels, 400, 8);
        QVERIFY(labels[std::size_t(seed % 6)].shown);
        double end = -8;
        for (const StripLabel& label : labels)
            if (label.shown) {
                QVERIFY(label.left >= end + 8 && label.left + label.width <= 400);
                end = label.left + label.width;
            }
    }
}

void TestAccuracyStatus::laterStepsStandFartherRight() {
    for (const int width : {300, 800, 2600}) {
        AccuracyStrip strip;
        strip.resize(width, 40);
        strip.setAccuracy(accuracyAt(15));
        double last = 0;
        for (const double levels : kQualitySteps) {
            QVERIFY(*strip.tickOf(levels) > last && *strip.tickOf(levels) < width);
            last = *strip.tickOf(levels);
        }
        QVERIFY(strip.labels()[5].shown);  // the target's
    }
}

void TestAccuracyStatus::stepsBeyondTheHourHaveTheirPlace() {
    AccuracyStrip strip;
    strip.resize(800, 40);
    strip.setAccuracy(accuracyAt(15, 60));
    QVERIFY(*strip.tickOf(1) > *strip.tickOf(2) && *strip.tickOf(1) < 800);
}

void TestAccuracyStatus::theKnobIsDraggedToTheNearestStep() {
    AccuracyStrip strip;
    strip.resize(800, 40);
    strip.setAccuracy(accuracyAt(15));
    QSignalSpy chosen(&strip, &AccuracyStrip::targetChosen);
    const auto at = [&](double levels) { return QPoint(int(*strip.tickOf(levels)) + 3, 8); };
    QTest::mousePress(&strip, Qt::LeftButton, {}, at(1));
    QCOMPARE(chosen.count(), 0);
    QTest::mouseMove(&strip, at(8));
    test::dragOn(strip, at(8));
    QCOMPARE(chosen.takeLast().first().toDouble(), 8.0);
    QCOMPARE(strip.target(), 8.0);
    QTest::mouseRelease(&strip, Qt::LeftButton, {}, at(8));
    QTest::mouseClick(&strip, Qt::LeftButton, {}, at(4));
    QCOMPARE(chosen.takeLast().first().toDouble(), 4.0);
}

void TestAccuracyStatus::theArrowKeysMoveTheKnob() {
    AccuracyStrip strip;
    strip.setTarget(4);
    QSignalSpy chosen(&strip, &AccuracyStrip::targetChosen);
    QTest::keyClick(&strip, Qt::Key_Left);
    QCOMPARE(chosen.takeLast().first().toDouble(), 8.0);
    QTest::keyClick(&strip, Qt::Key_Right);
    QTest::keyClick(&strip, Qt::Key_Right);
    QCOMPARE(chosen.takeLast().first().toDouble(), 2.0);
    QTest::keyClick(&strip, Qt::Key_Home);
    QCOMPARE(chosen.takeLast().first().toDouble(), 32.0);
    QTest::keyClick(&strip, Qt::Key_End);
    QCOMPARE(chosen.takeLast().first().toDouble(), 1.0);
    QTest::keyClick(&strip, Qt::Key_Right);
    QCOMPARE(strip.target(), 1.0);
}

void TestAccuracyStatus::theTargetIsSetSilently() {
    AccuracyStrip strip;
    QSignalSpy chosen(&strip, &AccuracyStrip::targetChosen);
    strip.setTarget(16);
    QCOMPARE(strip.target(), 16.0);
    strip.setTarget(5);  // no step
    QCOMPARE(strip.target(), 5.0);
    QCOMPARE(chosen.count(), 0);
}

/// A target between two steps is rounded to what is displayed; the keys move it to the steps beside it.
void TestAccuracyStatus::theKnobCanStandBetweenTwoSteps() {
    AccuracyStrip strip;
    strip.resize(800, 40);
    strip.setAccuracy(accuracyAt(15));
    QSignalSpy chosen(&strip, &AccuracyStrip::targetChosen);
    const double middle = (*strip.tickOf(8) + *strip.tickOf(4)) / 2;
    QTest::mouseClick(&strip, Qt::LeftButton, {}, QPoint(int(middle), 8));
    QCOMPARE(chosen.takeLast().first().toDouble(), 6.0);  // 8 / sqrt(2)
    QVERIFY(*strip.tickOf(8) < *strip.tickOf(6) && *strip.tickOf(6) < *strip.tickOf(4));
    QVERIFY(strip.accessibleDescription().startsWith(QString::fromUtf8("±6 in ")));
    QTest::keyClick(&strip, Qt::Key_Right);
    QCOMPARE(chosen.takeLast().first().toDouble(), 4.0);
    strip.setTarget(6);
    QTest::keyClick(&strip, Qt::Key_Left);
    QCOMPARE(chosen.takeLast().first().toDouble(), 8.0);
    strip.setTarget(6);
    strip.setAccuracy(accuracyAt(5));
    QVERIFY(strip.accessibleDescription().contains("since"));
}

void TestAccuracyStatus::withoutAForecastTheKnobStays() {
    AccuracyStrip strip;
    strip.resize(800, 40);
    strip.setTarget(8);
    QVERIFY(!strip.tickOf(8));
    QTest::mouseClick(&strip, Qt::LeftButton, {}, QPoint(30, 8));
    QCOMPARE(strip.target(), 8.0);
}

void TestAccuracyStatus::theStripTellsItsValueToThoseWhoCannotSeeIt() {
    AccuracyStrip strip;
    QVERIFY(!strip.accessibleName().isEmpty());
    strip.setTarget(8);
    QCOMPARE(strip.accessibleDescription(), QString::fromUtf8("±8"));
    strip.setAccuracy(accuracyAt(15));
    QCOMPARE(strip.accessibleDescription(), QString::fromUtf8("±8 in 34 s, to 95 % between 24 s and 48 s"));
    QCOMPARE(strip.focusPolicy(), Qt::TabFocus);
}

/// The strip is filled to the right place on a screen of any pixel ratio.
void TestAccuracyStatus::theStripIsFilledUpToNow() {
    AccuracyStrip strip;
    strip.resize(800, strip.minimumSizeHint().height());
    strip.setAccuracy(accuracyAt(15));
    const QImage image = strip.grab().toImage();
    const double scale = image.devicePixelRatio();
    const QColor full = strip.palette().color(QPalette::Link), empty = strip.palette().color(QPalette::Mid);
    const auto pixel = [&](double x) { return image.pixelColor(int(x * scale), int(8 * scale)); };
    QCOMPARE(pixel(*strip.tickOf(16) - 6), full);
    QCOMPARE(pixel(*strip.tickOf(4) - 30), empty);
}

void TestAccuracyStatus::nothingIsCutOffInASmallWindow() {
    MainWindow window;
    window.resize(800, 600);
    window.accuracyStatus().setAccuracy(accuracyAt(15.2));
    window.accuracyStatus().setRemarks({"No known systematic error"});
    window.accuracyStatus().setLimit(QString::fromUtf8("Voxel size 0.96 × 0.96 × 1.5 mm"));
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QVERIFY(window.width() <= 800 && window.height() <= 600);
    int words = 0;
    for (const QLabel* label : window.accuracyStatus().findChildren<QLabel*>()) {
        if (!label->isVisible() || label->text().isEmpty())
            continue;
        ++words;
        QVERIFY2(label->width() >= label->fontMetrics().horizontalAdvance(label->text()), qPrintable(label->text()));
        QVERIFY(label->height() >= label->fontMetrics().height());
    }
    QCOMPARE(words, 3);
    const AccuracyStrip& strip = window.accuracyStatus().strip();
    QVERIFY(strip.isVisible() && strip.height() >= strip.minimumSizeHint().height() && strip.width() > 700);
    const auto shown = strip.labels();
    QVERIFY(std::all_of(shown.begin(), shown.end(), [](const StripLabel& label) { return label.shown; }));
}

}  // namespace pdr::ui

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    pdr::ui::applyTheme(application, pdr::ui::ThemeChoice::dark);
    pdr::ui::TestAccuracyStatus test;
    return QTest::qExec(&test, argc, argv);
}

#include "accuracy_status_test.moc"
