/// The viewport's mouse and key interaction.

#include <QSignalSpy>
#include <QTest>

#include "render/scene/orbit.h"
#include "tests/support/desktop/hand_on_viewport.h"
#include "tests/support/patience.h"
#include "ui/view/drag_tool.h"
#include "ui/view/pick_tool.h"

namespace pdr::ui {

class TestViewport : public QObject {
    Q_OBJECT

  private slots:
    void leftDragTurns();
    void middleDragMoves();
    void shiftAndLeftDragMoves();
    void rightDragUpMagnifies();
    void lettingGoIsTheOnlyRest();
    void aClickAloneEditsNothing();
    void aDoubleClickLeavesTheViewAsItIs();
    void aRightClickAsksForTheMenuAndADragDoesNot();
    void theWheelKeepsThePointUnderTheCursor();
    void theWheelRestsByItself();
    void theWheelInADragRestsWithTheDrag();
    void aToolWithAModifierGoesBeforeTheCamera();
    void aPickHasTheLeftButtonOnly();
    void aPickThatIsNoLongerWantedPicksNothing();
    void aToolThatIsGoneIsNotAsked();
    void arrowKeysTurnAndMove();
    void settersAreSilent();
    void withoutCameraTheHandDoesNothing();
};

/// The mouse rests at `place`.

void TestViewport::leftDragTurns() {
    Hand hand;
    hand.drag(Qt::LeftButton, {250, 100});
    QCOMPARE(hand.edits, 2);
    QVERIFY(Hand::same(hand.last, orbited(hand.camera, {0.25, 0})));
}

void TestViewport::middleDragMoves() {
    Hand hand;
    hand.drag(Qt::MiddleButton, {250, 60});
    QVERIFY(Hand::same(hand.last, panned(hand.camera, {0.25, -0.2})));
}

void TestViewport::shiftAndLeftDragMoves() {
    Hand hand;
    hand.drag(Qt::LeftButton, {150, 60}, Qt::ShiftModifier);
    QVERIFY(Hand::same(hand.last, panned(hand.camera, {-0.25, -0.2})));
}

void TestViewport::rightDragUpMagnifies() {
    Hand hand;
    hand.drag(Qt::RightButton, {200, 40});
    QVERIFY(glm::length(hand.last.eyeMm - hand.last.targetMm) < 0.8 * glm::length(hand.camera.eyeMm));
    QVERIFY(hand.last.targetMm == hand.camera.targetMm);
}

void TestViewport::lettingGoIsTheOnlyRest() {
    Hand hand;
    hand.drag(Qt::LeftButton, {250, 100});
    QTest::qWait(300);
    QCOMPARE(hand.rests, 0);
    QTest::mouseRelease(&hand.viewport, Qt::LeftButton, {}, {250, 100});
    QCOMPARE(hand.rests, 1);
    QVERIFY(Hand::same(hand.last, orbited(hand.camera, {0.25, 0})));
}

void TestViewport::aClickAloneEditsNothing() {
    Hand hand;
    QTest::mouseClick(&hand.viewport, Qt::LeftButton);
    QCOMPARE(hand.edits + hand.rests, 0);
}

void TestViewport::aDoubleClickLeavesTheViewAsItIs() {
    Hand hand;
    QTest::mouseDClick(&hand.viewport, Qt::LeftButton);
    QCOMPARE(hand.edits + hand.rests, 0);
}

void TestViewport::aRightClickAsksForTheMenuAndADragDoesNot() {
    Hand hand;
    QSignalSpy menu(&hand.viewport, &Viewport::menuRequested);
    QTest::mouseClick(&hand.viewport, Qt::RightButton, {}, {120, 70});
    QCOMPARE(menu.count(), 1);
    QCOMPARE(menu[0][0].toPoint(), QPoint(120, 70));
    QCOMPARE(hand.edits + hand.rests, 0);
    hand.drag(Qt::RightButton, {200, 40});
    QTest::mouseRelease(&hand.viewport, Qt::RightButton, {}, {200, 40});
    QCOMPARE(menu.count(), 1);
    QVERIFY(hand.edits > 0);
}

void TestViewport::theWheelKeepsThePointUnderTheCursor() {
    Hand hand;
    // 60 pixels right of the middle, 20 below, at the target's depth.
    const double mmPerPixel =
        2 * glm::length(hand.camera.eyeMm) * std::tan(glm::radians(hand.camera.fovDegrees) / 2) / 200;
    const dvec3 point = (hand.camera.right() * 60.0 - hand.camera.imageUp() * 20.0) * mmPerPixel;
    hand.wheel({260, 120}, 240);
    const dvec3 ray = point - hand.last.eyeMm;
    const double pixels =
        200 / (2 * glm::dot(ray, hand.last.forward()) * std::tan(glm::radians(hand.last.fovDegrees) / 2));
    QVERIFY(glm::length(hand.last.eyeMm - hand.last.targetMm) < 0.8 * glm::length(hand.camera.eyeMm));
    QVERIFY(std::abs(glm::dot(ray, hand.last.right()) * pixels - 60) < 1e-6);
    QVERIFY(std::abs(glm::dot(ray, hand.last.imageUp()) * pixels + 20) < 1e-6);
}

void TestViewport::theWheelRestsByItself() {
    Hand hand;
    hand.wheel({200, 100}, 120);
    hand.wheel({200, 100}, 120);
    QCOMPARE(hand.edits, 2);
    QCOMPARE(hand.rests, 0);
    QTRY_COMPARE_WITH_TIMEOUT(hand.rests, 1, test::kPatience);
}

void TestViewport::theWheelInADragRestsWithTheDrag() {
    Hand hand;
    hand.wheel({200, 100}, 120);
    hand.drag(Qt::LeftButton, {250, 100});
    QTest::qWait(300);
    QCOMPARE(hand.rests, 0);
    QTest::mouseRelease(&hand.viewport, Qt::LeftButton, {}, {250, 100});
    QCOMPARE(hand.rests, 1);
}

void TestViewport::aToolWithAModifierGoesBeforeTheCamera() {
    Hand hand;
    DragTool tool(kTremble);
    hand.viewport.tools().bind(Qt::LeftButton, Qt::ControlModifier, tool);
    QSignalSpy dragged(&tool, &DragTool::dragged), clicked(&tool, &DragTool::clicked);
    hand.drag(Qt::LeftButton, {250, 60}, Qt::ControlModifier);
    QTest::mouseRelease(&hand.viewport, Qt::LeftButton, {}, {250, 60});
    QCOMPARE(dragged.size(), 3);
    QCOMPARE(dragged[1][0].toPointF(), QPointF(0.25, -0.2));
    QVERIFY(dragged[1][2].toBool() && !dragged[2][2].toBool());
    QTest::mouseClick(&hand.viewport, Qt::LeftButton, Qt::ControlModifier, {100, 50});
    QCOMPARE(clicked.size(), 0);  // no image
    hand.viewport.setImage(shownOf({400, 200}));
    QTest::mouseClick(&hand.viewport, Qt::LeftButton, Qt::ControlModifier, {100, 50});
    QCOMPARE(clicked.takeLast()[0].toPointF(), QPointF(0.25, 0.25));
    QCOMPARE(hand.edits + hand.rests, 0);
}

void TestViewport::aPickHasTheLeftButtonOnly() {
    Hand hand;
    hand.viewport.setImage(shownOf({400, 200}));
    PickTool tool;
    hand.viewport.tools().add(tool);
    QSignalSpy picked(&tool, &PickTool::picked);
    tool.setActive(true);
    QCOMPARE(hand.viewport.cursor().shape(), Qt::CrossCursor);
    hand.drag(Qt::MiddleButton, {100, 50});
    QTest::mouseRelease(&hand.viewport, Qt::MiddleButton, {}, {100, 50});
    QVERIFY(picked.isEmpty() && hand.edits > 0);
    const int edits = hand.edits;
    hand.drag(Qt::LeftButton, {100, 50}, Qt::ShiftModifier);
    QTest::mouseRelease(&hand.viewport, Qt::LeftButton, {}, {100, 50});
    QCOMPARE(hand.edits, edits);
    QCOMPARE(picked.takeLast()[0].toPointF(), QPointF(0.25, 0.25));
    QVERIFY(!tool.isActive());
    QCOMPARE(hand.viewport.cursor().shape(), Qt::ArrowCursor);
}

void TestViewport::aPickThatIsNoLongerWantedPicksNothing() {
    Hand hand;
    hand.viewport.setImage(shownOf({400, 200}));
    PickTool focus, tissue;
    for (PickTool* tool : {&focus, &tissue})
        hand.viewport.tools().add(*tool);
    QSignalSpy picked(&focus, &PickTool::picked);
    focus.setActive(true);
    QTest::mousePress(&hand.viewport, Qt::LeftButton, {}, {100, 50});
    QVERIFY(hand.viewport.tools().cancel() && !hand.viewport.tools().cancel());
    QTest::mouseRelease(&hand.viewport, Qt::LeftButton, {}, {100, 50});
    QVERIFY(picked.isEmpty());
    focus.setActive(true);
    tissue.setActive(true);
    QVERIFY(!focus.isActive());
}

/// A presenter may end before the view.
void TestViewport::aToolThatIsGoneIsNotAsked() {
    Hand hand;
    hand.viewport.setImage(shownOf({400, 200}));
    {
        DragTool tool(0);
        hand.viewport.tools().bind(Qt::LeftButton, Qt::ControlModifier, tool);
        QTest::mousePress(&hand.viewport, Qt::LeftButton, Qt::ControlModifier, {100, 50});
    }
    QTest::mouseRelease(&hand.viewport, Qt::LeftButton, Qt::ControlModifier, {100, 50});
    hand.drag(Qt::LeftButton, {150, 50}, Qt::ControlModifier);
    QVERIFY(hand.edits > 0);
}

void TestViewport::arrowKeysTurnAndMove() {
    Hand hand;
    QTest::keyClick(&hand.viewport, Qt::Key_Right);
    QVERIFY(hand.last.targetMm == hand.camera.targetMm && hand.last.eyeMm != hand.camera.eyeMm);
    QTest::keyClick(&hand.viewport, Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY(hand.last.targetMm != hand.camera.targetMm);
    QTRY_COMPARE_WITH_TIMEOUT(hand.rests, 1, test::kPatience);
}

void TestViewport::settersAreSilent() {
    Hand hand;
    hand.viewport.setCamera(orbited(hand.camera, {1, 0.3}));
    hand.viewport.setImage({QImage(8, 8, QImage::Format_RGBX8888), hand.camera, {}});
    hand.viewport.setMessage("nothing");
    QTest::qWait(300);
    QCOMPARE(hand.edits + hand.rests, 0);
}

void TestViewport::withoutCameraTheHandDoesNothing() {
    Hand hand;
    hand.viewport.setCamera({});
    hand.drag(Qt::LeftButton, {250, 100});
    hand.wheel({200, 100}, 120);
    QTest::keyClick(&hand.viewport, Qt::Key_Right);
    QTest::mouseRelease(&hand.viewport, Qt::LeftButton);
    QCOMPARE(hand.edits + hand.rests, 0);
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestViewport)
#include "viewport_test.moc"
