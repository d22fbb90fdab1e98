/// The handles of the cut over the image: they follow the mouse, and presses beside them reach other tools.

#include "ui/cut/cut_layer.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/support/desktop/mouse.h"
#include "tests/support/desktop/press_counter.h"
#include "ui/view/viewport.h"

namespace pdr::ui {

using Kind = CutHandle::Kind;

static const Uncut kBody{{-100, -80, -120}, {100, 80, 120}};

/// An image of 300 x 200 pixels that counts the clicks beside the handles; the body is seen from the right front.
class CutImage : public Viewport {
  public:
    CutImage() {
        resize(300, 200);
        setImage({QImage(300, 200, QImage::Format_RGB32), camera});
        tools().add(behind);
        tools().add(*layer);
        layer->setCuts({}, kBody);
        layer->setHandlesShown(true);
        QObject::connect(layer, &CutLayer::clipEdited, [this](const Clip& clip, bool moving) {
            edited = clip;
            ended += !moving;
        });
        show();
    }
    QPoint at(CutHandle handle) const { return layer->marks().placeOf(handle).value_or(QPointF(-99, -99)).toPoint(); }
    void drag(QPoint from, QPoint to) {
        QTest::mousePress(this, Qt::LeftButton, {}, from);
        move((from + to) / 2);
        move(to);
    }
    void move(QPoint to) { test::dragOn(*this, to); }
    void doubleClick(QPoint at) {
        QTest::mouseDClick(this, Qt::LeftButton, {}, at);
        QTest::mouseRelease(this, Qt::LeftButton, {}, at);
    }
    /// Moves the mouse without a button.
    void hover(QPoint to) { test::dragOn(*this, to, Qt::NoButton); }

    Camera camera{.eyeMm = {-500, -600, 100}, .targetMm = {0, 0, 0}, .fovDegrees = 30};
    int ended = 0;
    test::PressCounter behind;
    Clip edited;
    CutLayer* layer = new CutLayer(this);
};

class TestCutLayer : public QObject {
    Q_OBJECT

  private slots:
    void aDraggedFaceGoesWhereTheMouseIs() {
        CutImage picture;
        const CutHandle head{Kind::face, 5};
        picture.drag(picture.at(head), picture.at(head) + QPoint(0, 20));
        QVERIFY(picture.edited.box && picture.edited.box->highMm.z < 115);
        QCOMPARE(picture.ended, 0);
        QVERIFY((picture.at(head) - QPoint(0, 0)).y() > 0);
        QTest::mouseRelease(&picture, Qt::LeftButton, {}, picture.at(head));
        QCOMPARE(picture.ended, 1);
        QCOMPARE(picture.behind.clicks, 0);
        for (int face = 0; face < 5; ++face)
            QCOMPARE(cutOffMm(picture.edited, kBody, face), 0.0);
    }

    void theHandleStaysUnderTheMouse() {
        CutImage picture;
        const CutHandle head{Kind::face, 5};
        const QPoint from = picture.at(head), to = from + QPoint(1, 25);
        picture.drag(from, to);
        QVERIFY(std::abs(picture.at(head).y() - to.y()) <= 1);
    }

    void besideAHandleTheHandReachesTheImage() {
        CutImage picture;
        QTest::mouseClick(&picture, Qt::LeftButton, {}, {5, 5});
        picture.doubleClick({5, 5});
        QCOMPARE(picture.behind.clicks, 1);
        QCOMPARE(picture.behind.doubleClicks, 1);
        const QPoint head = picture.at({Kind::face, 5});
        QTest::mouseClick(&picture, Qt::LeftButton, Qt::ShiftModifier, head);
        QTest::mouseClick(&picture, Qt::RightButton, {}, head);
        QCOMPARE(picture.behind.clicks, 3);
        picture.layer->setHandlesShown(false);
        QTest::mouseClick(&picture, Qt::LeftButton, {}, head);
        QCOMPARE(picture.behind.clicks, 4);
        QVERIFY(picture.edited == Clip());
    }

    void theHandleUnderTheMouseHasItsCursor() {
        CutImage picture;
        picture.hover(picture.at({Kind::face, 5}));
        QCOMPARE(picture.cursor().shape(), Qt::SizeAllCursor);
        picture.hover({5, 5});
        QCOMPARE(picture.cursor().shape(), Qt::ArrowCursor);
        picture.hover(picture.at({Kind::face, 5}));
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&picture, &leave);
        QCOMPARE(picture.cursor().shape(), Qt::ArrowCursor);
    }

