/// The accuracy panel: where its points stand, what it says, and how it is opened.

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "tests/support/desktop/contrast.h"
#include "tests/support/desktop/the.h"
#include "tests/support/desktop/whole_window.h"
#include "ui/accuracy/accuracy_panel.h"
#include "ui/accuracy/error_marks.h"
#include "ui/text/status_text.h"
#include "ui/theme/theme.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

constexpr double kUnknown = std::numeric_limits<double>::infinity();

class TestAccuracyPanel : public QObject {
    Q_OBJECT

  private slots:
    void bothAxesAreLogarithmic();
    void theAxesHaveRoomForWhatWasMeasured();
    void independentSamplesFallByHalfInFourTimesTheTime();
    void whatWasMeasuredStandsInItsPlace();
    void whatIsForetoldIsHatchedFromNowOn();
    void nodesThatCameAndWentAreMarked();
    void noiseAndWhatIsNotNoiseAreTwoSentences();
    void theLimitThatComesFirstIsTold();
    void aRuleIsTypedInThreeFields();
    void samplesThatWereLeftOutAreCounted();
    void itIsFoldedAwayUntilTheSentenceIsClicked();
    void itHasAKeyAndLeavesTheImageItsPart();
    void theImageAloneIsAlone();
};

static const QRectF kArea(50, 10, 400, 120);

/// Returns errors that fall as 1 / sqrt(t) from 32 levels at 2 s.
static std::vector<ErrorPoint> fall(int points) {
    std::vector<ErrorPoint> all;
    for (int i = 0; i < points; ++i)
        all.push_back({2 * std::pow(4, i), 32 / std::pow(2, i), 0.01});
    return all;
}

static Accuracy accuracyNow() {
    Accuracy accuracy{{.samplesPerPixel = 64, .relativeError = 0.071, .displayError = 8, .tissuePixels = 100}};
    accuracy.points = fall(3);
    accuracy.seconds = accuracy.points.back().seconds;
    for (const double levels : kQualitySteps) {
        const double seconds = 2 * std::pow(32 / levels, 2);
        const bool reached = levels >= 8;
        accuracy.steps.push_back({levels, reached, {seconds, reached ? seconds : 0.7 * seconds, 1.5 * seconds}});
    }
    return accuracy;
}

void TestAccuracyPanel::bothAxesAreLogarithmic() {
    const ErrorAxes axes(kArea, {}, 0);
    QCOMPARE(axes.at(1, 64), kArea.topLeft());
    QCOMPARE(axes.at(3600, 1), kArea.bottomRight());
    QCOMPARE(axes.at(60, 8), kArea.center());
    QCOMPARE(axes.at(0, 1000), kArea.topLeft());
    QCOMPARE(axes.levels(), (std::vector<double>{1, 2, 4, 8, 16, 32, 64}));
    QCOMPARE(axes.moments(), (std::vector<double>{1, 10, 60, 600, 3600}));
}

