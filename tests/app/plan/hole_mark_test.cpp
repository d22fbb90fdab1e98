/// What is measured across a hole of the scan says so wherever it is read.

#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include "app/plan/hole_mark.h"
#include "app/plan/marks_csv.h"
#include "app/plan/marks_slicer.h"
#include "app/plan/marks_table.h"
#include "render/measure/profile.h"
#include "tests/support/some_marks.h"

namespace pdr::app {
namespace {

constexpr const char* kMark = ", interpolated across a hole";

/// Slices every 2.5 mm from -20 mm on, which were measured at all heights but -7.5 and -5 mm.
Volume scan() {
    const auto grid = VolumeGeometry::aligned({40, 40, 16}, {1, 1, 2.5}, {0, 0, -20});
    Voxels voxels(grid.voxelCount());
    for (std::size_t n = 0; n < voxels.size(); ++n)
        voxels[n] = std::int16_t(n % 97);
    return {grid, std::move(voxels), {}, "resampled " + holesRemark(std::vector<HoleHeights>{{10, 17.5}})};
}
const Volume kScan = scan();

std::vector<measure::Place> typed(const std::vector<dvec3>& places) {
    std::vector<measure::Place> all;
    for (const dvec3 mm : places)
        all.push_back(measure::typedPlace(mm));
    return all;
}

Measured valueOf(MeasureKind kind, const std::vector<dvec3>& places) {
    return *measured({1, kind, "", typed(places)}, kScan);
}

struct Case {
    const char* what;
    MeasureKind kind;
    std::vector<dvec3> places;
    bool marked;
};

/// z from -10 to -2.5 is the hole.
const std::vector<Case> kCases{
    {"a distance above it", MeasureKind::distance, {{5, 5, -2.5}, {30, 5, 12}}, false},
    {"one across it", MeasureKind::distance, {{5, 5, -15}, {30, 5, 12}}, true},
    {"one between the slices beside it", MeasureKind::distance, {{5, 5, -10}, {5, 5, -2.5}}, true},
    {"one in the slice below it", MeasureKind::distance, {{5, 5, -10}, {30, 20, -10}}, false},
    {"an angle below it", MeasureKind::angle, {{5, 5, -20}, {30, 5, -10}, {30, 30, -12}}, false},
    {"one with its second arm in it", MeasureKind::angle, {{5, 5, -20}, {30, 5, -12}, {30, 30, -9}}, true},
    {"lines on either side", MeasureKind::lines, {{5, 5, 0}, {30, 5, 5}, {5, 5, -15}, {30, 9, -12}}, false},
    {"lines of which the second crosses it",
     MeasureKind::lines,
     {{5, 5, 0}, {30, 5, 5}, {5, 5, -15}, {30, 9, 0}},
     true},
    {"a place on the slice above it", MeasureKind::point, {{5, 5, -2.5}}, false},
    {"one in it", MeasureKind::point, {{5, 5, -3.5}}, true},
    {"a ball that holds no voxel of it", MeasureKind::ball, {{20, 20, 1}, {25.9, 20, 1}}, false},
    {"one that does", MeasureKind::ball, {{20, 20, 1}, {26.1, 20, 1}}, true},
    {"an ellipse beside it", MeasureKind::ellipse, {{20, 20, -10}, {29, 20, -10}, {20, 28, -10}}, false},
    {"one across slices", MeasureKind::ellipse, {{20, 20, 5}, {29, 20, 5}, {20, 20, 15}}, true},
    {"a polygon beside it", MeasureKind::polygon, {{5, 5, -2.5}, {30, 5, -2.5}, {30, 30, -2.5}}, false},
    {"one in it", MeasureKind::polygon, {{5, 5, -5}, {30, 5, -5}, {30, 30, -5}}, true},
    {"one across slices and the hole", MeasureKind::polygon, {{5, 5, 10}, {30, 5, 10}, {30, 5, -20}}, true},
};

}  // namespace

class HoleMarkTest : public QObject {
    Q_OBJECT

  private slots:
    void whatReachesIntoAHoleIsMarked() {
        for (const Case& each : kCases) {
            const Measured value = valueOf(each.kind, each.places);
            QVERIFY2(value.acrossHole == each.marked, each.what);
            QVERIFY2(std::string_view(value.text).ends_with(kMark) == each.marked, each.what);
            QVERIFY2(value.details.starts_with("It reaches where slices were not measured") == each.marked, each.what);
        }
    }

