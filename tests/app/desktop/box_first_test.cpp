/// The box on the image, from the key to the sentence.

#include <QTest>

#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "ui/text/to_qt.h"
#include "ui/view/region_box.h"

namespace pdr::app {

class TestBoxFirst : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void aBoxIsDrawnHasItsOwnSentenceAndIsForgotten();
    void escapeDrawsNone();
    void anotherSeriesHasNone();

  private:
    QTemporaryDir folder_;
    QString series_;
};

static void drawBox(Trial& trial) {
    ui::MainWindow& window = trial.desktop.window();
    QTest::keyClick(&window, Qt::Key_B);
    QVERIFY(test::the<ui::RegionBox>(window).isDrawing());
    const QPoint middle = window.viewport().rect().center();
    QTest::mousePress(&window.viewport(), Qt::LeftButton, {}, middle - QPoint(40, 40));
    QTest::mouseRelease(&window.viewport(), Qt::LeftButton, {}, middle + QPoint(40, 40));
}

static QAction* boxFirst(Trial& trial) {
    for (QAction* action : trial.desktop.window().actions())
        if (action->shortcut() == QKeySequence(Qt::Key_B))
            return action;
    return nullptr;
}

void TestBoxFirst::initTestCase() {
    series_ = folder_.filePath("series");
    const Result<void> written = writePhantomSeries(ui::fromQt(series_), "Head of a phantom");
    QVERIFY2(written, written ? "" : written.error().text().c_str());
}

void TestBoxFirst::aBoxIsDrawnHasItsOwnSentenceAndIsForgotten() {
    Trial trial;
    trial.openAndWait(series_);
    const std::size_t scene = trial.desktop.document().scene().revision;
    drawBox(trial);
    const auto last = [&] { return trial.frames.back(); };
    QTRY_VERIFY_WITH_TIMEOUT(last()->region && !last()->region->reached, test::kPatience);
    QVERIFY(boxFirst(trial)->isChecked());
    const QSize view = trial.desktop.window().viewport().size();
    const dvec2 middle = (last()->region->region.from + last()->region->region.to) / 2.0;
    const dvec2 sides = last()->region->region.to - last()->region->region.from;
    QVERIFY(glm::length(middle - 0.5) < 0.01);
    QVERIFY(std::abs(sides.x * view.width() - 80) < 2 && std::abs(sides.y * view.height() - 80) < 2);
    QTRY_VERIFY_WITH_TIMEOUT(trial.said().startsWith("In the region: "), test::kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(std::isfinite(last()->region->status.displayError), test::kPatience);
    QVERIFY(trial.said().contains("for the region"));
    QTRY_VERIFY_WITH_TIMEOUT(last()->status.mostSamplesPerPixel > last()->status.samplesPerPixel, test::kPatience);
    // As good as is wanted of it, all of the image is spoken of again.
    trial.desktop.bridge().setStop({.levels = 32});
    QTRY_VERIFY_WITH_TIMEOUT(last()->region->reached, test::kPatience);
    QVERIFY(!trial.said().startsWith("In the region: "));
    QVERIFY(trial.said().contains(QString::fromUtf8("in the region ±")));
    QTest::keyClick(&trial.desktop.window(), Qt::Key_B);
    QTRY_VERIFY_WITH_TIMEOUT(!last()->region, test::kPatience);
    QVERIFY(!boxFirst(trial)->isChecked() && !trial.said().contains("box"));
    QCOMPARE(trial.desktop.document().scene().revision, scene);
}

void TestBoxFirst::escapeDrawsNone() {
    Trial trial;
    trial.openAndWait(series_);
    QTest::keyClick(&trial.desktop.window(), Qt::Key_B);
    QVERIFY(boxFirst(trial)->isChecked());
    QTest::keyClick(&trial.desktop.window(), Qt::Key_Escape);
    QVERIFY(!boxFirst(trial)->isChecked() && !test::the<ui::RegionBox>(trial.desktop.window()).isDrawing());
}

void TestBoxFirst::anotherSeriesHasNone() {
    Trial trial;
    trial.openAndWait(series_);
    drawBox(trial);
    QTRY_VERIFY_WITH_TIMEOUT(trial.frames.back()->region.has_value(), test::kPatience);
    trial.frames.clear();
    trial.openAndWait(series_);
    QVERIFY(!trial.frames.back()->region && !boxFirst(trial)->isChecked());
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestBoxFirst)
#include "box_first_test.moc"
