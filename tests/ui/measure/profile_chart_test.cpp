/// The chart of the HU along a distance: what is where, in words and in pixels.

#include <QImage>
#include <QTest>

#include "ui/measure/profile_chart.h"

namespace pdr::ui {
namespace {

/// A plate of 900 HU from 0 to 20 mm, in 40 HU.
ShownProfile plate() {
    ShownProfile profile{{}, 20, {520, std::nullopt}};
    for (int n = -5; n <= 25; ++n)
        profile.samples.push_back({double(n), n < 0 || n > 20 ? 40.0 : 900.0, true});
    return profile;
}

QImage painted(QWidget& chart) {
    QImage image(chart.size(), QImage::Format_RGB32);
    chart.render(&image);
    return image;
}

}  // namespace

class ProfileChartTest : public QObject {
    Q_OBJECT

  private slots:
    void withoutAProfileThereIsNoChart() {
        ProfileChart chart;
        QVERIFY(chart.isHidden());
        chart.setProfile(plate());
        QVERIFY(!chart.isHidden());
        chart.setProfile(std::nullopt);
        QVERIFY(chart.isHidden());
    }

    void itIsDescribedInWords() {
        ProfileChart chart;
        chart.setProfile(plate());
        const QString said = chart.accessibleDescription();
        QVERIFY2(said.contains("From 40 to 900 HU over 20.0 mm.") && said.contains("at 520 HU"), qPrintable(said));
        QCOMPARE(said.count("An end at an edge"), 1);
    }

    void arrowKeysReadOffValues() {
        ProfileChart chart;
        chart.resize(300, 130);
        chart.setProfile(plate());
        QCOMPARE(chart.reading(), QString());
        QTest::keyClick(&chart, Qt::Key_Home);
        QCOMPARE(chart.reading(), QString("-5.0 mm: 40 HU"));
        for (int n = 0; n < 5; ++n)
            QTest::keyClick(&chart, Qt::Key_Right);
        QCOMPARE(chart.reading(), QString("0.0 mm: 900 HU"));
        QVERIFY(chart.accessibleDescription().startsWith("0.0 mm: 900 HU. "));
        QTest::keyClick(&chart, Qt::Key_End);
        QTest::keyClick(&chart, Qt::Key_Right);
        QCOMPARE(chart.reading(), QString("25.0 mm: 40 HU"));
        QTest::mouseMove(&chart, chart.pointOf(10, 500).toPoint());
        QTRY_COMPARE(chart.reading(), QString("10.0 mm: 900 HU"));
        ShownProfile outside = plate();
        outside.samples[0].measured = false;
        chart.setProfile(outside);
        QTest::keyClick(&chart, Qt::Key_Home);
        QCOMPARE(chart.reading(), QString("-5.0 mm: nothing measured"));
        outside.samples[1].acrossHole = true;
        chart.setProfile(outside);
        QTest::keyClick(&chart, Qt::Key_Home);
        QTest::keyClick(&chart, Qt::Key_Right);
        QCOMPARE(chart.reading(), QString("-4.0 mm: 40 HU, interpolated across a hole"));
    }

    /// Along the plate, a column of pixels in three or fewer of five has ink where the curve is dotted; all have
    /// beside.
    void theCurveIsDottedAcrossAHole() {
        ShownProfile profile = plate();
        for (ShownProfile::Sample& sample : profile.samples)
            sample.acrossHole = sample.mm > 8 && sample.mm < 20;
        ProfileChart chart;
        QPalette palette(Qt::white);
        palette.setColor(QPalette::WindowText, Qt::black);
        palette.setColor(QPalette::Window, Qt::white);
        chart.setPalette(palette);
        chart.resize(600, 130);
        chart.setProfile(profile);
        const QImage image = painted(chart);
        const auto inked = [&](double fromMm, double toMm) {
            int columns = 0, count = 0;
            for (int x = int(chart.pointOf(fromMm, 900).x()); x < int(chart.pointOf(toMm, 900).x()); ++x, ++columns) {
                int darkest = 255;
                for (int y = -2; y <= 2; ++y)
                    darkest = std::min(darkest, qGray(image.pixel(x, int(chart.pointOf(0, 900).y()) + y)));
                count += darkest < 150;
            }
            return double(count) / columns;
        };
        QVERIFY2(inked(1, 8) == 1, qPrintable(QString::number(inked(1, 8))));
        QVERIFY2(inked(9, 19) > 0.1 && inked(9, 19) < 0.6, qPrintable(QString::number(inked(9, 19))));
    }

    /// The curve, the ends and the half level are where their numbers are, light on dark and dark on light.
    void whatIsPaintedIsWhereItSays() {
        for (const QColor ground : {Qt::white, Qt::black}) {
            ProfileChart chart;
            QPalette palette(ground);
            palette.setColor(QPalette::WindowText, ground == Qt::white ? Qt::black : Qt::white);
            palette.setColor(QPalette::Window, ground);
            palette.setColor(QPalette::Highlight, Qt::red);
            chart.setPalette(palette);
            chart.resize(300, 130);
            chart.setProfile(plate());
            const QImage image = painted(chart);
            const auto isNear = [&](QPointF at, const QColor& colour) {
                for (int y = -2; y <= 2; ++y)
                    for (int x = -2; x <= 2; ++x) {
                        const QColor pixel(image.pixel(at.toPoint() + QPoint(x, y)));
                        if (std::abs(pixel.red() - colour.red()) + std::abs(pixel.green() - colour.green()) < 160)
                            return true;
                    }
                return false;
            };
            const QColor ink = palette.color(QPalette::WindowText);
            QVERIFY(isNear(chart.pointOf(10, 900), ink) && isNear(chart.pointOf(-3, 40), ink));
            QVERIFY(!isNear(chart.pointOf(10, 500), ink) && !isNear(chart.pointOf(10, 500), Qt::red));
            QVERIFY(isNear(chart.pointOf(0, 520), Qt::red));
            const auto isDashed = [&](double mm) {  // somewhere along its height
                bool found = false;
                for (double hu = 100; hu < 950; hu += 20)
                    found |= isNear(chart.pointOf(mm, hu), Qt::red);
                return found;
            };
            QVERIFY(isDashed(20) && !isDashed(15));
            QVERIFY(chart.pointOf(0, 900).y() < chart.pointOf(0, 40).y() - 60);
            QVERIFY(chart.pointOf(20, 40).x() > chart.pointOf(0, 40).x() + 120);
            const QRectF inside(QPointF(), QSizeF(chart.size()));
            for (const double mm : {-5.0, 25.0})
                for (const double hu : {40.0, 900.0})
                    QVERIFY(inside.contains(chart.pointOf(mm, hu)));
        }
    }
};

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::ProfileChartTest)
#include "profile_chart_test.moc"
