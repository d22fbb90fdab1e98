/// The camera, the background and the model in the whole window: what is clicked becomes sharp, a projection keeps its
/// standard views, each edit is one step, and another model says what it costs.

#include <QSignalSpy>
#include <QTest>

#include "app/presenters/camera_presenter.h"
#include "app/presenters/light_presenter.h"
#include "app/presenters/series_presenter.h"
#include "render/scene/edit/camera_edits.h"
#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/hand_on_window.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "ui/camera/camera_panel.h"
#include "ui/light/light_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// A window with the phantom in it.
struct CameraTrial : Trial {
    explicit CameraTrial(const QString& series) {
        openAndWait(series);
        before = document.setup();
    }
    /// Undoes one step; returns whether that restores the setup from before.
    bool undoBringsItBack() {
        document.undo();
        return !document.canUndo() && document.setup() == before;
    }

    Document& document = desktop.document();
    ui::MainWindow& window = desktop.window();
    ImageSetup before;
};

class TestCameraInWindow : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { QVERIFY(writePhantomSeries(ui::fromQt(series()))); }
    void whatIsClickedBecomesSharp();
    void aParallelViewStaysOneFromEverySide();
    void aBackgroundIsShownAsItWasChosen();
    void anotherModelSaysWhatItCosts();
    void whatIsClosedIsNotHeld();

  private:
    QString series() const { return folder_.filePath("series"); }

    QTemporaryDir folder_;
};

void TestCameraInWindow::whatIsClickedBecomesSharp() {
    CameraTrial trial(series());
    ui::Viewport& viewport = trial.window.viewport();
    QSignalSpy found(&trial.desktop.presenter<CameraPresenter>().study(), &TissueStudy::depthFound);
    emit test::the<ui::CameraPanel>(trial.window).pickingChosen(true);
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.rect().center());
    QTRY_COMPARE_WITH_TIMEOUT(found.count(), 1, test::kPatience);
    const Camera& camera = trial.document.setup().camera;
    QVERIFY(camera.apertureMm > 0);
    QCOMPARE(camera.focusMm, found.front().front().toDouble());
    const double toMiddle = glm::length(camera.targetMm - camera.eyeMm);
    QVERIFY(camera.focusMm < toMiddle && camera.focusMm > toMiddle - 150);       // the near side of the phantom
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.rect().center());  // only the one click
    QVERIFY(trial.undoBringsItBack());
    QCOMPARE(found.count(), 1);
}

void TestCameraInWindow::aParallelViewStaysOneFromEverySide() {
    CameraTrial trial(series());
    emit test::the<ui::CameraPanel>(trial.window)
        .cameraEdited(withType(trial.before.camera, Camera::Type::orthographic));
    trial.document.setView(StandardView::left);
    QVERIFY(trial.document.setup().camera.type == Camera::Type::orthographic);
    ui::Viewport& viewport = trial.window.viewport();
    drag(viewport, {300, 200}, {360, 220});
    QVERIFY(trial.document.setup().camera.type == Camera::Type::orthographic);
    trial.waitForNewest();
    QVERIFY(trial.desktop.bridge().lastFrame()->error.empty());
    trial.document.resetView();
    QVERIFY(trial.document.setup().camera == trial.before.camera);
}

void TestCameraInWindow::aBackgroundIsShownAsItWasChosen() {
    CameraTrial trial(series());
    for (const QColor colour : {QColor(110, 110, 110), QColor(250, 250, 250), QColor(20, 60, 100)}) {
        emit test::the<ui::CameraPanel>(trial.window).backgroundChosen(colour);
        trial.waitForNewest();
        const auto& frame = trial.desktop.bridge().lastFrame();
        for (int channel = 0; channel < 3; ++channel)
            QVERIFY(std::abs(int(frame->rgba[std::size_t(channel)]) - (channel == 0   ? colour.red()
                                                                       : channel == 1 ? colour.green()
                                                                                      : colour.blue())) <= 1);
        QVERIFY(trial.document.setup().look == trial.before.look);
        trial.document.undo();
    }
    QVERIFY(trial.document.setup() == trial.before);
    emit test::the<ui::CameraPanel>(trial.window).backgroundChosen(std::nullopt);
    QVERIFY(trial.document.setup().look.environment.visible);
    QVERIFY(trial.undoBringsItBack());
}

void TestCameraInWindow::anotherModelSaysWhatItCosts() {
    CameraTrial trial(series());
    ui::ModelChoice& choice = test::the<ui::LightPanel>(trial.window).model();
    QSignalSpy measured(&trial.desktop.presenter<LightPresenter>().trial(), &ModelTrial::measured);
    const auto said = [&] {
        QString all;
        for (const QLabel* label : choice.findChildren<QLabel*>())
            all += label->text();
        return all;
    };
    emit choice.modelChosen(Model::multipleScattering);
    QVERIFY(trial.document.setup().model == Model::multipleScattering);
    QCOMPARE(said(), ui::modelText(Model::multipleScattering));  // nothing that is not known
    QTRY_COMPARE_WITH_TIMEOUT(measured.count(), 1, test::kPatience);
    const double factor = measured.front()[2].toDouble(), levels = measured.front()[3].toDouble();
    QVERIFY2(factor > 0.05 && factor < 100 && levels > 1 && levels <= 256,
             qPrintable(QString("%1 %2").arg(factor).arg(levels)));
    QCOMPARE(said(),
             ui::modelText(Model::multipleScattering) + ' ' + ui::costText({Model::singleScattering, factor, levels}));
    QVERIFY(trial.undoBringsItBack());
    QCOMPARE(said(), ui::modelText(Model::singleScattering));
}

void TestCameraInWindow::whatIsClosedIsNotHeld() {
    CameraTrial trial(series());
    const std::weak_ptr<const Volume> volume = trial.document.scene().volume;
    emit test::the<ui::LightPanel>(trial.window).model().modelChosen(Model::absorption);
    trial.desktop.presenter<SeriesPresenter>().close();
    trial.frames.clear();
    QTRY_VERIFY_WITH_TIMEOUT(volume.expired(), test::kPatience);
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestCameraInWindow)
#include "camera_in_window_test.moc"
