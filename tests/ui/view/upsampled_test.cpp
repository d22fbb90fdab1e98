/// Coarse images are shown without visible pixel blocks.

#include <QPainter>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>

#include "ui/view/shown_image.h"
#include "ui/view/upsampled.h"

namespace pdr::ui {

class TestUpsampled : public QObject {
    Q_OBJECT

  private slots:
    void whatIsEvenStaysEvenAndARampARamp();
    void aCoarseImageOnTheScreenHasNoKinks();
};

static QImage imageOf(QSize size, const std::function<double(int, int)>& grey) {
    QImage image(size, QImage::Format_RGBX8888);
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x) {
            const int level = int(std::lround(grey(x, y)));
            image.setPixel(x, y, qRgb(level, level, level));
        }
    return image;
}

void TestUpsampled::whatIsEvenStaysEvenAndARampARamp() {
    const QImage even = upsampled(imageOf({5, 4}, [](int, int) { return 77; }), {23, 31});
    QCOMPARE(even.size(), QSize(23, 31));
    for (int y = 0; y < 31; ++y)
        for (int x = 0; x < 23; ++x)
            QCOMPARE(even.pixel(x, y), qRgb(77, 77, 77));
    const QImage ramp = upsampled(imageOf({20, 3}, [](int x, int) { return 10 * x; }), {120, 18});
    for (int x = 20; x < 100; ++x)
        QVERIFY(std::abs(qRed(ramp.pixel(x, 9)) - 10 * ((x + 0.5) / 6 - 0.5)) <= 1);
}

/// Measures a slanted edge enlarged six times: the largest change of its slope from pixel to pixel.
void TestUpsampled::aCoarseImageOnTheScreenHasNoKinks() {
    const QImage coarse =
        imageOf({60, 40}, [](int x, int y) { return 255 * std::clamp(0.5 + (x - 30) - 0.37 * (y - 20), 0.0, 1.0); });
    const auto kink = [](const QImage& image) {
        int most = 0;
        for (int y = 20; y < 220; ++y)
            for (int x = 21; x < 339; ++x)
                most = std::max(most, std::abs(qRed(image.pixel(x - 1, y)) + qRed(image.pixel(x + 1, y)) -
                                               2 * qRed(image.pixel(x, y))));
        return most;
    };
    QImage straight(360, 240, QImage::Format_RGBX8888), shown = straight;
    QPainter lines(&straight);
    lines.setRenderHint(QPainter::SmoothPixmapTransform);
    lines.drawImage(QRectF(0, 0, 360, 240), coarse);
    lines.end();
    ShownImage picture;
    picture.image = coarse;
    QPainter painter(&shown);
    paintShownImage(painter, picture, {.size = {360, 240}});
    painter.end();
    QVERIFY2(kink(upsampled(coarse, {360, 240})) * 2 < kink(straight),
             qPrintable(QString("%1, %2").arg(kink(upsampled(coarse, {360, 240}))).arg(kink(straight))));
    const QRect free(60, 40, 220, 70);  // an area without text
    const QImage smooth = upsampled(coarse, {360, 240});
    int off = 0;
    for (int y = free.top(); y < free.bottom(); ++y)
        for (int x = free.left(); x < free.right(); ++x)
            off = std::max(off, std::abs(qRed(shown.pixel(x, y)) - qRed(smooth.pixel(x, y))));
    QVERIFY2(off <= 1, qPrintable(QString::number(off)));
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestUpsampled)
#include "upsampled_test.moc"
