/// The tissue in the whole window: the histogram comes by itself, edits on the panel and on the image change the
/// image, each gesture is one step, and undo brings back the same bits.

#include <QSignalSpy>
#include <QTest>

#include "app/presenters/series_presenter.h"
#include "app/presenters/tissue_presenter.h"
#include "render/scene/edit/tissue_channels.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/hand_on_window.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "tests/support/patience.h"
#include "tests/support/scenes/plates.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

class TestTissueInWindow : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase();
    void theHistogramComesWithTheVolumeAndGoesWithIt();
    void anEditedNodeIsOneStepAndUndoBringsTheSameBits();
    void aDragOnTheImageShiftsAndWidens();
    void aClickOnTheImageShowsTheTissueThere();
    void theButtonPicksOnce();
    void besideTheAnatomyNothingIsPicked();
    void inFogNothingIsPicked();
    void ofSeveralLayersTheHeaviestIsTaken();
    void whatIsClosedIsNotHeld();
    void nothingIsToldOfWhatIsClosed();

  private:
    QTemporaryDir folder_;
    QString series_;
};

void TestTissueInWindow::initTestCase() {
    series_ = folder_.filePath("series");
    QVERIFY(writePhantomSeries(ui::fromQt(series_)));
}

void TestTissueInWindow::theHistogramComesWithTheVolumeAndGoesWithIt() {
    Trial trial;
    QSignalSpy found(&trial.desktop.presenter<TissuePresenter>().study(), &TissueStudy::histogramFound);
    trial.openAndWait(series_);
    QTRY_COMPARE_WITH_TIMEOUT(found.count(), 1, test::kPatience);
    const auto histogram = found.front().front().value<std::shared_ptr<const Histogram>>();
    QCOMPARE(histogram->total(), 64.0 * 57 * 64);
    const ui::PlotView& view = test::the<ui::TissuePanel>(trial.desktop.window()).editor().view();
    QVERIFY(view.lowHu() < histogram->percentile(0.001) && view.highHu() > histogram->percentile(0.999));
}

void TestTissueInWindow::anEditedNodeIsOneStepAndUndoBringsTheSameBits() {
    Trial trial;
    trial.openAndWait(series_);
    Document& document = trial.desktop.document();
    const Look before = document.setup().look;
    const Film image = rendered(document);
    ui::CurveEditor& editor = test::the<ui::TissuePanel>(trial.desktop.window()).editor();
    editor.resize(400, 200);
    const CurvePoint point = editor.points()[5];
    const QPoint place = editor.view().at(double(point.hu), double(point.value)).toPoint();
    drag(editor, place, place + QPoint(20, 40), {});
    QVERIFY(document.setup().look != before);
    QVERIFY(document.setup().look.transferFunction.check());
    QCOMPARE(document.look(), -1);
    QVERIFY(!test::sameBits(rendered(document), image));
    trial.waitForNewest();
    QVERIFY(trial.desktop.bridge().lastFrame()->error.empty());

    document.undo();
    QVERIFY(!document.canUndo());
    QVERIFY(document.setup().look == before);
    QVERIFY(test::the<ui::TissuePanel>(trial.desktop.window()).transferFunction() == before.transferFunction);
    QVERIFY(test::sameBits(rendered(document), image));
    document.redo();
    QVERIFY(document.setup().look != before);
}

void TestTissueInWindow::aDragOnTheImageShiftsAndWidens() {
    Trial trial;
    trial.openAndWait(series_);
    Document& document = trial.desktop.document();
    const ImageSetup before = document.setup();
    const TransferFunction& nodes = document.setup().look.transferFunction;
    ui::Viewport& viewport = trial.desktop.window().viewport();
    const QPoint middle = viewport.rect().center();
    drag(viewport, middle, middle + QPoint(viewport.height() / 5, 0), Qt::ControlModifier);
    for (std::size_t i = 0; i < nodes.nodes.size(); ++i)
        QVERIFY(std::abs(nodes.nodes[i].hu - before.look.transferFunction.nodes[i].hu - 200) < 4);
    QVERIFY(document.setup().camera == before.camera);
    const double width = double(nodes.nodes.back().hu - nodes.nodes.front().hu);
    drag(viewport, middle, middle - QPoint(0, viewport.height() / 2), Qt::ControlModifier);
    QVERIFY(std::abs(double(nodes.nodes.back().hu - nodes.nodes.front().hu) / width - 2) < 0.1);
    document.undo();
    document.undo();
    QVERIFY(!document.canUndo());
    QVERIFY(document.setup() == before);
}

void TestTissueInWindow::aClickOnTheImageShowsTheTissueThere() {
    Trial trial;
    trial.openAndWait(series_);
    Document& document = trial.desktop.document();
    const Look before = document.setup().look;
    QSignalSpy found(&trial.desktop.presenter<TissuePresenter>().study(), &TissueStudy::tissueFound);
    QTest::mouseClick(&trial.desktop.window().viewport(), Qt::LeftButton, Qt::ControlModifier,
                      trial.desktop.window().viewport().rect().center());
    QTRY_COMPARE_WITH_TIMEOUT(found.count(), 1, test::kPatience);
    const float hu = std::round(found.front().front().value<TissueBehind>().hu);
    const TransferFunction& after = document.setup().look.transferFunction;
    const float top = heightOf(curveOf(before.transferFunction, TissueChannel::opacity));
    QVERIFY(std::abs(after.opacityAt(hu) - top) < 1e-5f);
    for (float other = -1024; other < 3000; other += 3)
        QVERIFY(after.opacityAt(other) >= before.transferFunction.opacityAt(other) - 1e-5f);
    document.undo();
    QVERIFY(document.setup().look == before && !document.canUndo());
}

