/// Scans with fewer voxels.

#include <QTest>

#include "render/volume/coarser.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

class CoarserTest : public QObject {
    Q_OBJECT

  private slots:
    void blocksAreTheMeansOfTheirVoxels() {
        const auto fine = test::makeVolume({5, 4, 6}, {1, 1, 2}, [](int i, int j, int k) { return 10 * i + j - k; });
        const Volume coarse = coarser(*fine, 2);
        QVERIFY(coarse.size() == ivec3(2, 2, 6));  // the fifth column is left out
        QCOMPARE(int(coarse.voxels()[0]), (0 + 10 + 1 + 11) / 4);
        QCOMPARE(int(coarse.voxels()[1]), (20 + 30 + 21 + 31) / 4);
    }

    void blocksLieWhereTheirVoxelsDo() {
        const auto fine = test::makeVolume({8, 8, 8}, {1, 0.5, 3}, [](int, int, int) { return 0; });
        const Volume coarse = coarser(*fine, 2);
        QVERIFY(coarse.size() == ivec3(4, 2, 8));
        QVERIFY(coarse.geometry().spacingMm() == dvec3(2, 2, 3));
        QVERIFY(glm::distance(coarse.geometry().centreMm(), fine->geometry().centreMm()) < 1e-12);
    }

    void aCoarseScanStaysAsItIs() {
        const auto fine = test::bumpyVolume({7, 5, 3}, dvec3(4), 1);
        const Volume same = coarser(*fine, 2);
        QVERIFY(std::ranges::equal(same.voxels(), fine->voxels()));
        QVERIFY(coarser(*test::makeVolume({1, 1, 1}, dvec3(1), [](int, int, int) { return 5; }), 100).size() ==
                ivec3(1));
    }
};

QTEST_APPLESS_MAIN(CoarserTest)
#include "coarser_test.moc"
