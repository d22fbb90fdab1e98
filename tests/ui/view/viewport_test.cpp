/// The viewport's mouse and key interaction.

#include <QHelpEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <QWheelEvent>

#include "render/scene/orbit.h"
#include "tests/support/patience.h"
#include "ui/view/drag_tool.h"
#include "ui/view/pick_tool.h"
#include "ui/view/viewport.h"

namespace pdr::ui {

/// A viewport of 400 x 200 whose camera looks from the front, and what it emits.
struct Hand {
    Hand() {
        viewport.resize(400, 200);
        viewport.setCamera(camera);
        viewport.show();
        QObject::connect(&viewport, &Viewport::cameraEdited, [this](const Camera& edited, bool moving) {
            last = edited;
            edits += moving;
            rests += !moving;
        });
    }

    /// Presses at the middle and moves on to `end` in two steps; does not let go.
    void drag(Qt::MouseButton button, QPoint end, Qt::KeyboardModifiers modifiers = {}) {
        const QPoint start(200, 100);
        QTest::mousePress(&viewport, button, modifiers, start);
        for (const QPoint place : {(start + end) / 2, end}) {
            QMouseEvent move(QEvent::MouseMove, place, viewport.mapToGlobal(place), Qt::NoButton, button, modifiers);
            QCoreApplication::sendEvent(&viewport, &move);
        }
    }

    void wheel(QPointF place, int angle) {
        QWheelEvent event(place, viewport.mapToGlobal(place), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&viewport, &event);
    }

    static bool same(const Camera& a, const Camera& b) {
        return glm::length(a.eyeMm - b.eyeMm) < 1e-9 && glm::length(a.targetMm - b.targetMm) < 1e-9 &&
               glm::length(a.imageUp() - b.imageUp()) < 1e-12;
    }

    const Camera camera = standardView(StandardView::anterior, {0, 0, 0}, 150, 2);
    Viewport viewport;
    Camera last;
    int edits = 0;
    int rests = 0;
};

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
    void aCoarsePictureIsStretchedToTheHeight();
    void bracketsStandAtTheEndsOfLostLinesAlone();
    void theCaptionStandsInAPictureAlone();
    void withoutPictureTheMessageIsShown();
    void theNewSizeIsTold();
    void withAPictureTheSettledSizeIsTold();
    void whereTheMouseRestsIsToldInPartsOfThePicture();
    void aTipIsShownOnlyWhereTheMouseStillRests();
};

/// The mouse rests at `place`.
static void restAt(Viewport& viewport, QPoint place) {
    QHelpEvent event(QEvent::ToolTip, place, viewport.mapToGlobal(place));
    QCoreApplication::sendEvent(&viewport, &event);
}

/// Returns a black image of `size`, for a view of 400 x 200.
static ShownPicture shownOf(QSize size) {
    ShownPicture shown;
    shown.image = QImage(size, QImage::Format_RGBX8888);
    shown.image.fill(Qt::black);
    return shown;
}

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
    QCOMPARE(clicked.size(), 0);  // no picture
    hand.viewport.setPicture(shownOf({400, 200}));
    QTest::mouseClick(&hand.viewport, Qt::LeftButton, Qt::ControlModifier, {100, 50});
    QCOMPARE(clicked.takeLast()[0].toPointF(), QPointF(0.25, 0.25));
    QCOMPARE(hand.edits + hand.rests, 0);
}

