/// A line drawn on the image becomes a cut when the user has chosen what it cuts.

#include "ui/cut/freehand_pen.h"
#include "tests/support/desktop/mouse.h"

#include <QSignalSpy>
#include <QTest>

#include "render/scene/edit/drawn_outline.h"
#include "tests/support/desktop/mouse.h"

namespace pdr::ui {

/// An image of 300 x 200 pixels below a pen.
class PenPicture : public QWidget {
  public:
    PenPicture() {
        resize(300, 200);
        pen->setPicture({}, {300, 200});
        QObject::connect(pen, &FreehandPen::drawn, [this](const FreehandCut& cut) { cuts.push_back(cut); });
        show();
    }
    /// A square of 100 pixels around the middle.
    void drawSquare() {
        const QPoint corners[] = {{100, 50}, {200, 50}, {200, 150}, {100, 150}};
        QTest::mousePress(pen, Qt::LeftButton, {}, corners[0]);
        for (const QPoint to : corners)
            test::dragOn(*pen, to);
        QTest::mouseRelease(pen, Qt::LeftButton, {}, corners[3]);
    }
    QPushButton* button(const QString& text) {
        for (auto* one : pen->findChildren<QPushButton*>())
            if (one->text() == text)
                return one;
        return nullptr;
    }

    FreehandPen* pen = new FreehandPen(this);
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
        QVERIFY(picture.childAt(150, 100) == nullptr);  // it blocks nothing
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
        QTest::mouseClick(picture.pen, Qt::LeftButton, {}, {50, 50});
        QCOMPARE(ended.size(), 1);
        picture.pen->startDrawing();
        QTest::mousePress(picture.pen, Qt::LeftButton, {}, {50, 50});
        test::dragOn(*picture.pen, {150, 51});
        QTest::mouseRelease(picture.pen, Qt::LeftButton, {}, {150, 51});
        QCOMPARE(ended.size(), 2);
        QVERIFY(picture.cuts.empty() && !picture.pen->isDrawing());
    }

    void givenUpNothingIsDrawn() {
        PenPicture picture;
        picture.pen->startDrawing();
        picture.drawSquare();
        picture.pen->stopDrawing();
        QVERIFY(!picture.button("Keep inside")->isVisible());
        QVERIFY(picture.cuts.empty() && picture.childAt(150, 100) == nullptr);
    }

    /// A line belongs to the view that it was drawn on.
    void anotherViewForgetsTheLine() {
        PenPicture picture;
        picture.pen->startDrawing();
        picture.drawSquare();
        picture.pen->setPicture({}, {150, 100});  // a finer picture of the same view
        QVERIFY(picture.button("Keep inside")->isVisible());
        picture.pen->setPicture({.eyeMm = {1, 2, 3}}, {300, 200});
        QVERIFY(!picture.button("Keep inside")->isVisible());
        QVERIFY(picture.pen->isDrawing());
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestFreehandPen)
#include "freehand_pen_test.moc"
