/// Volumes with the slices of a tilted gantry: gap, drift, volume and size against what is known of the scanner.

#include <QTest>

#include <cmath>

#include "render/volume/sheared.h"

using namespace pdr;

namespace {

/// Slices of 0.5 x 0.6 mm pixels of a gantry that was tilted by `degrees`, 2.5 mm of table apart, turned at will.
VolumeGeometry tilted(double degrees, const dmat3& turn = dmat3(1)) {
    const double tilt = glm::radians(degrees);
    VolumeGeometry geometry = VolumeGeometry::aligned({200, 180, 40}, {0.5, 0.6, 2.5}, {3, 4, 5});
    geometry.patientFromIndex[1] = 0.6 * dvec4(0, std::cos(tilt), -std::sin(tilt), 0);
    for (int axis = 0; axis < 3; ++axis)
        geometry.patientFromIndex[axis] = dvec4(turn * dvec3(geometry.patientFromIndex[axis]), 0);
    return geometry;
}

/// A turn about an axis of no special direction, and one that mirrors.
const dmat3 kTurn = dmat3(dvec3(13, 34, -14), dvec3(-26, 19, 22), dvec3(26, 2, 29)) / 39.0;
const dmat3 kMirror(dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1));

bool near(double a, double b) {
    return std::abs(a - b) < 1e-9;
}

}  // namespace

class ShearedTest : public QObject {
    Q_OBJECT

  private slots:
    void theGapIsAcrossTheSlicesAndTheDriftAlongThem() {
        for (const dmat3& turn : {dmat3(1), kTurn, kMirror})
            for (const double degrees : {18.5, -30.0}) {
                const VolumeGeometry geometry = tilted(degrees, turn);
                const SliceDrift drift = sliceDrift(geometry);
                const double tilt = glm::radians(degrees);
                QVERIFY(!drift.isUpright());
                QVERIFY(near(drift.gapMm, 2.5 * std::cos(tilt)));
                QVERIFY(near(drift.sidewaysMm.x, 0) && near(drift.sidewaysMm.y, -2.5 * std::sin(tilt)));
                QVERIFY(near(drift.degrees(), std::abs(degrees)));
                QVERIFY(near(geometry.spacingMm().z, 2.5) && near(statedSpacingMm(geometry).z, 2.5 * std::cos(tilt)));
            }
    }

    void anUprightVolumeHasNoneHoweverItIsTurned() {
        const VolumeGeometry turned = tilted(0, kTurn);
        QVERIFY(sliceDrift(turned).isUpright());
        QVERIFY(statedSpacingMm(turned) == turned.spacingMm());
        QCOMPARE(sliceDrift(turned).degrees(), 0.0);
    }

    void aVoxelHoldsItsBaseTimesTheGap() {
        for (const dmat3& turn : {dmat3(1), kTurn, kMirror})
            QVERIFY(near(voxelMl(tilted(25, turn)), 0.5 * 0.6 * 2.5 * std::cos(glm::radians(25.0)) / 1000));
    }

    /// Whatever is in the volume lies within its radius, also in the corners that the tilt moves away.
    void theRadiusHoldsAllCorners() {
        for (const double degrees : {-35.0, -10.0, 0.0, 10.0, 35.0}) {
            const VolumeGeometry geometry = tilted(degrees, kTurn);
            double farthest = 0;
            for (int corner = 0; corner < 8; ++corner) {
                const dvec3 end(corner & 1, corner >> 1 & 1, corner >> 2);
                const dvec3 mm(geometry.patientFromIndex * dvec4(end * dvec3(geometry.size) - 0.5, 1));
                farthest = std::max(farthest, glm::distance(mm, geometry.centreMm()));
            }
            QVERIFY(near(geometry.radiusMm(), farthest));
        }
    }
};

QTEST_APPLESS_MAIN(ShearedTest)
#include "sheared_test.moc"
