/// Cuts in the whole window: handles appear with a key, a drag is one step to undo, Esc cancels it, and undo restores
/// the image bit by bit.

#include <QSignalSpy>
#include <QTest>

#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/hand_on_window.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "ui/cut/cut_tools.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

using Kind = CutHandle::Kind;

class TestCutInWindow : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() {
        series_ = folder_.filePath("series");
        QVERIFY(writePhantomSeries(ui::fromQt(series_)));
    }

    void aDraggedHandleIsOneStep() {
        Trial trial;
        trial.openAndWait(series_);
        Document& document = trial.desktop.document();
        ui::MainWindow& window = trial.desktop.window();
        const Film before = rendered(document);
        QVERIFY(!test::the<ui::CutTools>(window).layer().handlesShown());
        QTest::keyClick(&window, Qt::Key_C);
        QVERIFY(test::the<ui::CutTools>(window).layer().handlesShown());
        QVERIFY(!document.canUndo());  // to look is no step
        const QPoint head = handle(window, {Kind::face, 5});
        QTest::mousePress(&window.viewport(), Qt::LeftButton, {}, head);
        test::dragOn(window.viewport(), head + QPoint(0, 20));
        test::dragOn(window.viewport(), head + QPoint(0, 60));
        QVERIFY(document.setup().clip.box);
        QTest::mouseRelease(&window.viewport(), Qt::LeftButton, {}, head + QPoint(0, 60));
        const ClipBox uncut = *document.uncut(), box = *document.setup().clip.box;
        QVERIFY(box.highMm.z < uncut.highMm.z - 1);
        QCOMPARE(box.lowMm, uncut.lowMm);
        QVERIFY(!test::sameBits(rendered(document), before));
        trial.waitForNewest();
        QVERIFY(trial.frames.back()->error.empty());
        document.undo();
        QVERIFY(!document.canUndo() && document.setup().clip.empty());
        QVERIFY(test::sameBits(rendered(document), before));
        QCOMPARE(handle(window, {Kind::face, 5}), head);
    }

    void escapeGivesAGestureUp() {
        Trial trial;
        trial.openAndWait(series_);
        Document& document = trial.desktop.document();
        ui::MainWindow& window = trial.desktop.window();
        const ImageSetup before = document.setup();
        QTest::keyClick(&window, Qt::Key_C);
        const QPoint head = handle(window, {Kind::face, 5});
        QTest::mousePress(&window.viewport(), Qt::LeftButton, {}, head);
        test::dragOn(window.viewport(), head + QPoint(0, 40));
        QVERIFY(document.setup().clip.box);
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(document.setup() == before);
        QVERIFY(!document.canUndo());
        QVERIFY(test::the<ui::CutTools>(window).layer().handlesShown());
        QTest::mouseRelease(&window.viewport(), Qt::LeftButton, {}, head);
        QVERIFY(document.setup() == before);
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!test::the<ui::CutTools>(window).layer().handlesShown());
    }

    void planesComeFromTheViewAndGoWithUndoAll() {
        Trial trial;
        trial.openAndWait(series_);
        Document& document = trial.desktop.document();
        ui::MainWindow& window = trial.desktop.window();
        QTest::keyClick(&window, Qt::Key_P);
        QCOMPARE(document.setup().clip.planes.size(), std::size_t(1));
        QVERIFY(test::the<ui::CutTools>(window).layer().handlesShown());
        QVERIFY(glm::dot(document.setup().clip.planes[0].normal, document.setup().camera.forward()) < -0.999);
        for (int i = 0; i < 12; ++i)
            emit test::the<ui::CutTools>(window).panel().planeWanted(i % 3);
        QCOMPARE(document.setup().clip.planes.size(), kMostPlanes);
        QVERIFY(document.setup().clip.check());
        emit test::the<ui::CutTools>(window).uncutWanted();
        QVERIFY(document.setup().clip.empty());
        document.undo();
        QCOMPARE(document.setup().clip.planes.size(), kMostPlanes);
    }

    /// Places in one patient mean nothing in another.
    void anotherVolumeIsUncut() {
        Document document(*bundledLooks());
        QVERIFY(!document.uncut());
        document.open(test::bumpyVolume({20, 20, 20}, dvec3(1), 1));
        document.setClip(withCutOff({}, *document.uncut(), 0, 5));
        QVERIFY(!document.setup().clip.empty());
        document.open(test::bumpyVolume({20, 20, 30}, dvec3(1), 2));
        QVERIFY(document.setup().clip.empty() && document.scene().clip.empty());
    }

    void aDrawnLineIsOneStepAndEscapeForgetsIt() {
        Trial trial;
        trial.openAndWait(series_);
        Document& document = trial.desktop.document();
        ui::MainWindow& window = trial.desktop.window();
        ui::FreehandPen& pen = test::the<ui::CutTools>(window).pen();
        const Film before = rendered(document);
        QTest::keyClick(&window, Qt::Key_X);
        QVERIFY(pen.isDrawing());
        drawAround(window.viewport());
        QTest::keyClick(&window, Qt::Key_Escape);
        QVERIFY(!pen.isDrawing() && !document.canUndo());
        QTest::keyClick(&window, Qt::Key_X);
        drawAround(window.viewport());
        for (auto* button : window.viewport().findChildren<QPushButton*>())
            if (button->text() == "Remove inside")
                button->click();
        QCOMPARE(document.setup().clip.freehand.size(), std::size_t(1));
        QVERIFY(document.setup().clip.freehand[0].camera == document.setup().camera);
        QVERIFY(!pen.isDrawing());
        QVERIFY(!test::sameBits(rendered(document), before));
        trial.waitForNewest();
        QVERIFY(trial.frames.back()->error.empty());
        document.undo();
        QVERIFY(!document.canUndo());
        QVERIFY(test::sameBits(rendered(document), before));
    }

    /// Files say what is missing in them.
    void savedImagesSayWhatIsCut() {
        Trial trial;
        trial.openAndWait(series_);
        Document& document = trial.desktop.document();
        Clip clip = withCutOff({}, *document.uncut(), 2, 5);
        clip.planes = {facingPlane(document.setup().camera, *document.uncut())};
        document.setClip(clip);
        trial.waitForNewest();
        const QString file = trial.folder.filePath("cut.png");
        QSignalSpy saved(&trial.desktop.presenter<SavingPresenter>().saver(), &ImageSaver::saved);
        trial.desktop.presenter<SavingPresenter>().saver().save(file);
        QTRY_COMPARE_WITH_TIMEOUT(saved.size(), 1, test::kPatience);
        QCOMPARE(QImage(file).text("pdrender/cut"), QString("box, 1 plane"));
    }

  private:
    /// A triangle in the middle of the image.
    static void drawAround(QWidget& view) {
        const QPoint middle = view.rect().center(), corners[] = {{-40, -40}, {50, 0}, {-40, 40}};
        QTest::mousePress(&view, Qt::LeftButton, {}, middle + corners[0]);
        for (const QPoint corner : corners)
            test::dragOn(view, middle + corner);
        QTest::mouseRelease(&view, Qt::LeftButton, {}, middle + corners[2]);
    }
    static QPoint handle(ui::MainWindow& window, CutHandle handle) {
        return test::the<ui::CutTools>(window).layer().marks().placeOf(handle).value_or(QPointF(-99, -99)).toPoint();
    }

    QTemporaryDir folder_;
    QString series_;
};

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestCutInWindow)
#include "cut_in_window_test.moc"
