/// The noise that is estimated from a scan is that which was put into it.

#include <QTest>
#include <random>

#include "render/smooth/noise_level.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

class NoiseLevelTest : public QObject {
    Q_OBJECT

    /// Returns a body of soft tissue with a rib in it, in air, with noise of `sd` HU in the tissue alone.
    static std::shared_ptr<const Volume> body(double sd, int shift = 0) {
        std::mt19937 random(7);
        std::normal_distribution<double> noise(0, 1);
        return test::makeVolume({96, 96, 12}, dvec3(1), [&](int i, int j, int) {
            const double r = std::hypot(i - 48, j - 48);
            return shift + std::lround(r > 40 ? -1000 : (r > 36 && r < 38 ? 900 : 40) + sd * noise(random));
        });
    }

  private slots:
    void noiseOfTissueIsFound() {
        for (const double sd : {5.0, 20.0, 50.0}) {
            const double found = noiseOf(*body(sd));
            QVERIFY2(found > 0.8 * sd && found < 1.05 * sd, qPrintable(QString("%1: %2").arg(sd).arg(found)));
        }
    }

    void theZeroOfTheValuesDoesNotMatter() { QCOMPARE(noiseOf(*body(30, 3000)), noiseOf(*body(30))); }

    /// Noise is louder behind shoulders and ribs; the estimate stays with what is common.
    void edgesDoNotCountAsNoise() {
        const auto checked = test::makeVolume({64, 64, 4}, dvec3(1), [](int i, int j, int k) {
            return (i / 16 + j / 16) % 2 * 400 + (i * 7 + j * 13 + k * 5) % 5;
        });
        QVERIFY(noiseOf(*checked) < 3);
    }

    void paddingIsLeftOut() {
        const auto whole = body(20);
        std::vector<bool> padding(whole->voxels().size());
        Voxels voxels(whole->voxels().begin(), whole->voxels().end());
        for (std::size_t i = 0; i < voxels.size(); ++i)
            if (i % 96 < 48) {
                padding[i] = true;
                voxels[i] = std::int16_t(i % 7 * 100 + 1000);
            }
        const double found = noiseOf(Volume(whole->geometry(), std::move(voxels), std::move(padding)));
        QVERIFY2(found > 16 && found < 21, qPrintable(QString::number(found)));
    }

    void aScanWithoutNoiseHasNone() {
        QCOMPARE(noiseOf(*test::makeVolume({20, 20, 3}, dvec3(1), [](int, int, int) { return 7; })), 0.0);
        QCOMPARE(noiseOf(*test::makeVolume({1, 900, 3}, dvec3(1), [](int, int j, int) { return j; })), 0.0);
    }
};

QTEST_APPLESS_MAIN(NoiseLevelTest)
#include "noise_level_test.moc"
