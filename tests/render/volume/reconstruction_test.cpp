/// Interpolated slices: what stays, what they are exact for, and that steps become lower.

#include "render/volume/reconstruction.h"

#include <QTest>

#include "render/kernel/volume_sampling.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

namespace {

Volume cubic(const std::shared_ptr<const Volume>& volume) {
    return reconstructed(Volume(*volume), Reconstruction::cubic);
}

int huAt(const Volume& volume, int i, int j, int k) {
    const ivec3 size = volume.size();
    return volume.voxels()[(std::size_t(k) * size.y + j) * size.x + i];
}

/// Returns how far the border, where the HU pass 500, lies from a wall that rises by `rise` mm per millimetre [mm rms].
/// Slices are 2 mm thick, pixels 1 mm wide; a voxel holds the fraction of it that is filled.
double borderError(double rise, Reconstruction reconstruction) {
    const auto wall = test::makeVolume({64, 3, 40}, {1, 1, 2}, [&](int i, int, int k) {
        int filled = 0;
        for (int n = 0; n < 400; ++n)  // an even number along each edge: no sample meets a flat wall
            filled += 2 * (k + (n / 20 - 9.5) / 20 - 12) < rise * (i + (n % 20 - 9.5) / 20 - 20) ? 1 : 0;
        return filled * 5 / 2;
    });
    const auto prepared = test::prepared(
        test::plainScene(std::make_shared<const Volume>(reconstructed(Volume(*wall), reconstruction)), 1));
    const FlatVolume& volume = prepared->flat.volume;
    const double slice = reconstruction == Reconstruction::cubic ? 1 : 2;
    double sum = 0;
    int count = 0;
    for (double x = 20; x < 20 + 12 / rise && x < 60; x += 0.13) {
        const double truth = 24 + rise * (x - 20);
        double low = truth - 3, high = truth + 3;
        while (high - low > 1e-4) {
            const double middle = (low + high) / 2;
            (interpolatedHounsfield(volume, vec3(x, 1, middle / slice)) > 500 ? low : high) = middle;
        }
        sum += (low - truth) * (low - truth);
        ++count;
    }
    return std::sqrt(sum / count);
}

}  // namespace

class ReconstructionTest : public QObject {
    Q_OBJECT

  private slots:
    void theScansSlicesStayWhereAndWhatTheyAre() {
        const auto scan = test::bumpyVolume({7, 5, 6}, {0.8, 0.9, 3}, 4);
        const Volume finer = cubic(scan);
        QVERIFY(finer.size() == ivec3(7, 5, 11));
        for (int k = 0; k < 6; ++k) {
            QVERIFY(glm::distance(finer.geometry().patientFromIndex * dvec4(1, 2, 2 * k, 1),
                                  scan->geometry().patientFromIndex * dvec4(1, 2, k, 1)) < 1e-12);
            for (int n = 0; n < 35; ++n)
                QCOMPARE(huAt(finer, n % 7, n / 7, 2 * k), huAt(*scan, n % 7, n / 7, k));
        }
        QVERIFY(finer.storedRange().lowest == scan->storedRange().lowest);
        QVERIFY(finer.storedRange().highest == scan->storedRange().highest);
    }

    /// Cubics are exact except in the outermost gaps, where a slice is missing.
    void cubicsAreExactBetweenTheSlices() {
        const auto hu = [](int j, int half) { return 10 * half * half * half - 90 * half * half + 7 * j * half - 300; };
        const Volume finer =
            cubic(test::makeVolume({2, 6, 6}, dvec3(1), [&](int, int j, int k) { return hu(j, 2 * k); }));
        for (int j = 0; j < 6; ++j)
            for (int half = 2; half < 9; ++half)
                QCOMPARE(huAt(finer, 1, j, half), hu(j, half));
    }

    /// A cubic overshoots beside a step; no voxel leaves the scan's range, so that what is off stays off.
    void noVoxelLeavesTheRangeOfTheScan() {
        const Volume finer =
            cubic(test::makeVolume({2, 2, 8}, dvec3(1), [](int, int, int k) { return k < 4 ? -1024 : 3071; }));
        for (int k = 0; k < 15; ++k)
            QCOMPARE(huAt(finer, 0, 0, k), k < 7 ? -1024 : k == 7 ? 1024 : 3071);
    }

    void paddingAndRemarksAreKept() {
        Voxels voxels(2 * 1 * 3, 0);
        Volume scan(VolumeGeometry::aligned({2, 1, 3}, dvec3(1), dvec3(0)), voxels,
                    {true, false, false, false, false, false}, "lossy");
        const Volume finer = reconstructed(std::move(scan), Reconstruction::cubic);
        QCOMPARE(finer.paddingCount(), std::size_t(2));
        QVERIFY(finer.isPadding(0) && finer.isPadding(2) && !finer.isPadding(1) && !finer.isPadding(4));
        QCOMPARE(finer.remarks(), std::string("lossy, slices interpolated"));
    }

    void linearAndSingleSlicesAreTheScanItself() {
        for (const auto& [size, reconstruction] :
             {std::pair(ivec3(4, 4, 4), Reconstruction::linear), std::pair(ivec3(4, 4, 1), Reconstruction::cubic)}) {
            Volume scan(*test::bumpyVolume(size, dvec3(1), 2));
            const std::int16_t* before = scan.voxels().data();
            const Volume same = reconstructed(std::move(scan), reconstruction);
            QVERIFY(same.voxels().data() == before && same.size() == size && same.remarks().empty());
        }
    }

    /// The border of a sloping wall lies closer to the wall.
    void stepsOfSlopesAreLower() {
        for (const double rise : {0.15, 0.3, 0.5}) {
            const double linear = borderError(rise, Reconstruction::linear),
                         better = borderError(rise, Reconstruction::cubic);
            const QString both = QString("rise %1: %2 mm rms, linear %3").arg(rise).arg(better).arg(linear);
            qInfo("%s", qPrintable(both));
            QVERIFY2(better < 0.9 * linear, qPrintable(both));
        }
    }
};

QTEST_APPLESS_MAIN(ReconstructionTest)
#include "reconstruction_test.moc"
