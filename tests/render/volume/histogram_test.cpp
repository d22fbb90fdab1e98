/// Counts of Hounsfield units: every measured voxel once, padding never, for any volume and any number of threads.

#include <tbb/task_arena.h>

#include <QTest>
#include <algorithm>

#include "render/volume/histogram.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

class HistogramTest : public QObject {
    Q_OBJECT

  private slots:
    void everyVoxelCountsOnce() {
        const auto volume = test::bumpyVolume({70, 60, 50}, dvec3(1), 3);
        const Histogram histogram(*volume);
        QCOMPARE(histogram.total(), 70.0 * 60 * 50);
        double sum = 0;
        for (int hu = -1100; hu <= 2100; ++hu) {
            const double here = histogram.count(hu - 0.5, hu + 0.5);
            const auto voxels = volume->voxels();
            if (hu % 97 == 0)
                QCOMPARE(here, double(std::count(voxels.begin(), voxels.end(), hu)));
            sum += here;
        }
        QCOMPARE(sum, histogram.total());
        QCOMPARE(histogram.count(-1e9, 1e9), histogram.total());
        QCOMPARE(histogram.count(100, 50), 0.0);
    }

    void theEndsOfTheScaleCount() {
        const auto volume = test::makeVolume({2, 1, 1}, dvec3(1), [](int i, int, int) { return i ? 32767 : -32768; });
        const Histogram histogram(*volume);
        QCOMPARE(histogram.count(-32768.5, -32767.5), 1.0);
        QCOMPARE(histogram.count(32766.5, 32767.5), 1.0);
        QCOMPARE(histogram.total(), 2.0);
    }

    void paddingIsLeftOut() {
        Voxels voxels(1000, 40);
        std::vector<bool> padding(1000);
        for (std::size_t i = 0; i < 300; ++i) {
            voxels[i] = Volume::kAirHu;
            padding[i] = true;
        }
        const Volume volume(VolumeGeometry::aligned({10, 10, 10}, dvec3(1), dvec3(0)), voxels, padding);
        const Histogram histogram(volume);
        QCOMPARE(histogram.total(), 700.0);
        QCOMPARE(histogram.count(-2000, 0), 0.0);
        const Volume nothing(volume.geometry(), voxels, std::vector<bool>(1000, true));
        QCOMPARE(Histogram(nothing).total(), 0.0);
        QCOMPARE(Histogram(nothing).percentile(0.5), 0.0);
        QCOMPARE(Histogram(nothing).count(-1e9, 1e9), 0.0);
    }

    /// The given fraction of the voxels lies below a percentile.
    void aPercentileIsTheInverseOfACount() {
        const Histogram histogram(*test::bumpyVolume({64, 64, 64}, dvec3(1), 5));
        for (const double fraction : {0.001, 0.1, 0.5, 0.77, 0.999, 1.0}) {
            const double hu = histogram.percentile(fraction);
            QVERIFY(std::abs(histogram.count(-1e9, hu) / histogram.total() - fraction) < 1e-12);
        }
        QVERIFY(histogram.count(-1e9, histogram.percentile(0)) == 0);
        QCOMPARE(histogram.percentile(-1), histogram.percentile(0));
        QCOMPARE(histogram.percentile(2), histogram.percentile(1));
    }

    /// Percentiles also lie between two peaks, where no voxel lies.
    void percentilesStepOverGaps() {
        const auto volume =
            test::makeVolume({10, 10, 1}, dvec3(1), [](int i, int, int) { return i < 3 ? -900 : 1200; });
        const Histogram histogram(*volume);
        QVERIFY(std::abs(histogram.percentile(0.3) - -899.5) < 1e-9);
        QVERIFY(histogram.percentile(0.301) > 1199);
    }

    void threadsChangeNothing() {
        const auto volume = test::bumpyVolume({256, 128, 100}, dvec3(1), 7);
        std::vector<double> first;
        for (const int threads : {1, 2, 5}) {
            Histogram histogram;
            tbb::task_arena(threads).execute([&] { histogram = Histogram(*volume); });
            std::vector<double> counts;
            for (int hu = -1010; hu < 2010; ++hu)
                counts.push_back(histogram.count(hu - 0.5, hu + 0.5));
            first = first.empty() ? counts : first;
            QVERIFY(counts == first);
        }
    }
};

QTEST_GUILESS_MAIN(HistogramTest)
#include "histogram_test.moc"
