#include <QTest>

#include <algorithm>
#include <cmath>

#include "render/volume/phantom.h"

using namespace pdr;

namespace {

constexpr ivec3 kSmall{64, 72, 64};
constexpr dvec3 kSmallMm{4, 4, 4};

/// Returns the HU at a place of the patient [mm], nearest voxel.
int huAt(const Volume& volume, dvec3 mm) {
    const VolumeGeometry& geometry = volume.geometry();
    const dvec3 index = glm::round(dvec3(glm::inverse(geometry.patientFromIndex) * dvec4(mm, 1.0)));
    const std::size_t row = std::size_t(index.z) * std::size_t(geometry.size.y) + std::size_t(index.y);
    return volume.voxels()[row * std::size_t(geometry.size.x) + std::size_t(index.x)];
}

/// Returns the highest HU on the straight way from `from` to `to`.
int highestBetween(const Volume& volume, dvec3 from, dvec3 to) {
    int highest = -1024;
    for (int step = 0; step <= 200; ++step)
        highest = std::max(highest, huAt(volume, from + (to - from) * (step / 200.0)));
    return highest;
}

}  // namespace

class PhantomTest : public QObject {
    Q_OBJECT

  private slots:
    void gridIsAsAskedAndCentred() {
        const Volume head = headPhantom(kSmall, kSmallMm);
        QVERIFY(head.size() == kSmall);
        QVERIFY(glm::distance(head.geometry().spacingMm(), kSmallMm) < 1e-12);
        QVERIFY(glm::length(head.geometry().centreMm()) < 1e-9);
    }

    void tissuesLieWhereAHeadHasThem() {
        const Volume head = headPhantom({250, 250, 250}, {1, 1, 1});
        QVERIFY(huAt(head, {0, -124, 100}) < -960);                     // air before the face
        QVERIFY(std::abs(huAt(head, {40, 0, 60}) - 36) < 40);           // brain
        QVERIFY(std::abs(huAt(head, {13, 2, 38}) - 8) < 40);            // ventricle
        QVERIFY(highestBetween(head, {0, 8, 60}, {0, 8, 124}) > 1200);  // skull cap
        QVERIFY(huAt(head, {28, -58, -42}) < -900);                     // maxillary sinus
        QVERIFY(std::abs(huAt(head, {31, -56, -4})) < 60);              // eye
    }

    void defectIsOnThePatientsRightOnly() {
        const Volume head = headPhantom({250, 250, 250}, {1, 1, 1});
        const dvec3 centre(0, 8, 28), way = 100.0 * glm::normalize(dvec3(-0.62, -0.5, 0.6));
        QVERIFY(highestBetween(head, centre + 0.4 * way, centre + way) < 150);
        QVERIFY(highestBetween(head, centre + 0.4 * dvec3(-way.x, way.y, way.z), centre + dvec3(-way.x, way.y, way.z)) >
                1000);
    }

    void sameSeedSameHeadOtherSeedOtherNoise() {
        const Volume a = headPhantom(kSmall, kSmallMm, 5), b = headPhantom(kSmall, kSmallMm, 5);
        const Volume c = headPhantom(kSmall, kSmallMm, 6);
        QVERIFY(std::equal(a.voxels().begin(), a.voxels().end(), b.voxels().begin()));
        QVERIFY(!std::equal(a.voxels().begin(), a.voxels().end(), c.voxels().begin()));
    }

    void noiseHasSixHounsfieldUnits() {
        const Volume head = headPhantom(kSmall, kSmallMm);
        double sum = 0, squares = 0;
        const int count = kSmall.x * kSmall.y;  // the uppermost slice is air throughout
        for (int i = 0; i < count; ++i) {
            const double hu = head.voxels()[head.voxels().size() - 1 - std::size_t(i)];
            sum += hu;
            squares += hu * hu;
        }
        const double mean = sum / count;
        QVERIFY(std::abs(mean + 1000) < 0.5);
        QVERIFY(std::abs(std::sqrt(squares / count - mean * mean) - 6) < 0.5);
    }
};

QTEST_APPLESS_MAIN(PhantomTest)
#include "phantom_test.moc"
