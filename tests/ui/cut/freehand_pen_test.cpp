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
class PenImage : public Viewport {
  public:
    PenImage() {
        resize(300, 200);
        showImage({300, 200}, {});
        tools().add(behind);
        tools().add(*pen);
        QObject::connect(pen, &FreehandPen::drawn, [this](const FreehandCut& cut) { cuts.push_back(cut); });
        show();
    }
    void showImage(QSize size, const Camera& camera) { setImage({QImage(size, QImage::Format_RGB32), camera}); }
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
        PenImage image;
        QCOMPARE(image.clicksBehind(), 1);  // it blocks nothing
        image.pen->startDrawing();
        image.drawSquare();
        QVERIFY(image.cuts.empty());
        QVERIFY(image.button(answer)->isVisible());
        image.button(answer)->click();
        QCOMPARE(image.cuts.size(), std::size_t(1));
        QCOMPARE(image.cuts[0].keepInside, keeps);
        QVERIFY(std::abs(areaInside(image.cuts[0].outline) - 0.25) < 1e-9);  // of 200 pixels
        QVERIFY(OutlineDistance(image.cuts[0].outline).at({0, 0}) > 0.24);
        QVERIFY(!image.pen->isDrawing() && !image.button(answer)->isVisible());
    }

    void aSecondLineTakesThePlaceOfTheFirst() {
        PenImage image;
        image.pen->startDrawing();
        image.drawSquare();
        image.drawSquare();
        image.button("Remove inside")->click();
        QCOMPARE(image.cuts.size(), std::size_t(1));
        QVERIFY(std::abs(areaInside(image.cuts[0].outline) - 0.25) < 1e-9);
    }

    void aClickOrAStrokeDrawsNothing() {
        PenImage image;
        QSignalSpy ended(image.pen, &FreehandPen::ended);
        image.pen->startDrawing();
        QTest::mouseClick(&image, Qt::LeftButton, {}, {50, 50});
        QCOMPARE(ended.size(), 1);
        image.pen->startDrawing();
        QTest::mousePress(&image, Qt::LeftButton, {}, {50, 50});
        test::dragOn(image, {150, 51});
        QTest::mouseRelease(&image, Qt::LeftButton, {}, {150, 51});
        QCOMPARE(ended.size(), 2);
        QVERIFY(image.cuts.empty() && !image.pen->isDrawing());
    }

    void givenUpNothingIsDrawn() {
        PenImage image;
        image.pen->startDrawing();
        image.drawSquare();
        image.pen->stopDrawing();
        QVERIFY(!image.button("Keep inside")->isVisible());
        QVERIFY(image.cuts.empty() && image.clicksBehind() == 1);
    }

    void cancelledItEnds() {
        PenImage image;
        QSignalSpy ended(image.pen, &FreehandPen::ended);
        QVERIFY(!image.tools().cancel());
        image.pen->startDrawing();
        QCOMPARE(image.cursor().shape(), Qt::CrossCursor);
        QVERIFY(image.tools().cancel());
        QVERIFY(ended.size() == 1 && !image.pen->isDrawing());
        QCOMPARE(image.cursor().shape(), Qt::ArrowCursor);
    }

    /// A line belongs to the view that it was drawn on.
    void anotherViewForgetsTheLine() {
        PenImage image;
        image.pen->startDrawing();
        image.drawSquare();
        image.showImage({150, 100}, {});  // a finer image of the same view
        QVERIFY(image.button("Keep inside")->isVisible());
        image.showImage({300, 200}, {.eyeMm = {1, 2, 3}});
        QVERIFY(!image.button("Keep inside")->isVisible());
        QVERIFY(image.pen->isDrawing());
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestFreehandPen)
#include "freehand_pen_test.moc"
