/// The image in the viewport: its place, what is painted on it, the sizes that are reported, and tips under the
/// pointer.

#include <QHelpEvent>
#include <QSignalSpy>
#include <QTest>
#include <QToolTip>

#include "tests/support/desktop/hand_on_viewport.h"
#include "tests/support/patience.h"

namespace pdr::ui {

class TestViewportImage : public QObject {
    Q_OBJECT

  private slots:
    void aCoarseImageIsStretchedToTheHeight();
    void bracketsStandAtTheEndsOfLostLinesAlone();
    void theCaptionStandsInAnImageAlone();
    void withoutImageTheMessageIsShown();
    void theNewSizeIsTold();
    void withAnImageTheSettledSizeIsTold();
    void whereTheMouseRestsIsToldInPartsOfTheImage();
    void aTipIsShownOnlyWhereTheMouseStillRests();
};

static void restAt(Viewport& viewport, QPoint place) {
    QHelpEvent event(QEvent::ToolTip, place, viewport.mapToGlobal(place));
    QCoreApplication::sendEvent(&viewport, &event);
}

void TestViewportImage::aCoarseImageIsStretchedToTheHeight() {
    Hand hand;
    hand.viewport.setCamera({});
    QImage coarse(40, 20, QImage::Format_RGBX8888);
    coarse.fill(Qt::red);
    hand.viewport.setImage({coarse, hand.camera, {}});
    const QImage shown = hand.viewport.grab().toImage();
    for (const QPoint corner : {QPoint(1, 1), QPoint(398, 1), QPoint(1, 198), QPoint(398, 198)})
        QCOMPARE(shown.pixelColor(corner), QColor(Qt::red));
    // An image of another shape keeps the size of what it shows: the height fits, the rest is ground.
    hand.viewport.setImage({coarse.copy(0, 0, 20, 20), hand.camera, {}});
    const QImage narrow = hand.viewport.grab().toImage();
    QCOMPARE(narrow.pixelColor(200, 1), QColor(Qt::red));
    QCOMPARE(narrow.pixelColor(50, 100), QColor(Qt::black));
}

/// An image of half the view's size contains a line: its ends are marked, but not the line itself nor the texts, and
/// only with the error map.
void TestViewportImage::bracketsStandAtTheEndsOfLostLinesAlone() {
    Hand hand;
    QImage image(200, 100, QImage::Format_RGBX8888);
    image.fill(Qt::darkGray);
    QImage map(image.size(), QImage::Format_RGBA8888);
    map.fill(Qt::transparent);
    const auto shown = [&](const QList<QLineF>& lostLines, bool withMap = true) {
        hand.viewport.setImage({image, hand.camera, "bone", "denoised", lostLines, {}, withMap ? map : QImage(), true});
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

/// The caption is painted only in full screen; otherwise the status bar shows it.
void TestViewportImage::theCaptionStandsInAnImageAlone() {
    Hand hand;
    QImage image(400, 200, QImage::Format_RGBX8888);
    image.fill(Qt::darkGray);
    const auto shown = [&](bool alone, const QString& caption) {
        hand.viewport.setCaptionShown(alone);
        hand.viewport.setImage({image, hand.camera, "bone", {}, {}, caption});
        return hand.viewport.grab().toImage();
    };
    QVERIFY(shown(false, {}) == shown(false, "Preview"));
    QVERIFY(shown(true, {}) == shown(false, {}));
    QVERIFY(shown(true, "Preview") != shown(true, {}));
}

void TestViewportImage::withoutImageTheMessageIsShown() {
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

void TestViewportImage::theNewSizeIsTold() {
    Hand hand;
    QSignalSpy size(&hand.viewport, &Viewport::sizeInPixelsChanged);
    hand.viewport.resize(300, 250);
    QTRY_COMPARE_WITH_TIMEOUT(size.count(), 1, test::kPatience);
    QCOMPARE(size.first().first().toSize(), QSize(300, 250) * hand.viewport.devicePixelRatioF());
}

void TestViewportImage::withAnImageTheSettledSizeIsTold() {
    Hand hand;
    hand.viewport.setImage(shownOf({400, 200}));
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

void TestViewportImage::whereTheMouseRestsIsToldInPartsOfTheImage() {
    Hand hand;
    QSignalSpy rested(&hand.viewport, &Viewport::rested);
    restAt(hand.viewport, {100, 100});
    QCOMPARE(rested.count(), 0);  // no image
    hand.viewport.setImage(shownOf({400, 200}));
    restAt(hand.viewport, {100, 50});
    QCOMPARE(rested.takeLast()[0].toPointF(), QPointF(0.25, 0.25));
    hand.viewport.setImage(shownOf({50, 50}));  // stretched to the height, in the middle
    restAt(hand.viewport, {150, 50});
    QCOMPARE(rested.takeLast()[0].toPointF(), QPointF(0.25, 0.25));
    restAt(hand.viewport, {50, 50});
    QCOMPARE(rested.count(), 0);  // beside it
    QTest::mousePress(&hand.viewport, Qt::LeftButton, {}, {150, 50});
    restAt(hand.viewport, {150, 50});
    QCOMPARE(rested.count(), 0);  // a hand that drags
}

void TestViewportImage::aTipIsShownOnlyWhereTheMouseStillRests() {
    Hand hand;
    hand.viewport.setImage(shownOf({400, 200}));
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

QTEST_MAIN(pdr::ui::TestViewportImage)
#include "viewport_image_test.moc"