void TestTissueInWindow::theButtonPicksOnce() {
    Trial trial;
    trial.openAndWait(series_);
    ui::MainWindow& window = trial.desktop.window();
    const Camera camera = trial.desktop.document().setup().camera;
    QSignalSpy picked(&trial.desktop.presenter<TissuePresenter>().pickTool(), &ui::PickTool::picked);
    const QPoint middle = window.viewport().rect().center();
    emit test::the<ui::TissuePanel>(window).pickingChosen(true);
    drag(window.viewport(), middle, middle + QPoint(50, 0), {});
    QCOMPARE(picked.count(), 1);
    QVERIFY(trial.desktop.document().setup().camera == camera);
    drag(window.viewport(), middle, middle + QPoint(50, 0), {});
    QCOMPARE(picked.count(), 1);
    QVERIFY(trial.desktop.document().setup().camera != camera);
    emit test::the<ui::TissuePanel>(window).pickingChosen(true);
    QTest::keyClick(&window, Qt::Key_Escape);
    QTest::mouseClick(&window.viewport(), Qt::LeftButton, {}, middle);
    QCOMPARE(picked.count(), 1);
}

void TestTissueInWindow::besideTheAnatomyNothingIsPicked() {
    Trial trial;
    trial.openAndWait(series_);
    QSignalSpy nothing(&trial.desktop.presenter<TissuePresenter>().study(), &TissueStudy::nothingFound);
    QTest::mouseClick(&trial.desktop.window().viewport(), Qt::LeftButton, Qt::ControlModifier, {3, 3});
    QTRY_COMPARE_WITH_TIMEOUT(nothing.count(), 1, test::kPatience);
    QVERIFY(!trial.desktop.document().canUndo());
    QVERIFY(trial.said().contains("No tissue at this point: 100 % of the light passes."));
}

void TestTissueInWindow::inFogNothingIsPicked() {
    Trial trial;
    trial.openAndWait(series_);
    Document& document = trial.desktop.document();
    const TransferFunction fog{0.01f, {{.hu = -200, .opacity = 0}, {.hu = -100, .opacity = 1}}};
    emit test::the<ui::TissuePanel>(trial.desktop.window()).transferFunctionEdited(fog, false);
    const ImageSetup before = document.setup();
    ui::Viewport& viewport = trial.desktop.window().viewport();
    QSignalSpy nothing(&trial.desktop.presenter<TissuePresenter>().study(), &TissueStudy::nothingFound);
    QTest::mouseClick(&viewport, Qt::LeftButton, Qt::ControlModifier, viewport.rect().center());
    QTRY_COMPARE_WITH_TIMEOUT(nothing.count(), 1, test::kPatience);
    QVERIFY(document.setup() == before);
    QVERIFY(trial.said().contains("What is seen here is spread over"));
}

void TestTissueInWindow::ofSeveralLayersTheHeaviestIsTaken() {
    const double front = 0.3, back = 0.45;
    const Scene scene = test::platesScene({{150, test::depthFor(front)}, {60, test::depthFor(back, front)}});
    TissueStudy study;
    QSignalSpy depth(&study, &TissueStudy::depthFound), which(&study, &TissueStudy::layerTaken);
    study.measureDepth(scene, {0.56, 0.56});
    QTRY_COMPARE_WITH_TIMEOUT(which.count(), 1, test::kPatience);
    QCOMPARE(depth.count(), 1);
    QVERIFY(std::abs(depth.front().front().toDouble() - (1100 - test::heightOf(60))) < 0.5);
    QCOMPARE(which.front().front().value<Text>(),
             "the light here stops at 2 depths: the one with the most, 45 %, was taken");
}

/// Another series is read when the volume before is freed: also while its tissue is looked at.
void TestTissueInWindow::whatIsClosedIsNotHeld() {
    Trial trial;
    trial.openAndWait(series_);
    const std::weak_ptr<const Volume> volume = trial.desktop.document().scene().volume;
    QTest::mouseClick(&trial.desktop.window().viewport(), Qt::LeftButton, Qt::ControlModifier,
                      trial.desktop.window().viewport().rect().center());
    trial.desktop.presenter<SeriesPresenter>().close();
    trial.frames.clear();
    QTRY_VERIFY_WITH_TIMEOUT(volume.expired(), test::kPatience);
    trial.openAndWait(series_);
    QVERIFY(!trial.desktop.document().canUndo());
}

/// A histogram that was found while the window was busy is dropped, too.
void TestTissueInWindow::nothingIsToldOfWhatIsClosed() {
    TissueStudy study;
    QSignalSpy found(&study, &TissueStudy::histogramFound);
    study.setVolume(test::bumpyVolume({20, 20, 20}, dvec3(1), 1));
    QTest::qSleep(200);
    study.setVolume(nullptr);
    QTest::qWait(50);
    QCOMPARE(found.count(), 0);
    study.setVolume(test::bumpyVolume({10, 10, 10}, dvec3(1), 1));
    QTRY_COMPARE_WITH_TIMEOUT(found.count(), 1, test::kPatience);
    QCOMPARE(found.front().front().value<std::shared_ptr<const Histogram>>()->total(), 1000.0);
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestTissueInWindow)
#include "tissue_in_window_test.moc"
#include "ui/tissue/tissue_panel.h"
