/// The table of a plan's measurements: the values of the window, and what is known without the scan.

#include <QTest>
#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "app/plan/marks_table.h"
#include "tests/support/some_marks.h"

namespace pdr::app {
namespace {

const Volume kScan = test::scanOfMarks();
const std::vector<MarkRow> kRows = marksTable(test::someMarks(), kScan);

std::vector<MarkRow> withoutScan(std::vector<Measurement> measurements, dvec3 spacingMm) {
    SavedPlan saved;
    saved.plan.measurements = std::move(measurements);
    saved.scan.spacingMm = spacingMm;
    return marksTableWithoutScan(saved);
}

/// Returns a distance between two edges along `direction`.
Measurement plate(double thicknessMm, dvec3 direction) {
    return {1,
            MeasureKind::distance,
            "",
            {test::atEdge({0, 0, 9}), test::atEdge(dvec3(0, 0, 9) + thicknessMm * glm::normalize(direction))}};
}

}  // namespace

class MarksTableTest : public QObject {
    Q_OBJECT

  private slots:
    void rowsAreTheMeasurementsInTheirOrder() {
        const std::vector<Measurement> measurements = test::someMarks().measurements;
        QCOMPARE(kRows.size(), measurements.size());
        for (std::size_t n = 0; n < kRows.size(); ++n) {
            QCOMPARE(kRows[n].id, measurements[n].id);
            QCOMPARE(kRows[n].name, measurements[n].name);
            QVERIFY(kRows[n].kind == measurements[n].kind && kRows[n].places == measurements[n].places);
            QVERIFY(kRows[n].places.size() <= kMostPlaces || kRows[n].kind == MeasureKind::polygon);
            const auto value = measured(measurements[n], kScan);
            QCOMPARE(bool(kRows[n].value), bool(value));
            QCOMPARE(readable(kRows[n]), value ? std::string(value->text) : std::string(value.error().what));
            if (value)
                QVERIFY(kRows[n].value->value == value->value && kRows[n].value->plusMinus == value->plusMinus);
        }
    }

    /// Numbers count what has a name as well, as in the window.
    void whatHasNoNameHasANumber() {
        std::vector<std::string> titles;
        for (const MarkRow& row : kRows)
            titles.push_back(row.title);
        const std::vector<std::string> expected{"Distance 1",     "=2+3",        "Größe, \"alt\"", "Angle 1",
                                                "'quoted'\nname", "Two lines 1", "aorta",          "Ball 1",
                                                "Ellipse 1",      "Polygon 1",   "Ball 2"};
        QVERIFY(titles == expected);
    }

    /// Whatever is stated without the scan is what the scan would have stated, however it lies.
    void withoutTheScanNothingIsStatedThatItCouldChange() {
        const dvec3 spacing(0.9, 0.9, 2.5);
        const double turns[] = {0, 0.4, 1.1};
        int stated = 0, kept = 0;
        for (double thickness = 0.25; thickness < 14; thickness += 0.25)
            for (const dvec3 direction : {dvec3(1, 0, 0), dvec3(0, 0, 1), dvec3(1, 1, 1)}) {
                const Measurement one = plate(thickness, direction);
                const MarkRow row = withoutScan({one}, spacing)[0];
                ++(row.value ? stated : kept);
                for (const double turn : turns) {
                    VolumeGeometry lying = VolumeGeometry::aligned(ivec3(9), spacing, dvec3(0));
                    lying.patientFromIndex = glm::rotate(dmat4(1), turn, dvec3(1, 2, 3)) * lying.patientFromIndex;
                    lying.patientFromIndex[2].y += 0.6;  // a tilted gantry
                    const auto truth = measured(one, Volume(lying, Voxels(lying.voxelCount(), 0)));
                    if (row.value)
                        QVERIFY(row.value->bound == truth->bound && row.value->value == truth->value);
                }
            }
        QVERIFY2(stated > kept, qPrintable(QString("%1 stated, %2 not").arg(stated).arg(kept)));
        QVERIFY(kept > 0);
    }

    void withoutTheScanOtherValuesAreThemselves() {
        const std::vector<MarkRow> rows = withoutScan(test::someMarks().measurements, {0.9, 0.9, 2.5});
        for (std::size_t n = 0; n < rows.size(); ++n) {
            const bool ofVoxels = rows[n].kind == MeasureKind::point || hasMiddle(rows[n].kind);
            QCOMPARE(readable(rows[n]), ofVoxels ? "not known without the scan" : readable(kRows[n]));
        }
    }
};

}  // namespace pdr::app

QTEST_GUILESS_MAIN(pdr::app::MarksTableTest)
#include "marks_table_test.moc"
