/// The error map on the image: its colours, what is painted on top of it, and its legend.

#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "tests/support/desktop/contrast.h"
#include "ui/view/error_colours.h"
#include "ui/window/main_window.h"

namespace pdr::ui {

/// Returns the CIE 1976 lightness of an sRGB colour, D65.
static double lightness(const QColor& colour) {
    const double y = test::luminance(colour);
    return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27;
}

/// Returns OKLab from linear sRGB: the inverse of how the colours are computed.
static dvec3 okLab(const QColor& colour) {
    const double r = test::linearLight(colour.redF()), g = test::linearLight(colour.greenF()),
                 b = test::linearLight(colour.blueF());
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

static bool close(const QColor& a, const QColor& b) {
    return std::abs(a.red() - b.red()) + std::abs(a.green() - b.green()) + std::abs(a.blue() - b.blue()) <= 6;
}

class TestErrorMap : public QObject {
    Q_OBJECT

  private slots:
    void coloursBecomeEvenlyLighterAndEvenlyOther();
    void theScaleGoesFromOneToSixtyFourLevels();
    void whatIsNotKnownIsGreyAndWhatIsNoTissueIsLeftAsItIs();
    void theMapLiesOnTheImageAndLettersOnTheMap();
    void aLegendStandsBesideTheMapAlone();
    void theLegendLeavesThePatientLegible();
    void theMapHasAKeyAlsoWhereTheImageIsAlone();
};

/// The colours have eight bits per channel: each eighth of a doubling is lighter, and each half of one differs as much
/// as the others.
void TestErrorMap::coloursBecomeEvenlyLighterAndEvenlyOther() {
    const auto colourAt = [](double doublings) { return errorColour(kFinestLevels * std::exp2(doublings)); };
    for (double place = 0.125; place <= 6; place += 0.125)
        QVERIFY(lightness(colourAt(place)) > lightness(colourAt(place - 0.125)) + 0.5);
    double least = 1e9, most = 0;
    for (double place = 0.5; place <= 6; place += 0.5) {
        const double step = glm::distance(okLab(colourAt(place - 0.5)), okLab(colourAt(place)));
        least = std::min(least, step);
        most = std::max(most, step);
    }
    QVERIFY2(most < 1.15 * least, qPrintable(QString("steps of %1 to %2").arg(least).arg(most)));
    QVERIFY(lightness(colourAt(0)) < 25 && lightness(colourAt(6)) > 85);
}

void TestErrorMap::theScaleGoesFromOneToSixtyFourLevels() {
    QCOMPARE(errorColour(0), errorColour(1));
    QCOMPARE(errorColour(255), errorColour(64));
    QVERIFY(errorColour(1.1) != errorColour(1) && errorColour(60) != errorColour(64));
    QCOMPARE(errorColours().size(), 256);
    QCOMPARE(QColor::fromRgba(errorColours()[levelBinOf(8)]), errorColour(8));
}

void TestErrorMap::whatIsNotKnownIsGreyAndWhatIsNoTissueIsLeftAsItIs() {
    const QColor unknown = errorColour(std::numeric_limits<double>::infinity());
    QVERIFY(unknown.saturation() == 0 && unknown.alpha() > 100);
    for (int bin = kFirstBin; bin <= kLastBin; ++bin)
        QVERIFY(QColor(errorColours()[bin]).saturation() > 80);
    QCOMPARE(qAlpha(errorColours()[kNoTissueBin]), 0);
}

/// Returns a white image of 300 x 200 pixels, whose left half has an error map of 8 levels.
static ShownImage shownWithMap() {
    ShownImage shown;
    shown.image = QImage(300, 200, QImage::Format_RGBX8888);
    shown.image.fill(Qt::white);
    shown.errorMap = QImage(300, 200, QImage::Format_Indexed8);
    shown.errorMap.setColorTable(errorColours());
    shown.errorMap.fill(int(kNoTissueBin));
    for (int y = 0; y < 200; ++y)
        std::fill_n(shown.errorMap.scanLine(y), 150, levelBinOf(8));
    shown.camera = standardView(StandardView::anterior, {0, 0, 0}, 150, 1.5);
    return shown;
}

static QImage shot(Viewport& viewport) {
    viewport.resize(300, 200);
    return viewport.grab().toImage().scaled(300, 200);
}

void TestErrorMap::theMapLiesOnTheImageAndLettersOnTheMap() {
    Viewport viewport;
    ShownImage shown = shownWithMap();
    viewport.setImage(shown);
    const QImage with = shot(viewport);
    QVERIFY(close(with.pixelColor(60, 130), errorColour(8)));
    QCOMPARE(with.pixelColor(200, 160), QColor(Qt::white));
    int letters = 0;  // "R" at the left edge
    for (int y = 90; y < 110; ++y)
        for (int x = 8; x < 30; ++x)
            letters += !close(with.pixelColor(x, y), errorColour(8));
    QVERIFY(letters > 20);
    shown.errorMap = {};
    viewport.setImage(shown);
    QCOMPARE(shot(viewport).pixelColor(60, 130), QColor(Qt::white));
}

void TestErrorMap::aLegendStandsBesideTheMapAlone() {
    Viewport viewport;
    ShownImage shown = shownWithMap();
    shown.errorMap.fill(int(kNoTissueBin));
    const auto coloured = [&](const QColor& colour) {
        viewport.setImage(shown);
        const QImage image = shot(viewport);
        int count = 0;
        for (int y = 0; y < 120; ++y)
            for (int x = 0; x < 300; ++x)
                count += close(image.pixelColor(x, y), colour);
        return count;
    };
    for (const double levels : {1.0, 3.0, 10.0, 30.0, 64.0})
        QVERIFY(coloured(errorColour(levels)) >= 5);
    shown.errorMap = {};
    QCOMPARE(coloured(errorColour(10)), 0);
}

/// Whose image it is stands in the same corner; both can be read.
void TestErrorMap::theLegendLeavesThePatientLegible() {
    Viewport viewport;
    viewport.setOverlay([] { return QStringList{"DOE", "ID 7", "1960-03-29", "lung"}; });
    ShownImage shown = shownWithMap();
    shown.errorMap.fill(int(kNoTissueBin));
    viewport.setImage(shown);
    const QImage image = shot(viewport);
    const int lines = 4 * QFontMetrics(viewport.font()).lineSpacing();
    const auto isOfTheScale = [&](int x, int y) { return close(image.pixelColor(x, y), errorColour(10)); };
    int above = 0, below = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width() / 2; ++x)
            (y < lines ? above : below) += isOfTheScale(x, y);
    QCOMPARE(above, 0);
    QVERIFY(below >= 5);
}

void TestErrorMap::theMapHasAKeyAlsoWhereTheImageIsAlone() {
    MainWindow window;
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    window.viewport().setFocus();
    QSignalSpy chosen(window.menuActions().errorMap, &QAction::triggered);
    QTest::keyClick(&window.viewport(), Qt::Key_E);
    QTest::keyClick(&window, Qt::Key_F11);
    QTest::keyClick(&window.viewport(), Qt::Key_E);
    QCOMPARE(chosen.count(), 2);
    QCOMPARE(chosen[0][0].toBool(), true);
    QCOMPARE(chosen[1][0].toBool(), false);
}

}  // namespace pdr::ui

QTEST_MAIN(pdr::ui::TestErrorMap)
#include "error_colours_test.moc"