    /// The number is that of the same places on a scan without a hole.
    void aMarkChangesNoNumber() {
        const Volume whole(kScan.geometry(), Voxels(kScan.voxels().begin(), kScan.voxels().end()));
        for (const Case& each : kCases) {
            const Measured marked = valueOf(each.kind, each.places);
            const Measured plain = *measured({1, each.kind, "", typed(each.places)}, whole);
            QVERIFY2(marked.value == plain.value && marked.plusMinus == plain.plusMinus, each.what);
            QVERIFY2(!plain.acrossHole && marked.text == plain.text + (each.marked ? kMark : ""), each.what);
        }
    }

    void aRegionSaysHowManyOfItsVoxelsAreInterpolated() {
        const Measured polygon = valueOf(MeasureKind::polygon, {{5, 5, -5}, {30, 5, -5}, {30, 30, -5}});
        QCOMPARE(polygon.region->interpolated, polygon.region->count);
        const std::string said = std::to_string(polygon.region->count) + " of the voxels are interpolated";
        QVERIFY2(polygon.details.find(said) != std::string::npos, polygon.details.c_str());
        QCOMPARE(valueOf(MeasureKind::ball, {{20, 20, 1}, {25.9, 20, 1}}).region->interpolated, std::size_t(0));
    }

    void aProfileTellsWhereItIsInterpolated() {
        for (const measure::ProfileSample& sample : measure::profile(kScan, {9, 9, -20}, {9, 9, 17.5})) {
            const double z = sample.mm - 20;
            QCOMPARE(sample.acrossHole, z > -10 + 0.02 && z < -2.5 - 0.02);
        }
    }

    /// A plan keeps the holes of its scan: without the scan, the same values are marked.
    void withoutTheScanTheSameIsMarked() {
        SavedPlan saved;
        saved.scan = markOf(kScan, newSalt());
        saved.plan = test::someMarks();
        saved.plan.measurements.clear();
        for (const Case& each : kCases)
            saved.plan.measurements.push_back({saved.plan.measurements.size() + 1, each.kind, "", typed(each.places)});
        const auto read = planFromText(planText(saved), "test");
        QVERIFY2(bool(read), read ? "" : read.error().text().c_str());
        QVERIFY(*read == saved && read->scan.holes == holesOf(kScan));
        const std::vector<MarkRow> rows = marksTableWithoutScan(*read);
        std::size_t known = 0;
        for (std::size_t n = 0; n < rows.size(); ++n) {
            known += bool(rows[n].value);
            QVERIFY2(!rows[n].value || rows[n].value->acrossHole == kCases[n].marked, kCases[n].what);
        }
        QVERIFY(known >= 9);
    }

    void aPlanWithABadHoleIsRefused() {
        SavedPlan saved;
        saved.scan = markOf(kScan, newSalt());
        saved.plan = test::someMarks();
        saved.scan.holes[0].normal *= 2;
        const auto read = planFromText(planText(saved), "test");
        QVERIFY(!read && read.error().text().find("scan.holes[0].normal") != std::string::npos);
    }

    void filesForOtherProgramsCarryTheMark() {
        SavedPlan saved;
        saved.plan.measurements = {{1, kCases[0].kind, "", typed(kCases[0].places)},
                                   {2, kCases[1].kind, "", typed(kCases[1].places)}};
        const std::vector<MarkRow> rows = marksTable(saved.plan, kScan);
        const QStringList lines = QString::fromStdString(marksCsv(rows)).split("\r\n");
        const auto fromTheEnd = lines[0].split(',').size() - lines[0].split(',').indexOf("across_hole");
        const auto crosses = [&](const QString& line) {
            const QStringList fields = line.split(',');  // only texts before this column may contain commas
            return fields[fields.size() - fromTheEnd];
        };
        QCOMPARE(crosses(lines[1]), "no");
        QCOMPARE(crosses(lines[2]), "yes");
        QVERIFY(!lines[1].contains(kMark) && lines[2].contains(kMark));
        const QByteArray slicers = QByteArray::fromStdString(marksForSlicer(rows));
        QCOMPARE(slicers.count("PD-Render distance, across a hole"), 1);
        QCOMPARE(slicers.count(kMark), 1);
    }
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::HoleMarkTest)
#include "hole_mark_test.moc"
