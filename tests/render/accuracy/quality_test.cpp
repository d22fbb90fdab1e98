/// The word for the quality of an image.

#include <QTest>

#include "render/accuracy/quality.h"

using namespace pdr;

class QualityTest : public QObject {
    Q_OBJECT

  private slots:
    void theWordFollowsFromTheLevels() {
        const auto wordOf = [](double levels) { return qualityOf({.samplesPerPixel = 64, .displayError = levels}); };
        QCOMPARE(qualityOf({}), Quality::estimating);
        QCOMPARE(wordOf(255), Quality::rough);
        QCOMPARE(wordOf(16.01), Quality::rough);
        QCOMPARE(wordOf(16), Quality::orientation);
        QCOMPARE(wordOf(8.01), Quality::orientation);
        QCOMPARE(wordOf(8), Quality::planning);
        QCOMPARE(wordOf(1.01), Quality::planning);
        QCOMPARE(wordOf(1), Quality::reference);
        QCOMPARE(wordOf(0), Quality::reference);
    }
    /// The stated error of such an image may be far too small.
    void whatRestsOnFewBrightSamplesIsRough() {
        QCOMPARE(qualityOf({.samplesPerPixel = 64, .displayError = 1, .fewBrightSamples = true}), Quality::rough);
        QCOMPARE(qualityOf({.samplesPerPixel = 16, .fewBrightSamples = true}), Quality::estimating);
    }
};

QTEST_GUILESS_MAIN(QualityTest)
#include "quality_test.moc"
