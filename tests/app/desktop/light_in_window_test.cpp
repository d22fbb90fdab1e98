/// The lights in the whole window: edits on the panel and on the image change the image, each gesture is one step,
/// undo brings back the same bits, and the handles stay with what the lights are tied to.

#include <QTest>

#include "tests/support/desktop/desktop_trial.h"
#include "tests/support/desktop/hand_on_window.h"
#include "tests/support/desktop/named_widget.h"
#include "tests/support/desktop/the.h"
#include "tests/support/dicom/phantom_series.h"
#include "ui/light/light_panel.h"
#include "ui/text/to_qt.h"

namespace pdr::app {

/// A window with the phantom in it.
struct LightTrial : Trial {
    explicit LightTrial(const QString& series) { openAndWait(series); }
    Document& document = desktop.document();
    ui::LightPanel& panel = test::the<ui::LightPanel>(desktop.window());
};

class TestLightInWindow : public QObject {
    Q_OBJECT

  private slots:
    void initTestCase() { QVERIFY(writePhantomSeries(ui::fromQt(series()))); }
    void aDragOnTheBallIsOneStepAndUndoBringsTheSameBits();
    void aDragOnTheImageTurnsAllLights();
    void whatIsNotShownIsSaidAsLongAsItIsTrue();
    void aRigIsOneStep();
    void handlesStayWithWhatTheLightsAreTiedTo();

  private:
    QString series() const { return folder_.filePath("series"); }

    QTemporaryDir folder_;
};

void TestLightInWindow::aDragOnTheBallIsOneStepAndUndoBringsTheSameBits() {
    LightTrial trial(series());
    const Look before = trial.document.setup().look;
    const Film image = rendered(trial.document);
    ui::LightSphere& sphere = trial.panel.sphere();
    sphere.resize(180, 180);
    const QPoint handle = sphere.handleOf(sphere.lamp().from).toPoint();
    drag(sphere, handle, handle + QPoint(60, 30));
    QVERIFY(trial.document.setup().look.rig != before.rig);
    QVERIFY(!test::sameBits(rendered(trial.document), image));
    trial.waitForNewest();
    QVERIFY(trial.desktop.bridge().lastFrame()->error.empty());
    trial.document.undo();
    QVERIFY(!trial.document.canUndo());
    QVERIFY(trial.document.setup().look == before);
    QVERIFY(test::sameBits(rendered(trial.document), image));
    QVERIFY((sphere.handleOf(sphere.lamp().from).toPoint() - handle).manhattanLength() <= 1);
}

void TestLightInWindow::aDragOnTheImageTurnsAllLights() {
    LightTrial trial(series());
    const ImageSetup before = trial.document.setup();
    ui::Viewport& viewport = trial.desktop.window().viewport();
    const QPoint middle = viewport.rect().center();
    drag(viewport, middle, middle + QPoint(viewport.height() / 4, 0), Qt::ShiftModifier, Qt::RightButton);
    QVERIFY(trial.document.setup().camera == before.camera);
    const LightRig turned = pdr::turned(before.look.rig, {0.25, 0}, before.camera);
    for (std::size_t i = 0; i < turned.panels.size(); ++i)
        QVERIFY(glm::length(trial.document.setup().look.rig.panels[i].from - turned.panels[i].from) < 0.02);
    trial.document.undo();
    QVERIFY(!trial.document.canUndo());
    QVERIFY(trial.document.setup() == before);
}

/// Other light shows the same tissue; another curve may not.
void TestLightInWindow::whatIsNotShownIsSaidAsLongAsItIsTrue() {
    LightTrial trial(series());
    const QLabel& says = test::named<QLabel>(trial.desktop.window(), "What this look does not show");
    const QString sentence = says.text();
    QVERIFY(!sentence.isEmpty());
    Look look = trial.document.setup().look;
    look.rig.panels[0].radiance *= 0.5f;
    trial.document.setLook(look);
    QCOMPARE(trial.document.look(), -1);
    QCOMPARE(says.text(), sentence);
    look.transferFunction.nodes.back().opacity *= 0.5f;
    trial.document.setLook(look);
    QVERIFY(says.text().isEmpty());
    trial.document.undo();
    QCOMPARE(says.text(), sentence);
}

void TestLightInWindow::aRigIsOneStep() {
    LightTrial trial(series());
    const Lighting before = trial.panel.lighting();
    for (QPushButton* button : trial.panel.findChildren<QPushButton*>())
        if (button->text() == "Sky")
            button->click();
    QVERIFY(nameOf(trial.document.setup().look.rig) == NamedRig::sky);
    QVERIFY(trial.document.setup().look.environment.nadir.has_value());
    trial.document.undo();
    QVERIFY(!trial.document.canUndo());
    QVERIFY(trial.panel.lighting() == before);
}

void TestLightInWindow::handlesStayWithWhatTheLightsAreTiedTo() {
    LightTrial trial(series());
    ui::LightSphere& sphere = trial.panel.sphere();
    const dvec3 key = sphere.lamp().from;
    trial.document.setView(StandardView::left);
    QVERIFY(glm::length(sphere.lamp().from - key) < 1e-9);  // the view's
    Lighting tied = trial.panel.lighting();
    tied.rig = tiedTo(tied.rig, LightRig::Follows::patient, trial.document.setup().camera);
    emit trial.panel.lightingEdited(tied, false);
    QVERIFY(glm::length(sphere.lamp().from - key) < 1e-9);
    trial.document.setView(StandardView::right);
    QVERIFY(glm::length(sphere.lamp().from - dvec3(-key.x, key.y, -key.z)) < 1e-9);
}

}  // namespace pdr::app

QTEST_MAIN(pdr::app::TestLightInWindow)
#include "light_in_window_test.moc"
