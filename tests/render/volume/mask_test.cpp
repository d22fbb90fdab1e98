#include "render/volume/mask.h"

#include <QTest>

#include "tests/support/scenes/masks.h"
#include "tests/support/scenes/scenes.h"

using namespace pdr;

class MaskTest : public QObject {
    Q_OBJECT

  private slots:
    void nodesLieNoFartherApartThanAsked() {
        const MaskGrid grid = MaskGrid::over(VolumeGeometry::aligned({512, 511, 100}, {0.78, 0.39, 5}, dvec3(0)), 1.6);
        QCOMPARE(grid.shift, ivec3(1, 2, 0));
        QCOMPARE(grid.size(), ivec3(257, 129, 100));
        QCOMPARE(MaskGrid::over(VolumeGeometry::aligned({1, 1, 1}, dvec3(1), dvec3(0))).size(), ivec3(1));
        // The last node lies on or beyond the last voxel, and no whole step beyond.
        for (int voxels = 1; voxels < 40; ++voxels)
            for (int shift = 0; shift < 4; ++shift) {
                const int last = MaskGrid{ivec3(voxels), ivec3(shift)}.size().x - 1;
                QVERIFY((last << shift) >= voxels - 1 && (last << shift) < voxels - 1 + (1 << shift));
            }
    }

    void edgesRiseEvenlyOverTheirWidth() {
        QCOMPARE(int(edgeWeight(0, 2)), kSeen / 2);
        QCOMPARE(int(edgeWeight(0.5, 2)), kSeen * 3 / 4);
        QCOMPARE(int(edgeWeight(1, 2)), kSeen);
        QCOMPARE(int(edgeWeight(-1, 2)), 0);
        QCOMPARE(int(edgeWeight(-99, 2)), 0);
    }

    void weightsAreTrilinearBetweenNodes() {
        const auto mask = maskOf({ivec3(9), ivec3(2)}, "",
                                 [](dvec3 place) { return std::int16_t(100 * place.x + 10 * place.y + place.z); });
        QVERIFY(std::fabs(mask->at({3.5, 1.25, 7}) * kSeen - (350 + 12.5 + 7)) < 1e-9);
        QVERIFY(std::fabs(mask->at({-4, 20, 8}) * kSeen - (0 + 80 + 8)) < 1e-9);
    }

    /// The combined mask is the product, on the finer grid; null shows everything.
    void combinedMasksShowWhatBothShow() {
        const auto volume = test::bumpyVolume({20, 16, 18}, dvec3(1), 1);
        const auto a = test::anyMask(*volume, 2), b = test::anyMask(*volume, 5);
        const auto both = combined(a, b);
        QCOMPARE(both->grid().shift, glm::min(a->grid().shift, b->grid().shift));
        for (int i = 0; i < 20; ++i) {
            const dvec3 place = both->grid().place(both->grid().size() * i / 20);
            QVERIFY(std::fabs(both->at(place) - a->at(place) * b->at(place)) <= 0.5 / kSeen + 1e-12);
        }
        QCOMPARE(combined(a, nullptr), a);
        QCOMPARE(combined(nullptr, b), b);
        QVERIFY(combined(nullptr, nullptr) == nullptr);
    }

    void whatBothHideIsSaid() {
        const MaskGrid grid{ivec3(2), ivec3(0)};
        const auto weight = [](dvec3) { return std::int16_t(kSeen); };
        const auto a = maskOf(grid, "Peeled 7 mm.", weight), b = maskOf(grid, "", weight),
                   c = maskOf(grid, "Cut.", weight);
        QCOMPARE(combined(a, c)->hidden(), std::string("Peeled 7 mm. Cut."));
        QCOMPARE(combined(b, c)->hidden(), std::string("Cut."));
    }
};

QTEST_GUILESS_MAIN(MaskTest)
#include "mask_test.moc"