void TestViewport::aPickHasTheLeftButtonOnly() {
    Hand hand;
    hand.viewport.setPicture(shownOf({400, 200}));
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
    hand.viewport.setPicture(shownOf({400, 200}));
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
    hand.viewport.setPicture(shownOf({400, 200}));
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
    hand.viewport.setPicture({QImage(8, 8, QImage::Format_RGBX8888), hand.camera, {}});
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

void TestViewport::aCoarsePictureIsStretchedToTheHeight() {
    Hand hand;
    hand.viewport.setCamera({});
    QImage coarse(40, 20, QImage::Format_RGBX8888);
    coarse.fill(Qt::red);
    hand.viewport.setPicture({coarse, hand.camera, {}});
    const QImage shown = hand.viewport.grab().toImage();
    for (const QPoint corner : {QPoint(1, 1), QPoint(398, 1), QPoint(1, 198), QPoint(398, 198)})
        QCOMPARE(shown.pixelColor(corner), QColor(Qt::red));
    // A picture of another shape keeps the size of what it shows: the height fits, the rest is ground.
    hand.viewport.setPicture({coarse.copy(0, 0, 20, 20), hand.camera, {}});
    const QImage narrow = hand.viewport.grab().toImage();
    QCOMPARE(narrow.pixelColor(200, 1), QColor(Qt::red));
    QCOMPARE(narrow.pixelColor(50, 100), QColor(Qt::black));
}

/// The caption is painted only in full screen; otherwise the status bar shows it.
void TestViewport::theCaptionStandsInAPictureAlone() {
    Hand hand;
    QImage image(400, 200, QImage::Format_RGBX8888);
    image.fill(Qt::darkGray);
    const auto shown = [&](bool alone, const QString& caption) {
        hand.viewport.setCaptionShown(alone);
        hand.viewport.setPicture({image, hand.camera, "bone", {}, {}, caption});
        return hand.viewport.grab().toImage();
    };
    QVERIFY(shown(false, {}) == shown(false, "Preview"));
    QVERIFY(shown(true, {}) == shown(false, {}));
    QVERIFY(shown(true, "Preview") != shown(true, {}));
}

/// An image of half the view's size contains a line: its ends are marked, but not the line itself nor the texts, and
/// only with the error map.
void TestViewport::bracketsStandAtTheEndsOfLostLinesAlone() {
    Hand hand;
    QImage image(200, 100, QImage::Format_RGBX8888);
    image.fill(Qt::darkGray);
    QImage map(image.size(), QImage::Format_RGBA8888);
    map.fill(Qt::transparent);
    const auto shown = [&](const QList<QLineF>& lostLines, bool withMap = true) {
        hand.viewport.setPicture(
            {image, hand.camera, "bone", "denoised", lostLines, {}, withMap ? map : QImage(), true});
        return hand.viewport.grab().toImage();
    };
    const QImage plain = shown({}), marked = shown({QLineF(80, 50, 120, 50)});
    const double ratio = hand.viewport.devicePixelRatioF();
    QRect changed;
    for (int y = 0; y < plain.height(); ++y)
        for (int x = 0; x < plain.width(); ++x)
            if (plain.pixel(x, y) != marked.pixel(x, y)) {
                changed |= QRect(x, y, 1, 1);
                if (qBlue(plain.pixel(x, y)) == qRed(plain.pixel(x, y)))             // no text lies there
                    QVERIFY(qBlue(marked.pixel(x, y)) >= qRed(marked.pixel(x, y)));  // unlike handles and measurements
            }
    // The line goes from 160 to 240 at a height of 100.
    const QRectF lengths(changed.topLeft() / ratio, changed.size() / ratio);
    QVERIFY(lengths.left() > 150 && lengths.left() < 160 && lengths.right() > 240 && lengths.right() < 250);
    QVERIFY(lengths.top() > 90 && lengths.bottom() < 111);
    const QRect line(QPoint(int(165 * ratio), int(96 * ratio)), QPoint(int(235 * ratio), int(104 * ratio)));
    QVERIFY(plain.copy(line) == marked.copy(line));
    QVERIFY(shown({}) == plain);
    QVERIFY(shown({QLineF(80, 50, 120, 50)}, false) == shown({}, false));
}

void TestViewport::withoutPictureTheMessageIsShown() {
    Hand hand;
    hand.viewport.setMessage("Drop a folder here");
    const QImage shown = hand.viewport.grab().toImage();
    int bright = 0;
    for (int y = 0; y < shown.height(); ++y) {
        for (int x = 0; x < shown.width(); ++x)
            bright += shown.pixelColor(x, y).lightness() > 120;
    }
    QVERIFY(bright > 50);
}

void TestViewport::theNewSizeIsTold() {
    Hand hand;
    QSignalSpy size(&hand.viewport, &Viewport::sizeInPixelsChanged);
    hand.viewport.resize(300, 250);
    QTRY_COMPARE_WITH_TIMEOUT(size.count(), 1, test::kPatience);
    QCOMPARE(size.first().first().toSize(), QSize(300, 250) * hand.viewport.devicePixelRatioF());
}

void TestViewport::withAPictureTheSettledSizeIsTold() {
    Hand hand;
    hand.viewport.setPicture(shownOf({400, 200}));
    QSignalSpy size(&hand.viewport, &Viewport::sizeInPixelsChanged);
    bool quick = false;  // some of the sizes follow each other faster than a size settles
    for (int i = 0; i < 500 && !quick; ++i) {
        hand.viewport.resize(i % 2 ? 410 : 420, 200);
        size.clear();
        QElapsedTimer clock;
        clock.start();
        for (int step = 1; step <= 5; ++step) {
            hand.viewport.resize(400 + 10 * step, 200);
            QCoreApplication::processEvents();
        }
        quick = clock.elapsed() < 150;
    }
    QVERIFY(quick);
    QCOMPARE(size.count(), 0);
    QTRY_COMPARE_WITH_TIMEOUT(size.count(), 1, test::kPatience);
    QCOMPARE(size[0][0].toSize(), QSize(450, 200) * hand.viewport.devicePixelRatioF());
}

void TestViewport::whereTheMouseRestsIsToldInPartsOfThePicture() {
    Hand hand;
    QSignalSpy rested(&hand.viewport, &Viewport::rested);
    restAt(hand.viewport, {100, 100});
    QCOMPARE(rested.count(), 0);  // no picture
    hand.viewport.setPicture(shownOf({400, 200}));
    restAt(hand.viewport, {100, 50});
    QCOMPARE(rested.takeLast()[0].toPointF(), QPointF(0.25, 0.25));
    hand.viewport.setPicture(shownOf({50, 50}));  // stretched to the height, in the middle
    restAt(hand.viewport, {150, 50});
    QCOMPARE(rested.takeLast()[0].toPointF(), QPointF(0.25, 0.25));
    restAt(hand.viewport, {50, 50});
    QCOMPARE(rested.count(), 0);  // beside it
    QTest::mousePress(&hand.viewport, Qt::LeftButton, {}, {150, 50});
    restAt(hand.viewport, {150, 50});
    QCOMPARE(rested.count(), 0);  // a hand that drags
}

void TestViewport::aTipIsShownOnlyWhereTheMouseStillRests() {
    Hand hand;
    hand.viewport.setPicture(shownOf({400, 200}));
    restAt(hand.viewport, {100, 50});
    hand.viewport.showTip({0.5, 0.5}, "elsewhere");
    QVERIFY(QToolTip::text() != "elsewhere");
    hand.viewport.showTip({0.25, 0.25}, "here");
    QCOMPARE(QToolTip::text(), "here");
    hand.viewport.showTip({0.25, 0.25}, {});
    QTRY_VERIFY(!QToolTip::isVisible());
    QMouseEvent move(QEvent::MouseMove, QPointF(101, 50), hand.viewport.mapToGlobal(QPointF(101, 50)), Qt::NoButton,
                     Qt::NoButton, {});
    QCoreApplication::sendEvent(&hand.viewport, &move);
    hand.viewport.showTip({0.25, 0.25}, "too late");
    QVERIFY(!QToolTip::isVisible());
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestViewport)
#include "viewport_test.moc"