void TestAccuracyPanel::theAxesHaveRoomForWhatWasMeasured() {
    const ErrorAxes axes(kArea, {{0.1, 100, 1}, {5, 0.6, 0.1}}, 40'000);
    QCOMPARE(axes.at(0.1, 128), kArea.topLeft());
    QCOMPARE(axes.at(40'000, 0.5), kArea.bottomRight());
    QCOMPARE(axes.levels().size(), std::size_t(9));
    QCOMPARE(axes.moments().front(), 0.1);
    QCOMPARE(axes.moments().back(), 36'000.0);
}

void TestAccuracyPanel::independentSamplesFallByHalfInFourTimesTheTime() {
    const ErrorAxes axes(kArea, fall(3), 0);
    const QLineF line = axes.rootLine({60, 8, 0});
    for (const auto& [seconds, levels] : {std::pair(60.0, 8.0), {240.0, 4.0}, {15.0, 16.0}}) {
        const QPointF place = axes.at(seconds, levels);
        QVERIFY(std::fabs(line.pointAt((place.x() - line.x1()) / line.dx()).y() - place.y()) < 1e-9);
    }
    QVERIFY(kArea.adjusted(-1e-9, -1e-9, 1e-9, 1e-9).contains(line.p1()) && line.x2() <= kArea.right() + 1e-9);
}

static QImage shot(ErrorPlot& plot) {
    plot.resize(500, 160);
    return plot.grab().toImage().scaled(500, 160);
}

void TestAccuracyPanel::whatWasMeasuredStandsInItsPlace() {
    ErrorPlot plot;
    plot.setAccuracy(accuracyNow(), 4);
    const QImage image = shot(plot);
    const auto colourAt = [&](const ErrorPoint& point) {
        return image.pixelColor(plot.axes().at(point.seconds, point.levels).toPoint());
    };
    const std::vector<ErrorPoint> points = fall(3);
    const QColor measured = plot.palette().color(QPalette::Link), now = plot.palette().color(QPalette::WindowText);
    QCOMPARE(colourAt(points[0]), measured);
    QCOMPARE(colourAt(points[1]), measured);
    QCOMPARE(colourAt(points[2]), now);
    QVERIFY(plot.accessibleDescription().startsWith("target: ±4; ±32 since"));
}

/// Returns how many pixels along the height of ±2 differ from those of an empty plot.
static int marksAt(double levels, const Accuracy& accuracy, double from, double to) {
    ErrorPlot plot;
    plot.setAccuracy(accuracy, 1);
    const QImage with = shot(plot);
    const ErrorAxes axes = plot.axes();
    Accuracy past = accuracy;
    past.steps.clear();
    plot.setAccuracy(past, 1);
    const QImage without = shot(plot);
    int marks = 0;
    for (int y = int(axes.yOf(levels)) - 4; y < int(axes.yOf(levels)) + 4; ++y)
        for (int x = int(axes.xOf(from)); x < int(axes.xOf(to)); ++x)
            marks += with.pixel(x, y) != without.pixel(x, y);
    return marks;
}

void TestAccuracyPanel::whatIsForetoldIsHatchedFromNowOn() {
    const Accuracy accuracy = accuracyNow();  // ±2 in 512 s, 358 to 768 s
    QVERIFY(marksAt(2, accuracy, 360, 760) > 20);
    QCOMPARE(marksAt(2, accuracy, 40, 250), 0);
    QCOMPARE(marksAt(2, accuracy, 1200, 3500), 0);
    QCOMPARE(marksAt(16, accuracy, 2, 30), 0);
    Accuracy atLeast = accuracy;
    for (QualityStep& step : atLeast.steps)
        if (!step.reached)
            step.seconds = {step.seconds.low, step.seconds.low, kUnknown};
    QVERIFY(marksAt(2, atLeast, 1200, 3500) > 20);
}

/// Marks stand where nodes joined or left, differ in shape, and are named under the pointer.
void TestAccuracyPanel::nodesThatCameAndWentAreMarked() {
    ErrorPlot plot;
    plot.setAccuracy(accuracyNow(), 1);
    const QImage before = shot(plot);
    const PlotEvents events{{4, "gpu-07 joined", true}, {20, "gpu-07 was lost", false}};
    plot.setEvents(events);
    const QImage image = shot(plot);
    const ErrorAxes axes = plot.axes();
    const auto mark = [&](double seconds) { return QPointF(axes.xOf(seconds), axes.area().bottom() - 5).toPoint(); };
    const QPalette palette = plot.palette();
    QCOMPARE(image.pixelColor(mark(4)), palette.color(QPalette::WindowText));
    QVERIFY(test::contrast(image.pixelColor(mark(20)), palette.color(QPalette::WindowText)) >= 4.5);  // hollow
    for (const double seconds : {4.0, 20.0})
        QVERIFY(image.copy(QRect(mark(seconds) - QPoint(5, 5), QSize(10, 10))) !=
                before.copy(QRect(mark(seconds) - QPoint(5, 5), QSize(10, 10))));
    const QRect upperRight(300, 2, 190, 16);
    QVERIFY(image.copy(upperRight) != before.copy(upperRight));
    QCOMPARE(marksAt(mark(4), axes, events), QString("gpu-07 joined"));
    QCOMPARE(marksAt(mark(20) + QPoint(4, -20), axes, events), QString("gpu-07 was lost"));
    QCOMPARE(marksAt(mark(9), axes, events), QString());
    QVERIFY(plot.accessibleDescription().endsWith("gpu-07 joined; gpu-07 was lost"));
    plot.setEvents({});
    QVERIFY(shot(plot) == before);
}

void TestAccuracyPanel::noiseAndWhatIsNotNoiseAreTwoSentences() {
    Accuracy accuracy = accuracyNow();
    QCOMPARE(noiseText(accuracy), "±8 levels for 95 % of the tissue; 8 % of its light");
    accuracy.status.displayError = kUnknown;
    QCOMPARE(noiseText(accuracy), "not known yet");
    QCOMPARE(noiseText({}), QString());

    AccuracyPanel panel;
    panel.setAccuracy(accuracyNow(), {.levels = 4});
    panel.setBias({"denoised", "stretched"});
    panel.setMaking("64 samples on the CPU");
    QStringList facts;
    for (const QLabel* label : panel.findChildren<QLabel*>())
        if (!label->accessibleName().isEmpty())
            facts << label->accessibleName() + ": " + label->text();
    QCOMPARE(facts, QStringList({QString::fromUtf8("Limit reached first: ±4 comes first: in 1.6 min, with 256 samples"),
                                 "Noise: ±8 levels for 95 % of the tissue; 8 % of its light",
                                 "Systematic error: denoised\nstretched", "Invalid samples: No sample was left out",
                                 "Rendered on: 64 samples on the CPU"}));
    panel.clear();
    for (const QLabel* label : panel.findChildren<QLabel*>())
        QVERIFY(label->accessibleName().isEmpty() || label->text().isEmpty());
    QCOMPARE(panel.plot().target(), 4.0);
}

void TestAccuracyPanel::theLimitThatComesFirstIsTold() {
    const Accuracy accuracy = accuracyNow();
    const auto told = [&](const StopRule& rule) { return stopText(rule, accuracy); };
    QVERIFY2(told({.levels = 2, .seconds = 60}).startsWith("the time comes first: in "),
             qPrintable(told({.levels = 2, .seconds = 60})));
    QVERIFY(told({.levels = 2, .samples = 100}).startsWith("the samples come first: 100 in "));
    QVERIFY(told({.levels = 2, .seconds = 1e6, .samples = 10'000'000}).startsWith(QString::fromUtf8("±2 comes first")));
    Accuracy held = accuracy;
    held.holding = Holding::reached;
    QVERIFY(stopText({.levels = 8}, held).startsWith("stopped after ") &&
            stopText({}, held).endsWith("with 64 samples"));
    QCOMPARE(stopText({}, {{.samplesPerPixel = 40}}), "which of them comes first is not known yet");
}

void TestAccuracyPanel::aRuleIsTypedInThreeFields() {
    StopRow row;
    QSignalSpy chosen(&row, &StopRow::ruleChosen);
    row.setRule({.levels = 2.5, .seconds = 90, .samples = 300});
    QVERIFY(row.rule() == (StopRule{.levels = 2.5, .seconds = 90, .samples = 300}));
    row.setRule({});
    QVERIFY(row.rule() == StopRule{} && chosen.isEmpty());
    const auto fields = row.findChildren<QAbstractSpinBox*>();
    QCOMPARE(fields.size(), 3);
    for (QAbstractSpinBox* field : fields) {
        QVERIFY(!field->accessibleName().isEmpty());
        field->selectAll();
        QTest::keyClicks(field, "12");
        QTest::keyClick(field, Qt::Key_Return);
    }
    QCOMPARE(chosen.count(), 3);  // not with each digit
    QVERIFY(row.rule() == (StopRule{.levels = 12, .seconds = 12, .samples = 12}));
}

void TestAccuracyPanel::samplesThatWereLeftOutAreCounted() {
    FilmStatus status{.samplesPerPixel = 9};
    QCOMPARE(healthText(status), "No sample was left out");
    status.health.add(Fault::notANumber, 3, 4);
    status.health.add(Fault::cutPath, 3, 4);
    QCOMPARE(healthText(status), "1 samples left out: not a number\n1 light paths cut off at their last allowed event");
    QCOMPARE(healthText({}), QString());
}

static void activate(MainWindow& window) {
    window.resize(1100, 700);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    window.viewport().setFocus();
}

void TestAccuracyPanel::itIsFoldedAwayUntilTheSentenceIsClicked() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    QVERIFY(!test::the<AccuracyPanel>(window).isVisible());
    window.accuracyStatus().setAccuracy(accuracyNow());
    const auto* sentence = window.status().findChild<QLabel*>();
    QVERIFY(sentence->text().startsWith("Good for planning"));
    const QPoint place = sentence->mapTo(&window.status(), QPoint(30, sentence->height() / 2));
    QTest::mouseClick(&window.status(), Qt::LeftButton, {}, place);
    QVERIFY(test::the<AccuracyPanel>(window).isVisible());
    QTest::mouseClick(&window.status(), Qt::LeftButton, {}, place);
    QVERIFY(!test::the<AccuracyPanel>(window).isVisible());
    QTest::mouseClick(&window.status(), Qt::RightButton, {}, place);
    QVERIFY(!test::the<AccuracyPanel>(window).isVisible());
}

void TestAccuracyPanel::itHasAKeyAndLeavesTheImageItsPart() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    QTest::keyClick(&window.viewport(), Qt::Key_E, Qt::ShiftModifier);
    QVERIFY(test::the<AccuracyPanel>(window).isVisible());
    QTRY_VERIFY(window.viewport().height() >= 0.6 * window.height());
    QVERIFY(test::the<AccuracyPanel>(window).plot().height() >= 80);
    QTest::keyClick(&window.viewport(), Qt::Key_E, Qt::ShiftModifier);
    QVERIFY(!test::the<AccuracyPanel>(window).isVisible());
}

void TestAccuracyPanel::theImageAloneIsAlone() {
    const test::WholeWindow whole;
    MainWindow& window = whole.window;
    activate(window);
    QTest::keyClick(&window.viewport(), Qt::Key_E, Qt::ShiftModifier);
    QTest::keyClick(&window, Qt::Key_F11);
    QVERIFY(!test::the<AccuracyPanel>(window).isVisible());
    QTest::keyClick(&window, Qt::Key_F11);
    QVERIFY(test::the<AccuracyPanel>(window).isVisible());
}

}  // namespace pdr::ui

int main(int argc, char** argv) {
    QApplication application(argc, argv);
    pdr::ui::applyTheme(application, pdr::ui::ThemeChoice::dark);
    pdr::ui::TestAccuracyPanel test;
    return QTest::qExec(&test, argc, argv);
}

#include "accuracy_panel_test.moc"
