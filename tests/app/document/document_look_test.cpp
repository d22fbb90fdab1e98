/// Looks in the document: those to choose, the user's own, and where their lights stand.

#include <QTest>

#include "render/scene/orbit.h"
#include "tests/support/desktop/told_document.h"

namespace pdr::app {

class TestDocumentLook : public QObject {
    Q_OBJECT

  private slots:
    void undoOfAChoiceBringsTheLookBack();
    void theLightsFollowTheCamera();
    void theLightsOfAPatientStay();
    void anEditedLookSurvivesTheNextOrbit();
    void aChangedLookIsNotCalledAsTheOneItWas();
    void aDragOfTheLookIsOneStep();
    void anotherModelLeavesTheWaysThatDoNotKnowIt();
    void aBackgroundIsPartOfTheImage();
    void valuesThatAreNoHuHaveLooksOfTheirOwn();
};

/// Nothing that is drawn in HU is shown on other values, not even what the user drew; the next CT is shown as before.
void TestDocumentLook::valuesThatAreNoHuHaveLooksOfTheirOwn() {
    Voxels voxels;
    for (int i = 0; i < 64; ++i)
        voxels.push_back(std::int16_t(i < 40 ? i % 4 : 500 + 10 * i));  // darkness, and something in it
    const auto other = std::make_shared<const Volume>(cube()->geometry(), voxels, std::vector<bool>(), "no-hu");
    for (const bool edited : {false, true}) {
        Told told;
        if (edited) {
            Look look = told.document.setup().look;
            look.transferFunction.nodes[1].opacity = 0.25f;
            told.document.setLook(look);
        }
        told.document.open(other);
        QVERIFY(!told.document.looks().areInHu());
        QCOMPARE(told.document.setup().lookName, std::string("Bright values, solid"));
        const TransferFunction& function = told.scenes.back().transferFunction;
        for (int i = 0; i < 64; ++i)
            QCOMPARE(function.opacityAt(voxels[std::size_t(i)]) > 0, i >= 40);
        told.document.chooseLook(1);
        QCOMPARE(told.scenes.back().model, Model::maximumIntensity);
        QVERIFY(told.scenes.back().window.highHu > 900 && told.scenes.back().window.lowHu < 4);
        told.document.open(cube());
        QVERIFY(told.document.looks().areInHu());
        QCOMPARE(told.document.setup().lookName, std::string("first"));
        QVERIFY(told.scenes.back().transferFunction == twoLooks()[0].look.transferFunction);
        QCOMPARE(told.scenes.back().model, twoLooks()[0].model);
    }
}

void TestDocumentLook::undoOfAChoiceBringsTheLookBack() {
    Told told;
    told.document.setBrightness(1);
    told.document.chooseLook(1);
    QCOMPARE(told.displays.back().exposure, 8.f);
    QCOMPARE(told.scenes.back().phaseG, 0.5f);
    told.document.undo();
    QCOMPARE(told.document.look(), 0);
    QCOMPARE(told.document.setup().stops, 1.0);
    QCOMPARE(told.displays.back().exposure, 1.f);
    QVERIFY(told.scenes.back().transferFunction == twoLooks()[0].look.transferFunction);
}

void TestDocumentLook::theLightsFollowTheCamera() {
    Told told;
    told.document.setView(StandardView::left);
    QVERIFY(!told.scenes[0].lights.empty());
    QVERIFY(told.scenes[1].lights != told.scenes[0].lights);
    told.document.undo();
    QVERIFY(told.scenes[2].lights == told.scenes[0].lights);
}

void TestDocumentLook::theLightsOfAPatientStay() {
    Told told;
    Look look = told.document.setup().look;
    look.rig.follows = LightRig::Follows::patient;
    told.document.setLook(look);
    QVERIFY(told.scenes[1].lights == told.scenes[0].lights);  // from the front they stand where they did
    told.document.setView(StandardView::left);
    QVERIFY(told.scenes[2].lights == told.scenes[0].lights);
}

void TestDocumentLook::anEditedLookSurvivesTheNextOrbit() {
    Told told;
    Look look = told.document.setup().look;
    look.rig.panels[0].radiance = 7;
    look.transferFunction.nodes[1].opacity = 0.25f;
    look.environment.radiance = vec3(0.5f, 0.25f, 0.125f);
    told.document.setLook(look);
    told.document.setCamera(orbited(told.document.scene().camera, {0.3, 0.1}), false);
    const Scene& scene = told.scenes.back();
    QVERIFY(told.document.setup().look == look);
    QVERIFY(scene.transferFunction == look.transferFunction && scene.environment == look.environment);
    QVERIFY(scene.lights == panelsOf(look.rig, scene.volume->geometry(), scene.camera));
    told.document.undo();
    told.document.undo();
    QVERIFY(told.document.setup().look == twoLooks()[0].look);
}

void TestDocumentLook::aChangedLookIsNotCalledAsTheOneItWas() {
    Told told;
    QCOMPARE(told.scenes.back().lookName, std::string("first"));
    QCOMPARE(told.document.look(), 0);
    Look look = told.document.setup().look;
    for (int i = 1; i <= 2; ++i) {
        look.rig.panels[1].radiance = float(i);
        told.document.setLook(look);
        QCOMPARE(told.scenes.back().lookName, std::string("first (changed)"));
        QCOMPARE(told.document.look(), -1);
    }
    told.document.setLook(twoLooks()[1].look);
    QCOMPARE(told.scenes.back().lookName, std::string("second"));
    QCOMPARE(told.document.look(), 1);
}

void TestDocumentLook::aDragOfTheLookIsOneStep() {
    Told told;
    Look look = told.document.setup().look;
    for (int i = 1; i <= 10; ++i) {
        look.rig.panels[2].radiance = 0.1f * float(i);
        told.document.setLook(look, true);
    }
    QVERIFY(told.lastMoves);
    told.document.setLook(look, false);  // let go
    QVERIFY(!told.lastMoves);
    told.document.undo();
    QVERIFY(told.document.setup().look == twoLooks()[0].look);
    QVERIFY(!told.document.canUndo());
}

void TestDocumentLook::anotherModelLeavesTheWaysThatDoNotKnowIt() {
    Told told;
    told.document.setEstimator(Estimator::kroesMarch);
    told.document.setModel(Model::multipleScattering);
    QVERIFY(told.scenes.back().model == Model::multipleScattering && told.scenes.back().check());
    const std::size_t scenes = told.scenes.size();
    told.document.setModel(Model::multipleScattering);
    QCOMPARE(told.scenes.size(), scenes);
    told.document.undo();
    QVERIFY(told.scenes.back().estimator == Estimator::kroesMarch);
}

/// The background is part of the image, and neither of the look nor of its light.
void TestDocumentLook::aBackgroundIsPartOfTheImage() {
    Told told;
    told.document.setBackground(vec3(0.5f));
    QVERIFY(told.scenes.back().background == vec3(0.5f) && !showsEnvironment(told.scenes.back()));
    QCOMPARE(told.document.look(), 0);
    told.document.chooseLook(1);
    QVERIFY(told.scenes.back().background == vec3(0.5f));
    told.document.setBackground(std::nullopt);
    QVERIFY(showsEnvironment(told.scenes.back()));
    told.document.undo();
    told.document.undo();
    told.document.undo();
    QVERIFY(!told.document.canUndo() && !told.scenes.back().background);
}

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::TestDocumentLook)
#include "document_look_test.moc"
