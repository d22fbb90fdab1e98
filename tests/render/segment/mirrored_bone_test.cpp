#include <QTest>

#include <cmath>
#include <numbers>

#include "render/segment/bone_cells.h"
#include "render/segment/mirrored_bone.h"
#include "render/segment/symmetry.h"
#include "tests/support/scenes/skull_phantom.h"

using namespace pdr;
using namespace pdr::segment;

namespace {

/// What a search found, against the truth by formula.
struct Judged {
    double sensitivity = 0;  ///< share of the bone that the hole lacks
    double falseShare = 0;   ///< found elsewhere, as a share of that bone
};

Judged judged(const LabelMap& found, const Volume& whole, const Volume& holed) {
    double lacking = 0, hits = 0, elsewhere = 0;
    for (std::size_t i = 0; i < found.labels.size(); ++i) {
        const bool isLacking = whole.voxels()[i] >= 250 && holed.voxels()[i] < 250;
        lacking += isLacking;
        hits += isLacking && found.labels[i] == 1;
        elsewhere += !isLacking && found.labels[i] == 1;
    }
    return {hits / lacking, elsewhere / lacking};
}

double angleOf(const SymmetryPlane& plane, const dvec3& normal) {
    return std::acos(std::min(glm::dot(plane.normal, normal), 1.0)) * 180 / std::numbers::pi;
}

}  // namespace

/// The healthy side of a skull closes a hole in the other one. The skulls are made by formula.
class MirroredBoneTest : public QObject {
    Q_OBJECT

  private slots:
    /// A head that lies 5 degrees askew and 7 mm aside, with and without a hole of 50 mm.
    void thePlaneIsFound() {
        for (const double hole : {25.0, 0.0}) {
            const test::SkullPhantom skull{.holeMm = hole};
            const Volume scan = test::scanOf(skull);
            const CellGrid grid = CellGrid::over(scan.geometry());
            const SymmetryPlane plane = symmetryOf(boneCells(scan, grid), grid, scan.geometry());
            const QString said = QString("%1 degrees, %2 mm, misfit %3 and %4 mm")
                                     .arg(angleOf(plane, skull.normal()))
                                     .arg(plane.atMm - glm::dot(plane.normal, skull.middleMm))
                                     .arg(plane.medianMm)
                                     .arg(plane.mostMm);
            qInfo("%s", qPrintable(said));
            QVERIFY2(angleOf(plane, skull.normal()) < 0.5, qPrintable(said));
            QVERIFY2(std::abs(plane.atMm - glm::dot(plane.normal, skull.middleMm)) < 0.5, qPrintable(said));
            QVERIFY2(plane.medianMm < 0.6 && plane.mostMm < (hole > 0 ? 8 : 1.5), qPrintable(said));
        }
    }

    void theHoleIsClosed() {
        for (const double side : {-1.0, 1.0}) {
            test::SkullPhantom skull{.holeMm = 25, .holeSide = side};
            const Volume holed = test::scanOf(skull);
            skull.holeMm = 0;
            const auto found = findMirroredBone(holed, noProgress);
            QVERIFY2(bool(found), found ? "" : found.error().text().c_str());
            QVERIFY(found->parts[0].name == "mirrored bone" && found->notes.size() == 1);
            const Judged is = judged(*found, test::scanOf(skull), holed);
            const QString said = QString("found %1, elsewhere %2").arg(is.sensitivity).arg(is.falseShare);
            qInfo("%s", qPrintable(said));
            QVERIFY2(is.sensitivity > 0.95 && is.falseShare < 0.08, qPrintable(said));
        }
    }

    void aWholeSkullLacksNothing() {
        const auto found = findMirroredBone(test::scanOf(test::SkullPhantom{}), noProgress);
        QVERIFY(!found && found.error().kind == ErrorKind::refused);
        QVERIFY2(found.error().what.find("lacking on the other") != std::string::npos, found.error().text().c_str());
    }

    /// A plane of symmetry that does not fit must close nothing.
    void halfASkullIsRefused() {
        const auto found = findMirroredBone(test::scanOf(test::SkullPhantom{.isHalf = true}), noProgress);
        QVERIFY(!found && found.error().kind == ErrorKind::refused);
        QVERIFY2(found.error().what.find("not symmetric") != std::string::npos, found.error().text().c_str());
    }

    void aScanWithoutBonesIsRefused() {
        const auto found = findMirroredBone(test::scanOf(test::SkullPhantom{.boneHu = 60}), noProgress);
        QVERIFY(!found && found.error().kind == ErrorKind::refused);
        QVERIFY2(found.error().what.find("no bones") != std::string::npos, found.error().text().c_str());
    }

    void theSearchIsCancelled() {
        const Volume scan = test::scanOf(test::SkullPhantom{.holeMm = 25});
        for (const double at : {0.0, 0.5, 0.85}) {
            const auto found = findMirroredBone(scan, [at](double done, std::string_view) { return done < at; });
            QVERIFY(!found);
            QCOMPARE(found.error().kind, ErrorKind::cancelled);
        }
    }
};

QTEST_APPLESS_MAIN(MirroredBoneTest)
#include "mirrored_bone_test.moc"