    void givenUpItIsAsBefore() {
        CutImage picture;
        QSignalSpy givenUp(picture.layer, &CutLayer::gestureGivenUp);
        const QPoint head = picture.at({Kind::face, 5});
        QVERIFY(!picture.layer->cancel());
        picture.drag(head, head + QPoint(0, 20));
        QVERIFY(picture.layer->cancel());
        QCOMPARE(givenUp.size(), 1);
        QCOMPARE(picture.at({Kind::face, 5}), head);
        picture.edited = {};
        picture.move(head + QPoint(0, 30));
        QTest::mouseRelease(&picture, Qt::LeftButton, {}, head + QPoint(0, 30));
        QVERIFY(picture.edited == Clip() && picture.ended == 0);
    }

    void aDoubleClickBringsASideBack() {
        CutImage picture;
        Clip clip = withCutOff(withCutOff({}, kBody, 5, 50), kBody, 0, 30);
        clip.planes = {{{0, 20, 0}, {0.3, -1, 0}}};
        picture.layer->setCuts(clip, kBody);
        picture.doubleClick(picture.at({Kind::face, 5}));
        QCOMPARE(cutOffMm(picture.edited, kBody, 5), 0.0);
        QCOMPARE(cutOffMm(picture.edited, kBody, 0), 30.0);
        picture.doubleClick(picture.at({Kind::offset, 0}));
        QVERIFY(picture.edited.planes.empty() && picture.edited.box);
        QCOMPARE(picture.ended, 2);
        QCOMPARE(picture.behind.doubleClicks, 0);
    }

    void planesAreMovedAndTilted() {
        CutImage picture;
        Clip clip;
        clip.planes = {{{0, 0, 0}, {0, -1, 0}}};
        picture.layer->setCuts(clip, kBody);
        const QPoint disc = picture.at({Kind::offset, 0});
        picture.drag(disc, disc + QPoint(15, 0));
        QTest::mouseRelease(&picture, Qt::LeftButton, {}, disc + QPoint(15, 0));
        const ClipPlane moved = picture.edited.planes[0];
        QCOMPARE(moved.normal, dvec3(0, -1, 0));
        QVERIFY(std::abs(planeOffsetMm(moved, kBody)) > 10);

        const QPoint ring = picture.layer->marks().placeOf({Kind::tilt, 0})->toPoint();
        QVERIFY(picture.layer->marks().at(ring) == CutHandle{} || picture.layer->marks().at(ring)->kind != Kind::face);
        picture.layer->setCuts(picture.edited, kBody);
        bool tilted = false;
        for (int angle = 0; angle < 360 && !tilted; angle += 5) {  // somewhere on it no other handle is in the way
            const auto way = tiltRing(picture.edited.planes[0], kBody)[std::size_t(angle * 48 / 360)];
            const dvec2 seen = *ViewGeometry(picture.camera, 1.5).at(way);
            const QPoint place(int(seen.x * 300), int(seen.y * 200));
            if (picture.layer->marks().at(place) != CutHandle{Kind::tilt, 0})
                continue;
            picture.drag(place, place + QPoint(20, 0));
            QTest::mouseRelease(&picture, Qt::LeftButton, {}, place + QPoint(20, 0));
            tilted = true;
        }
        QVERIFY(tilted);
        const double degrees = glm::degrees(std::acos(glm::dot(picture.edited.planes[0].normal, dvec3(0, -1, 0))));
        QVERIFY2(std::abs(degrees - 18) < 1, qPrintable(QString::number(degrees)));  // a tenth of the height
    }

    void whatIsNotThereIsNotDrawn() {
        CutImage picture;
        const auto isDrawn = [&] {
            QImage image(picture.size(), QImage::Format_RGB32);
            image.fill(Qt::black);
            const QImage empty = image;
            QPainter painter(&image);
            picture.layer->paint(painter, {picture.size(), picture.rect(), picture.camera});
            painter.end();
            return image != empty;
        };
        QVERIFY(isDrawn());
        picture.layer->setCuts({}, std::nullopt);
        QVERIFY(!isDrawn());
        picture.layer->setCuts({}, kBody);
        picture.layer->setHandlesShown(false);
        QVERIFY(!isDrawn());
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestCutLayer)
#include "cut_layer_test.moc"
