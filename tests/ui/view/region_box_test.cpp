/// The box drawn on the image: its layer blocks nothing unless the user draws.

#include <QSignalSpy>
#include <QTest>

#include "tests/support/desktop/mouse.h"
#include "ui/view/region_box.h"

namespace pdr::ui {

/// An image of 200 x 100 pixels that counts the clicks on it, below its layer.
class Picture : public QWidget {
  public:
    Picture() {
        resize(200, 100);
        show();
    }
    int clicks = 0;
    RegionBox* layer = new RegionBox(this);

  protected:
    void mousePressEvent(QMouseEvent*) override { ++clicks; }
};

/// Returns the widget that gets a press at `place`, as the screen delivers it: the uppermost one that accepts it.
static QWidget* under(Picture& picture, QPoint place) {
    QWidget* child = picture.childAt(place);
    return child ? child : &picture;
}

static void drag(Picture& picture, QPoint from, QPoint to) {
    QWidget* taker = under(picture, from);
    QTest::mousePress(taker, Qt::LeftButton, {}, from);
    test::dragOn(*taker, to);
    QTest::mouseRelease(taker, Qt::LeftButton, {}, to);
}

class TestRegionBox : public QObject {
    Q_OBJECT

  private slots:
    void theHandReachesThePictureThroughIt() {
        Picture picture;
        picture.layer->setBox(QRectF(0, 0, 1, 1));
        drag(picture, {50, 50}, {80, 80});
        QCOMPARE(picture.clicks, 1);
    }

    void aDragDrawsABoxInPartsOfThePicture_data() {
        QTest::addColumn<QPoint>("from");
        QTest::addColumn<QPoint>("to");
        QTest::newRow("down") << QPoint(50, 20) << QPoint(150, 60);
        QTest::newRow("up") << QPoint(150, 60) << QPoint(50, 20);
    }
    void aDragDrawsABoxInPartsOfThePicture() {
        QFETCH(QPoint, from);
        QFETCH(QPoint, to);
        Picture picture;
        QSignalSpy drawn(picture.layer, &RegionBox::drawn), notDrawn(picture.layer, &RegionBox::notDrawn);
        picture.layer->startDrawing();
        drag(picture, from, to);
        QCOMPARE(drawn.size(), 1);
        QCOMPARE(drawn[0][0].toRectF(), QRectF(0.25, 0.2, 0.5, 0.4));
        QVERIFY(notDrawn.isEmpty() && !picture.layer->isDrawing());
        drag(picture, {50, 50}, {80, 80});
        QCOMPARE(picture.clicks, 1);
    }

    void itEndsAtThePicturesEdge() {
        Picture picture;
        QSignalSpy drawn(picture.layer, &RegionBox::drawn);
        picture.layer->startDrawing();
        drag(picture, {100, 50}, {500, 500});
        QCOMPARE(drawn[0][0].toRectF(), QRectF(0.5, 0.5, 0.5, 0.5));
    }

    void aClickDrawsNone() {
        Picture picture;
        QSignalSpy drawn(picture.layer, &RegionBox::drawn), notDrawn(picture.layer, &RegionBox::notDrawn);
        picture.layer->startDrawing();
        drag(picture, {50, 50}, {53, 90});
        QVERIFY(drawn.isEmpty() && notDrawn.size() == 1 && !picture.layer->isDrawing());
    }

    void itIsSeenWhereItIsInAPictureOfAnySize() {
        Picture picture;
        picture.layer->setBox(QRectF(0.25, 0.5, 0.5, 0.25));
        for (const QSize size : {QSize(200, 100), QSize(400, 300)}) {
            picture.resize(size);
            QCOMPARE(picture.layer->size(), size);
            QImage image(size, QImage::Format_RGB32);
            image.fill(Qt::black);
            picture.layer->render(&image, {}, {}, {});
            const auto isLit = [&](double x, double y) {
                return qRed(image.pixel(int(x * size.width()), int(y * size.height()))) > 100;
            };
            QVERIFY(isLit(0.25, 0.6) && isLit(0.5, 0.5) && !isLit(0.5, 0.6) && !isLit(0.1, 0.6));
        }
        picture.layer->setBox(std::nullopt);
        QImage image(picture.size(), QImage::Format_RGB32);
        image.fill(Qt::black);
        const QImage empty = image;
        picture.layer->render(&image, {}, {}, {});
        QVERIFY(image == empty);
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestRegionBox)
#include "region_box_test.moc"
