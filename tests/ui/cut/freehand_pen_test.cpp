/// A line drawn on the image becomes a cut when the user has chosen what it cuts.

#include "ui/cut/freehand_pen.h"

#include <QSignalSpy>
#include <QTest>

#include "render/scene/edit/drawn_outline.h"
#include "tests/support/desktop/mouse.h"
#include "tests/support/desktop/press_counter.h"
#include "ui/view/viewport.h"

namespace pdr::ui {

/// An image of 300 x 200 pixels with a pen; it counts the clicks that the pen does not take.
class PenPicture : public Viewport {
  public:
    PenPicture() {
        resize(300, 200);
        showImage({300, 200}, {});
        tools().add(behind);
        tools().add(*pen);
        QObject::connect(pen, &FreehandPen::drawn, [this](const FreehandCut& cut) { cuts.push_back(cut); });
        show();
    }
    void showImage(QSize size, const Camera& camera) { setPicture({QImage(size, QImage::Format_RGB32), camera}); }
    int clicksBehind() {
        QTest::mouseClick(this, Qt::LeftButton, {}, {150, 100});
        return behind.clicks;
    }
    /// A square of 100 pixels around the middle.
    void drawSquare() {
        const QPoint corners[] = {{100, 50}, {200, 50}, {200, 150}, {100, 150}};
        QTest::mousePress(this, Qt::LeftButton, {}, corners[0]);
        for (const QPoint to : corners)
            test::dragOn(*this, to);
        QTest::mouseRelease(this, Qt::LeftButton, {}, corners[3]);
    }
    QPushButton* button(const QString& text) {
        for (auto* one : findChildren<QPushButton*>())
            if (one->text() == text)
                return one;
        return nullptr;
    }

    test::PressCounter behind;
    FreehandPen* pen = new FreehandPen(this, this);
    std::vector<FreehandCut> cuts;
};

class TestFreehandPen : public QObject {
    Q_OBJECT

  private slots:
    void aLineIsAnsweredAndCuts_data() {
        QTest::addColumn<QString>("answer");
        QTest::addColumn<bool>("keeps");
        QTest::newRow("remove") << "Remove inside" << false;
        QTest::newRow("keep") << "Keep inside" << true;
    }
    void aLineIsAnsweredAndCuts() {
        QFETCH(QString, answer);
        QFETCH(bool, keeps);
        PenPicture picture;
        QCOMPARE(picture.clicksBehind(), 1);  // it blocks nothing
        picture.pen->startDrawing();
        picture.drawSquare();
        QVERIFY(picture.cuts.empty());
        QVERIFY(picture.button(answer)->isVisible());
        picture.button(answer)->click();
        QCOMPARE(picture.cuts.size(), std::size_t(1));
        QCOMPARE(picture.cuts[0].keepInside, keeps);
        QVERIFY(std::abs(areaInside(picture.cuts[0].outline) - 0.25) < 1e-9);  // of 200 pixels
        QVERIFY(OutlineDistance(picture.cuts[0].outline).at({0, 0}) > 0.24);
        QVERIFY(!picture.pen->isDrawing() && !picture.button(answer)->isVisible());
    }

    void aSecondLineTakesThePlaceOfTheFirst() {
        PenPicture picture;
        picture.pen->startDrawing();
        picture.drawSquare();
        picture.drawSquare();
        picture.button("Remove inside")->click();
        QCOMPARE(picture.cuts.size(), std::size_t(1));
        QVERIFY(std::abs(areaInside(picture.cuts[0].outline) - 0.25) < 1e-9);
    }

    void aClickOrAStrokeDrawsNothing() {
        PenPicture picture;
        QSignalSpy ended(picture.pen, &FreehandPen::ended);
        picture.pen->startDrawing();
        QTest::mouseClick(&picture, Qt::LeftButton, {}, {50, 50});
        QCOMPARE(ended.size(), 1);
        picture.pen->startDrawing();
        QTest::mousePress(&picture, Qt::LeftButton, {}, {50, 50});
        test::dragOn(picture, {150, 51});
        QTest::mouseRelease(&picture, Qt::LeftButton, {}, {150, 51});
        QCOMPARE(ended.size(), 2);
        QVERIFY(picture.cuts.empty() && !picture.pen->isDrawing());
    }

    void givenUpNothingIsDrawn() {
        PenPicture picture;
        picture.pen->startDrawing();
        picture.drawSquare();
        picture.pen->stopDrawing();
        QVERIFY(!picture.button("Keep inside")->isVisible());
        QVERIFY(picture.cuts.empty() && picture.clicksBehind() == 1);
    }

    void cancelledItEnds() {
        PenPicture picture;
        QSignalSpy ended(picture.pen, &FreehandPen::ended);
        QVERIFY(!picture.tools().cancel());
        picture.pen->startDrawing();
        QCOMPARE(picture.cursor().shape(), Qt::CrossCursor);
        QVERIFY(picture.tools().cancel());
        QVERIFY(ended.size() == 1 && !picture.pen->isDrawing());
        QCOMPARE(picture.cursor().shape(), Qt::ArrowCursor);
    }

    /// A line belongs to the view that it was drawn on.
    void anotherViewForgetsTheLine() {
        PenPicture picture;
        picture.pen->startDrawing();
        picture.drawSquare();
        picture.showImage({150, 100}, {});  // a finer picture of the same view
        QVERIFY(picture.button("Keep inside")->isVisible());
        picture.showImage({300, 200}, {.eyeMm = {1, 2, 3}});
        QVERIFY(!picture.button("Keep inside")->isVisible());
        QVERIFY(picture.pen->isDrawing());
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestFreehandPen)
#include "freehand_pen_test.moc"
