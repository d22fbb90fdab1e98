/// Statistics of regions against numpy, scipy and SimpleITK.

#include <QTest>

#include <fstream>
#include <nlohmann/json.hpp>

#include "dicom/import.h"
#include "render/measure/region_statistics.h"
#include "tests/support/dicom/shared_data.h"

using namespace pdr;
using namespace pdr::measure;
using nlohmann::json;

namespace {

/// Returns the scan of make_regions.py.
Volume formulaScan() {
    const ivec3 size(40, 36, 14);
    const dmat3 aboutZ(0.6, 0.8, 0, -0.8, 0.6, 0, 0, 0, 1),
        aboutX(1, 0, 0, 0, 12.0 / 13, 5.0 / 13, 0, -5.0 / 13, 12.0 / 13);
    const dmat3 axes = aboutX * aboutZ;
    VolumeGeometry geometry{size, dmat4(1)};
    const dvec3 spacing(0.9, 0.9, 2.5);
    for (int axis = 0; axis < 3; ++axis)
        geometry.patientFromIndex[axis] = dvec4(spacing[axis] * axes[axis], 0);
    geometry.patientFromIndex[3] = dvec4(-20, 11.5, 30.25, 1);
    Voxels voxels;
    std::vector<bool> padding;
    for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j)
            for (int i = 0; i < size.x; ++i) {
                const int hu =
                    (37 * i * i + 101 * j * k + 53 * k + 29 * i * j) % 997 / 4 + (i / 3 + j / 3) % 5 * 20 - 150;
                voxels.push_back(std::int16_t(hu));
                padding.push_back(i + j + 2 * k < 30);
            }
    return Volume(geometry, std::move(voxels), std::move(padding));
}

dvec3 vectorOf(const json& values) {
    return {values[0].get<double>(), values[1].get<double>(), values[2].get<double>()};
}

MeasuredShape shapeOf(const json& shape) {
    if (shape["kind"] == "ball")
        return Ball{vectorOf(shape["centre"]), shape["radius"]};
    if (shape["kind"] == "ellipse")
        return PlaneEllipse{vectorOf(shape["centre"]), vectorOf(shape["u"]), vectorOf(shape["v"])};
    PlanePolygon polygon{{}, vectorOf(shape["normal"])};
    for (const json& corner : shape["corners"])
        polygon.corners.push_back(vectorOf(corner));
    return polygon;
}

bool near(double found, double expected) {
    const bool is = std::abs(found - expected) <= 1e-6 * std::max(1.0, std::abs(expected));
    if (!is)
        qWarning("found %.9g, expected %.9g", found, expected);
    return is;
}

}  // namespace

class OracleRegionsTest : public QObject {
    Q_OBJECT

  private slots:
    void statisticsAreThoseOfNumpy() {
        const Volume scan = formulaScan();
        std::ifstream file(PDR_SOURCE_DIR "/tests/oracle/measure/regions.json");
        const json cases = json::parse(file);
        QVERIFY(cases.size() == 8);
        for (const json& each : cases) {
            const json& expected = each["expected"];
            const auto found = regionStatistics(scan, shapeOf(each["shape"]));
            QVERIFY(found);
            QCOMPARE(found->count, expected["count"].get<std::size_t>());
            QCOMPARE(found->padding, expected["padding"].get<std::size_t>());
            QVERIFY(near(found->meanHu, expected["mean"]) && near(found->sdHu, expected["sd"]));
            QVERIFY(near(found->medianHu, expected["median"]) && near(found->millilitres, expected["ml"]));
            QVERIFY(near(found->lowestHu, expected["lowest"]) && near(found->highestHu, expected["highest"]));
            QVERIFY(near(found->percentile5, expected["percentile5"]));
            QVERIFY(near(found->percentile95, expected["percentile95"]));
            QCOMPARE(found->meanPlusMinus.has_value(), !expected["plus_minus"].is_null());
            QVERIFY(!found->meanPlusMinus || near(*found->meanPlusMinus, expected["plus_minus"]));
        }
    }

    /// SimpleITK's LabelStatisticsImageFilter over the voxels whose centres lie in the ball.
    void aChestHasTheNumbersOfSimpleItk() {
        PDR_NEEDS_SHARED_CT();
        const auto scan = dicom::scanFolder(test::sharedCt() / "chest_contrast", noProgress);
        QVERIFY(scan && scan->series.size() == 1);
        const auto volume = dicom::loadSeries(scan->series[0], dicom::Padding::maskAsAir, noProgress);
        QVERIFY(volume);
        const dvec3 centre(-13.175, -58.281, -49);
        const auto wide = regionStatistics(*volume, Ball{centre, 8});
        QVERIFY(wide && wide->count == 1031 && wide->lowestHu == -312 && wide->highestHu == 1038);
        QVERIFY(near(wide->meanHu, 54.962173) && near(wide->sdHu, 168.923150) && wide->medianHu == 27);
        const auto narrow = regionStatistics(*volume, Ball{centre, 4});
        QVERIFY(narrow && narrow->count == 135 && narrow->lowestHu == -101 && narrow->highestHu == 557);
        QVERIFY(near(narrow->meanHu, 115.148148) && near(narrow->sdHu, 119.545752) && narrow->medianHu == 96);
    }
};

QTEST_APPLESS_MAIN(OracleRegionsTest)
#include "oracle_regions_test.moc"
