/// Holes of a scan: what its remarks say of them, and what reaches into them.

#include <QTest>

#include <cmath>

#include "render/volume/holes.h"
#include "render/volume/reconstruction.h"
#include "render/volume/sheared.h"

using namespace pdr;

namespace {

/// Slices 2.5 mm apart in a gantry that was tilted by 20 degrees.
VolumeGeometry tilted() {
    const double tilt = glm::radians(20.0);
    VolumeGeometry geometry = VolumeGeometry::aligned({4, 4, 12}, {0.5, 0.6, 2.5}, {3, 4, -70});
    geometry.patientFromIndex[1] = 0.6 * dvec4(0, std::cos(tilt), -std::sin(tilt), 0);
    return geometry;
}

Volume withRemarks(const VolumeGeometry& geometry, const std::string& remarks) {
    return Volume(geometry, Voxels(geometry.voxelCount()), {}, remarks);
}

dvec3 at(const VolumeGeometry& geometry, dvec3 index) {
    return dvec3(geometry.patientFromIndex * dvec4(index, 1));
}

const std::vector<HoleHeights> kTwo{{5, 12.5}, {20.25, 22.75}};

}  // namespace

class HolesTest : public QObject {
    Q_OBJECT

  private slots:
    void aRemarkIsOneWordOfHeights() {
        QCOMPARE(holesRemark(kTwo), std::string("holes:5.00-12.50,20.25-22.75"));
        const auto geometry = VolumeGeometry::aligned({4, 4, 12}, {1, 1, 2.5}, {3, 4, -70});
        for (const std::string& remarks : {holesRemark(kTwo), "clipped " + holesRemark(kTwo) + " tilt"}) {
            const std::vector<Hole> holes = holesOf(withRemarks(geometry, remarks));
            const std::vector<Hole> expected{{{0, 0, 1}, -65, -57.5}, {{0, 0, 1}, -49.75, -47.25}};
            QVERIFY2(holes == expected, remarks.c_str());
        }
    }

    void otherRemarksNameNone() {
        for (const char* remarks : {"", "resampled tilt", "holes:", "holes:a-b", "holes:5.00", "holes:5.00,7.00"})
            QVERIFY2(holesOf(withRemarks(tilted(), remarks)).empty(), remarks);
    }

    /// Between the slices that were measured beside a hole, whatever their tilt, and however the rows run.
    void aHoleLiesBetweenTwoSlices() {
        VolumeGeometry mirrored = tilted();
        mirrored.patientFromIndex[0] = -mirrored.patientFromIndex[0];
        for (const VolumeGeometry& geometry : {tilted(), mirrored}) {
            const double gap = sliceDrift(geometry).gapMm;
            const std::vector<HoleHeights> heights{{3 * gap, 5 * gap}};
            const std::vector<Hole> holes = holesOf(withRemarks(geometry, holesRemark(heights)));
            const auto reaches = [&](dvec3 from, dvec3 to) {
                return reachesInto(holes, at(geometry, from), at(geometry, to));
            };
            for (const dvec3 corner : {dvec3(0), dvec3(3, 0, 0), dvec3(0, 3, 0)}) {
                for (const double k : {0.0, 2.5, 3.0, 5.0, 5.5, 11.0})
                    QVERIFY2(!reaches(corner + dvec3(0, 0, k), corner + dvec3(0, 0, k)),
                             qPrintable(QString::number(k)));
                for (const double k : {3.1, 4.0, 4.9})
                    QVERIFY2(reaches(corner + dvec3(0, 0, k), corner + dvec3(0, 0, k)), qPrintable(QString::number(k)));
            }
            QVERIFY(reaches({0, 0, 1}, {3, 3, 9}) && reaches({3, 3, 9}, {0, 0, 1}) && reaches({0, 0, 5}, {0, 0, 3}));
            QVERIFY(!reaches({0, 0, 0}, {3, 3, 3}) && !reaches({0, 3, 5}, {3, 0, 11}));
        }
    }

    /// Slices that are added in between do not move them.
    void interpolatedSlicesLeaveThemWhereTheyAre() {
        const Volume volume = withRemarks(tilted(), holesRemark(kTwo));
        const std::vector<Hole> holes = holesOf(volume);
        const Volume finer = reconstructed(volume, Reconstruction::cubic);
        QCOMPARE(finer.size().z, 23);
        QCOMPARE(holes.size(), std::size_t(2));
        QVERIFY(holesOf(finer) == holes);
    }
};

QTEST_APPLESS_MAIN(HolesTest)
#include "holes_test.moc"
