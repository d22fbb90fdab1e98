/// The document: what an edit makes, and what undo brings back.

#include <QTest>

#include "render/scene/orbit.h"
#include "tests/support/desktop/told_document.h"

namespace pdr::app {

class TestDocument : public QObject {
    Q_OBJECT

  private slots:
    void eachOperationIsReportedOnce();
    void aPlanIsEditedAsAWhole();
    void anOpenedVolumeIsSeenFromTheFrontWithTheFirstLook();
    void everySceneHasItsOwnGrowingRevision();
    void everySceneCanBeRendered();
    void aWholeGestureIsOneStepBack();
    void redoBringsTheEditBackAsANewScene();
    void anEditAfterUndoForgetsWhatWasUndone();
    void manyStepsBackAndForthAreExact();
    void theEstimatorIsAnEditLikeOthers();
    void brightnessChangesTheDisplayAndIsAStepOfItsOwn();
    void theRawImageIsAChoiceForTheEye();
    void undoOfAViewLeavesTheBrightness();
    void theWayBackIsLongButEnds();
    void theScheduleIsAnEditLikeOthers();
    void theWindowsSizeIsNotUndone();
    void aNewVolumeHasNoWayBack();
    void withoutVolumeEditsWait();
    void theFilmHasTheViewsPixels();
    void aSizeWithTheSameFilmChangesNothing();
    void aHandThatRestsWhereItIsShowsTheSameScene();
    void aDragOfTheBrightnessIsOneStep();
};

void TestDocument::anOpenedVolumeIsSeenFromTheFrontWithTheFirstLook() {
    Told told;
    QCOMPARE(told.scenes.size(), std::size_t(1));
    const Scene& scene = told.scenes.front();
    QVERIFY(glm::length(scene.camera.forward() - dvec3(0, 1, 0)) < 1e-12);
    QVERIFY(scene.camera.targetMm == dvec3(0, 100, 200));
    QVERIFY(scene.film == ivec2(400, 200));
    QVERIFY(scene.transferFunction == twoLooks()[0].look.transferFunction);
    QCOMPARE(told.displays.back().exposure, 2.f);
    QVERIFY(!told.document.canUndo());
}

void TestDocument::everySceneHasItsOwnGrowingRevision() {
    Told told;
    told.document.chooseLook(1);
    told.document.setView(StandardView::left);
    told.document.setViewSize({300, 300});
    told.document.undo();
    told.document.redo();
    QCOMPARE(told.scenes.size(), std::size_t(6));
    for (std::size_t i = 1; i < told.scenes.size(); ++i)
        QVERIFY(told.scenes[i].revision > told.scenes[i - 1].revision);
}

void TestDocument::everySceneCanBeRendered() {
    Told told;
    told.document.chooseLook(1);
    told.document.setView(StandardView::superior);
    told.document.setViewSize({0, 0});
    for (const Scene& scene : told.scenes) {
        const Result<void> check = scene.check();
        QVERIFY2(check, check ? "" : check.error().text().c_str());
    }
}

void TestDocument::aWholeGestureIsOneStepBack() {
    Told told;
    const Camera before = told.document.scene().camera;
    for (int i = 0; i < 10; ++i)
        told.document.setCamera(orbited(told.document.scene().camera, {0.05, 0.02}), true);
    QVERIFY(told.lastMoves);
    told.document.setCamera(told.document.scene().camera, false);
    QVERIFY(!told.lastMoves);
    told.document.undo();
    QVERIFY(told.document.scene().camera == before);
    QVERIFY(!told.document.canUndo());
}

void TestDocument::redoBringsTheEditBackAsANewScene() {
    Told told;
    told.document.setView(StandardView::left);
    const Scene edited = told.document.scene();
    told.document.undo();
    told.document.redo();
    QVERIFY(told.document.scene().camera == edited.camera);
    QVERIFY(told.document.scene().revision > edited.revision);
    QVERIFY(!told.document.canRedo());
}

void TestDocument::anEditAfterUndoForgetsWhatWasUndone() {
    Told told;
    told.document.setView(StandardView::left);
    told.document.undo();
    told.document.setView(StandardView::right);
    QVERIFY(!told.document.canRedo());
    told.document.redo();
    QVERIFY(glm::length(told.document.scene().camera.forward() - dvec3(1, 0, 0)) < 1e-12);
}

void TestDocument::manyStepsBackAndForthAreExact() {
    Told told;
    std::vector<Camera> seen{told.document.scene().camera};
    for (int i = 0; i < 200; ++i) {
        told.document.setCamera(orbited(seen.back(), {0.013, 0.007}), false);
        seen.push_back(told.document.scene().camera);
    }
    for (int i = 199; i >= 0; --i) {
        told.document.undo();
        QVERIFY(told.document.scene().camera == seen[std::size_t(i)]);
    }
    for (int i = 1; i <= 200; ++i) {
        told.document.redo();
        QVERIFY(told.document.scene().camera == seen[std::size_t(i)]);
    }
}

void TestDocument::theEstimatorIsAnEditLikeOthers() {
    Told told;
    told.document.setEstimator(Estimator::unbiased);  // it is that already
    QVERIFY(!told.document.canUndo());
    told.document.setEstimator(Estimator::kroesMarch);
    QVERIFY(told.scenes.back().estimator == Estimator::kroesMarch);
    QVERIFY(told.scenes.back().revision > told.scenes.front().revision);
    told.document.chooseLook(1);
    QVERIFY(told.scenes.back().estimator == Estimator::kroesMarch);
    told.document.undo();
    told.document.undo();
    QVERIFY(told.scenes.back().estimator == Estimator::unbiased);
    told.document.redo();
    QVERIFY(told.scenes.back().estimator == Estimator::kroesMarch);

    Document empty(twoLooks());  // the choice waits for a volume
    empty.setEstimator(Estimator::kroesMarch);
    QVERIFY(!empty.canUndo());
    empty.open(cube());
    QVERIFY(empty.scene().estimator == Estimator::kroesMarch);
}

void TestDocument::brightnessChangesTheDisplayAndIsAStepOfItsOwn() {
    Told told;
    told.document.setView(StandardView::left);
    const Camera left = told.document.scene().camera;
    told.document.setBrightness(2);
    QCOMPARE(told.scenes.size(), std::size_t(2));
    QCOMPARE(told.displays.back().exposure, 0.5f);
    told.document.undo();  // the brightness, and not the view
    QCOMPARE(told.document.setup().stops, 0.0);
    QCOMPARE(told.displays.back().exposure, 2.f);
    QVERIFY(told.document.scene().camera == left);
    QCOMPARE(told.scenes.size(), std::size_t(2));  // nothing is computed anew
    told.document.redo();
    QCOMPARE(told.document.setup().stops, 2.0);
    QCOMPARE(told.scenes.size(), std::size_t(2));
    told.document.undo();
    told.document.undo();  // the view
    QVERIFY(told.document.scene().camera != left);
    QCOMPARE(told.scenes.size(), std::size_t(3));
}

void TestDocument::theRawImageIsAChoiceForTheEye() {
    Told told;
    QVERIFY(told.displays.back().denoised && told.document.denoised());
    told.document.setDenoised(false);
    QVERIFY(!told.displays.back().denoised);
    QCOMPARE(told.scenes.size(), std::size_t(1));  // nothing is computed anew
    QVERIFY(!told.document.canUndo());
    told.document.chooseLook(1);
    QVERIFY(!told.displays.back().denoised);
    QCOMPARE(told.document.look(), 1);
    told.document.setDenoised(true);
    QVERIFY(told.displays.back().denoised);
}

void TestDocument::undoOfAViewLeavesTheBrightness() {
    Told told;
    const Camera front = told.document.scene().camera;
    told.document.setBrightness(1);
    told.document.setView(StandardView::left);
    told.document.undo();
    QVERIFY(told.document.scene().camera == front);
    QCOMPARE(told.document.setup().stops, 1.0);
}

void TestDocument::theWayBackIsLongButEnds() {
    Told told;
    const auto steps = [&](auto&& step) {
        int taken = 0;
        for (; step(); ++taken)
            ;
        return taken;
    };
    for (int i = 0; i < 5000; ++i)
        told.document.setCamera(orbited(told.document.scene().camera, {0.01, 0}), false);
    const Camera last = told.document.scene().camera;
    const auto back = [&] { return told.document.canUndo() && (told.document.undo(), true); };
    const auto forth = [&] { return told.document.canRedo() && (told.document.redo(), true); };
    const int backwards = steps(back);
    QVERIFY2(backwards >= 200 && backwards <= 500, qPrintable(QString::number(backwards)));
    QCOMPARE(steps(forth), backwards);
    QVERIFY(told.document.scene().camera == last);
}

void TestDocument::theScheduleIsAnEditLikeOthers() {
    Told told;
    told.document.setSchedule({});  // it is that already
    QVERIFY(!told.document.canUndo());
    const Schedule k1{.kind = Schedule::Kind::kroes};
    told.document.setSchedule(k1);
    QVERIFY(told.scenes.back().schedule == k1);
    told.document.chooseLook(1);
    QVERIFY(told.scenes.back().schedule == k1);
    told.document.undo();
    told.document.undo();
    QVERIFY(told.scenes.back().schedule == Schedule{});
}

void TestDocument::theWindowsSizeIsNotUndone() {
    Told told;
    told.document.setView(StandardView::left);
    told.document.setViewSize({640, 480});
    QVERIFY(told.scenes.back().film == ivec2(640, 480));
    told.document.undo();
    QVERIFY(told.scenes.back().film == ivec2(640, 480));
}

void TestDocument::aNewVolumeHasNoWayBack() {
    Told told;
    told.document.chooseLook(1);
    told.document.setView(StandardView::left);
    const auto second = cube();
    told.document.open(second);
    QVERIFY(!told.document.canUndo() && !told.document.canRedo());
    QVERIFY(told.scenes.back().volume == second);
    QCOMPARE(told.document.look(), 1);
    QVERIFY(told.scenes.back().transferFunction == twoLooks()[1].look.transferFunction);
}

void TestDocument::withoutVolumeEditsWait() {
    Document document(twoLooks());
    int scenes = 0;
    connect(&document, &Document::sceneChanged, this, [&] { ++scenes; });
    document.setViewSize({100, 100});
    document.setView(StandardView::left);
    document.setCamera({}, true);
    document.chooseLook(1);
    document.chooseLook(7);
    document.undo();
    document.redo();
    QCOMPARE(scenes, 0);
    document.open(cube());
    QCOMPARE(scenes, 1);
    QVERIFY(document.scene().transferFunction == twoLooks()[1].look.transferFunction);
    int closing = 0;
    connect(&document, &Document::closing, [&] { closing += document.hasVolume() ? 100 : 1; });
    document.close();
    QVERIFY(!document.hasVolume());
    document.close();
    QCOMPARE(closing, 1);
}

void TestDocument::theFilmHasTheViewsPixels() {
    Told told;
    for (const ivec2 size : {ivec2(640, 480), ivec2(3840, 2160), ivec2(1, 4000)}) {
        told.document.setViewSize(size);
        QVERIFY(told.scenes.back().film == size);
    }
    told.document.setViewSize({0, 0});
    QVERIFY(told.scenes.back().film == ivec2(1, 1));
    told.document.setViewSize({100000, 10});
    QVERIFY(told.scenes.back().check());
}

void TestDocument::aSizeWithTheSameFilmChangesNothing() {
    Told told;
    told.document.setViewSize({2048, 1024});
    const std::size_t scenes = told.scenes.size();
    told.document.setViewSize({2048, 1024});
    QCOMPARE(told.scenes.size(), scenes);
}

void TestDocument::aHandThatRestsWhereItIsShowsTheSameScene() {
    Told told;
    const Camera turned = orbited(told.document.scene().camera, {0.1, 0});
    told.document.setCamera(turned, true);
    const std::uint64_t revision = told.scenes.back().revision;
    told.document.setCamera(turned, false);
    QCOMPARE(told.scenes.size(), std::size_t(3));
    QVERIFY(!told.lastMoves);
    QCOMPARE(told.scenes.back().revision, revision);
    told.document.setCamera(orbited(turned, {0.1, 0}), true);  // another gesture
    QVERIFY(told.scenes.back().revision > revision);
    told.document.undo();
    QVERIFY(told.document.scene().camera == turned);
    told.document.setCamera(turned, false);  // a key's gesture rests when it was undone already
    QVERIFY(told.document.canRedo());
}

void TestDocument::aDragOfTheBrightnessIsOneStep() {
    Told told;
    for (int i = 1; i <= 10; ++i)
        told.document.setBrightness(0.1 * i, true);
    told.document.setBrightness(1, false);  // let go
    told.document.setBrightness(2, true);
    told.document.setBrightness(2, false);
    told.document.setBrightness(2, false);  // pressed and let go: nothing
    told.document.undo();
    QCOMPARE(told.document.setup().stops, 1.0);
    told.document.undo();
    QCOMPARE(told.document.setup().stops, 0.0);
    QVERIFY(!told.document.canUndo());
}

/// The window shows the document once for each operation, and knows what has changed.
void TestDocument::eachOperationIsReportedOnce() {
    Told told;
    Document& document = told.document;
    const auto reportOf = [&](auto operation) {
        told.reports.clear();
        operation();
        return told.reports.size() == 1 ? told.reports.front() : Changes::none;
    };
    Look look = document.setup().look;
    look.transferFunction.nodes = {{7, 0.5f}};
    QCOMPARE(reportOf([&] { document.setLook(look, true); }), Changes::tissue);
    look.display.exposure = 3;
    QVERIFY(has(reportOf([&] { document.setLook(look); }), Changes::otherLook));
    QVERIFY(has(reportOf([&] { document.chooseLook(1); }), Changes::lookName));
    QCOMPARE(reportOf([&] { document.setBrightness(1); }), Changes::brightness);
    QCOMPARE(reportOf([&] { document.setView(StandardView::left); }), Changes::camera);
    QCOMPARE(reportOf([&] { document.undo(); }), Changes::camera);
    QCOMPARE(reportOf([&] { document.setDenoised(false); }), Changes::display);
    QVERIFY(has(reportOf([&] { document.open(cube()); }), Changes::series));
    QVERIFY(has(reportOf([&] { document.close(); }), Changes::series));
}

void TestDocument::aPlanIsEditedAsAWhole() {
    Told told;
    Plan plan = told.document.plan();
    plan.image.model = Model::absorption;
    plan.image.stops = 1;
    const std::size_t scenes = told.scenes.size();
    told.document.edit(plan);
    QVERIFY(told.document.plan() == plan && told.scenes.size() == scenes + 1);
    QCOMPARE(told.reports.back(), Changes::brightness | Changes::model);
    told.document.undo();
    QVERIFY(told.document.plan() != plan);
}

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::TestDocument)
#include "document_test.moc"
