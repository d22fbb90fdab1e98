/// What steps to undo are called: each by what it changed, a gesture as a whole.

#include <QTest>

#include "render/scene/orbit.h"
#include "tests/support/desktop/told_document.h"

namespace pdr::app {

class TestStepName : public QObject {
    Q_OBJECT

  private slots:
    void eachEditHasItsName_data();
    void eachEditHasItsName();
    void theTableIsNamedByWhatWasDone();
    void measuringMarkingAndNamingAreToldApart();
    void aGestureIsCalledByAllOfIt();
    void aStepKeepsItsNameBackAndForth();
    void aChangedLookIsNotAChosenOne();
    void namesThatBeginAlikeAreTwoLooks();
    void whatChangesSeveralThingsSaysSo();
    void withoutAStepThereIsOnlyTheWord();
};

using Edit = void (*)(Document&);

void TestStepName::eachEditHasItsName_data() {
    QTest::addColumn<Edit>("edit");
    QTest::addColumn<QString>("undo");
    const auto row = [](const char* undo, Edit edit) { QTest::newRow(undo) << edit << QString(undo); };
    row("Undo turning the view", [](Document& d) { d.setView(StandardView::left); });
    row("Undo moving the view", [](Document& d) {
        Camera camera = d.setup().camera;
        camera.eyeMm += dvec3(5, 0, 0);
        camera.targetMm += dvec3(5, 0, 0);
        d.setCamera(camera, false);
    });
    row("Undo zooming", [](Document& d) {
        Camera camera = d.setup().camera;
        camera.eyeMm += 10. * camera.forward();
        d.setCamera(camera, false);
    });
    row("Undo changing the lens", [](Document& d) {
        Camera camera = d.setup().camera;
        camera.apertureMm = 3;
        d.setCamera(camera, false);
    });
    row("Undo choosing a look", [](Document& d) { d.chooseLook(1); });
    row("Undo changing the brightness", [](Document& d) { d.setBrightness(1); });
    row("Undo changing the background", [](Document& d) { d.setBackground(vec3(1)); });
    row("Undo editing the tissue", [](Document& d) {
        Look look = d.setup().look;
        look.transferFunction.nodes = {{7, 0.5f}};
        d.setLook(look);
    });
    row("Undo changing the light", [](Document& d) {
        Look look = d.setup().look;
        look.rig.panels = standardPanels(3, 0.3f, 0.5f);
        d.setLook(look);
    });
    row("Undo cutting", [](Document& d) {
        ImageSetup setup = d.setup();
        setup.clip.planes.emplace_back();
        d.setSetup(setup);
    });
    row("Undo choosing an optical model", [](Document& d) {
        ImageSetup setup = d.setup();
        setup.model = Model::multipleScattering;
        d.setSetup(setup);
    });
    row("Undo changing the rendering", [](Document& d) { d.setEstimator(Estimator::kroesMarch); });
}

void TestStepName::eachEditHasItsName() {
    QFETCH(Edit, edit);
    QFETCH(QString, undo);
    Told told;
    edit(told.document);
    QCOMPARE(QString::fromStdString(told.document.undoText()), undo);
    told.document.undo();
    QString redo = undo;
    QCOMPARE(QString::fromStdString(told.document.redoText()), redo.replace("Undo", "Redo"));
}

void TestStepName::theTableIsNamedByWhatWasDone() {
    Plan hidden, shown;
    shown.image.table = Table::shown;
    QCOMPARE(undoText(hidden, shown), Text("Undo showing the table"));
    QCOMPARE(redoText(shown, hidden), Text("Redo hiding the table"));
}

void TestStepName::measuringMarkingAndNamingAreToldApart() {
    const Plan none;
    Plan ball, point, named, moved;
    ball.measurements = {{1, MeasureKind::ball, "", {{}, {}}}};
    point.measurements = {{1, MeasureKind::point, "", {{}}}};
    named = point;
    named.measurements[0].name = "nerve";
    moved = named;
    moved.measurements[0].places[0].mm.x += 1;
    QCOMPARE(undoText(none, ball), Text("Undo measuring"));
    QCOMPARE(undoText(none, point), Text("Undo marking a place"));
    QCOMPARE(redoText(point, named), Text("Redo naming a measurement"));
    QCOMPARE(undoText(named, moved), Text("Undo changing a measurement"));
    QCOMPARE(undoText(point, moved), Text("Undo changing a measurement"));
    QCOMPARE(undoText(moved, none), Text("Undo removing a measurement"));
}

void TestStepName::aGestureIsCalledByAllOfIt() {
    Told told;
    Camera camera = told.document.setup().camera;
    for (int i = 0; i < 5; ++i)
        told.document.setCamera(camera = orbited(camera, {0.1, 0.05}), true);
    told.document.setCamera(camera, false);
    QCOMPARE(told.document.undoText(), Text("Undo turning the view"));
    told.document.undo();
    QCOMPARE(told.document.undoText(), Text("Undo"));
}

void TestStepName::aStepKeepsItsNameBackAndForth() {
    Told told;
    told.document.chooseLook(1);
    told.document.setView(StandardView::left);
    told.document.setBrightness(2);
    const auto names = [&] { return std::pair(told.document.undoText(), told.document.redoText()); };
    QCOMPARE(names(), std::pair(Text("Undo changing the brightness"), Text("Redo")));
    told.document.undo();
    QCOMPARE(names(), std::pair(Text("Undo turning the view"), Text("Redo changing the brightness")));
    told.document.undo();
    QCOMPARE(names(), std::pair(Text("Undo choosing a look"), Text("Redo turning the view")));
    told.document.redo();
    QCOMPARE(names(), std::pair(Text("Undo turning the view"), Text("Redo changing the brightness")));
}

/// Neither changing a look nor changing it back counts as choosing a look.
void TestStepName::aChangedLookIsNotAChosenOne() {
    Told told;
    const Look first = told.document.setup().look;
    Look changed = first;
    changed.transferFunction.nodes = {{7, 0.5f}};
    told.document.setLook(changed);
    QCOMPARE(told.document.undoText(), Text("Undo editing the tissue"));
    told.document.setLook(first);
    QCOMPARE(told.document.undoText(), Text("Undo editing the tissue"));
    told.document.setBrightness(1);
    told.document.chooseLook(1);  // which brings its own brightness
    QCOMPARE(told.document.undoText(), Text("Undo choosing a look"));
}

void TestStepName::namesThatBeginAlikeAreTwoLooks() {
    Plan bone;
    bone.image.lookName = "Bone";
    Plan alone = bone;
    alone.image.lookName = "Bones alone";
    alone.image.look.phaseG += 0.1f;
    QCOMPARE(undoText(bone, alone), Text("Undo choosing a look"));
    QCOMPARE(undoText(alone, bone), Text("Undo choosing a look"));
    Plan changed = bone;
    changed.image.lookChanged = true;
    changed.image.look.visible.shown = {"bones"};
    QCOMPARE(undoText(bone, changed), Text("Undo choosing the visible part"));
}

void TestStepName::whatChangesSeveralThingsSaysSo() {
    Told told;
    ImageSetup setup = told.document.setup();
    setup.stops = 1;
    setup.model = Model::absorption;
    told.document.setSetup(setup);
    QCOMPARE(told.document.undoText(), Text("Undo several changes"));
}

void TestStepName::withoutAStepThereIsOnlyTheWord() {
    QCOMPARE(undoText({}, {}), Text("Undo"));
    QCOMPARE(redoText({}, {}), Text("Redo"));
}

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::TestStepName)
#include "step_name_test.moc"
