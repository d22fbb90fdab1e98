/// The box drawn on the image: it takes no press unless the user draws.

#include <QSignalSpy>
#include <QTest>

#include "tests/support/desktop/mouse.h"
#include "tests/support/desktop/press_counter.h"
#include "ui/view/region_box.h"
#include "ui/view/viewport.h"

namespace pdr::ui {

/// A view of 200 x 100 pixels that counts the clicks that the box does not take.
class Image : public Viewport {
  public:
    Image() {
        resize(200, 100);
        tools().add(behind);
        box = new RegionBox(this);
        show();
    }
    QImage image() {
        QImage image(size(), QImage::Format_RGB32);
        render(&image, {}, {}, {});
        return image;
    }
    test::PressCounter behind;
    RegionBox* box;
};

static void drag(Image& picture, QPoint from, QPoint to) {
    QTest::mousePress(&picture, Qt::LeftButton, {}, from);
    test::dragOn(picture, to);
    QTest::mouseRelease(&picture, Qt::LeftButton, {}, to);
}

class TestRegionBox : public QObject {
    Q_OBJECT

  private slots:
    void theHandReachesOtherToolsThroughIt() {
        Image picture;
        picture.box->setBox(QRectF(0, 0, 1, 1));
        drag(picture, {50, 50}, {80, 80});
        QCOMPARE(picture.behind.clicks, 1);
    }

    void aDragDrawsABoxInPartsOfTheImage_data() {
        QTest::addColumn<QPoint>("from");
        QTest::addColumn<QPoint>("to");
        QTest::newRow("down") << QPoint(50, 20) << QPoint(150, 60);
        QTest::newRow("up") << QPoint(150, 60) << QPoint(50, 20);
    }
    void aDragDrawsABoxInPartsOfTheImage() {
        QFETCH(QPoint, from);
        QFETCH(QPoint, to);
        Image picture;
        QSignalSpy drawn(picture.box, &RegionBox::drawn), notDrawn(picture.box, &RegionBox::notDrawn);
        picture.box->startDrawing();
        drag(picture, from, to);
        QCOMPARE(drawn.size(), 1);
        QCOMPARE(drawn[0][0].toRectF(), QRectF(0.25, 0.2, 0.5, 0.4));
        QVERIFY(notDrawn.isEmpty() && !picture.box->isDrawing());
        drag(picture, {50, 50}, {80, 80});
        QCOMPARE(picture.behind.clicks, 1);
    }

    void itEndsAtTheImagesEdge() {
        Image picture;
        QSignalSpy drawn(picture.box, &RegionBox::drawn);
        picture.box->startDrawing();
        drag(picture, {100, 50}, {500, 500});
        QCOMPARE(drawn[0][0].toRectF(), QRectF(0.5, 0.5, 0.5, 0.5));
    }

    void aClickDrawsNone() {
        Image picture;
        QSignalSpy drawn(picture.box, &RegionBox::drawn), notDrawn(picture.box, &RegionBox::notDrawn);
        picture.box->startDrawing();
        drag(picture, {50, 50}, {53, 90});
        QVERIFY(drawn.isEmpty() && notDrawn.size() == 1 && !picture.box->isDrawing());
    }

    void itIsSeenWhereItIsInAnImageOfAnySize() {
        Image picture;
        picture.box->setBox(QRectF(0.25, 0.5, 0.5, 0.25));
        for (const QSize size : {QSize(200, 100), QSize(400, 300)}) {
            picture.resize(size);
            const QImage image = picture.image();
            const auto isLit = [&](double x, double y) {
                return qRed(image.pixel(int(x * size.width()), int(y * size.height()))) > 100;
            };
            QVERIFY(isLit(0.25, 0.6) && isLit(0.5, 0.5) && !isLit(0.5, 0.6) && !isLit(0.1, 0.6));
        }
        picture.box->setBox(std::nullopt);
        QImage empty(picture.size(), QImage::Format_RGB32);
        empty.fill(Qt::black);
        QVERIFY(picture.image() == empty);
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestRegionBox)
#include "region_box_test.moc"
