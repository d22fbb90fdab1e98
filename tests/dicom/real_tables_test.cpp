/// The tables of real scanners, and the patients on them.

#include <QTest>

#include "dicom/import.h"
#include "render/segment/hidden_table.h"
#include "render/volume/raw_file.h"
#include "tests/support/dicom/shared_data.h"

using namespace pdr;
using segment::HiddenTable;

namespace {

struct Case {
    Volume volume;
    HiddenTable table;
};

std::vector<Case> casesIn(const std::string& folder) {
    std::vector<Case> cases;
    const auto scan = dicom::scanFolder(test::sharedCt() / folder, noProgress);
    if (!scan)
        return cases;
    for (const dicom::Series& series : scan->series) {
        auto volume = dicom::loadSeries(series, dicom::Padding::maskAsAir, noProgress);
        if (!series.verdict.loadable() || !volume)
            continue;
        const HiddenTable table = *segment::hideTable(*volume, noProgress);
        cases.push_back({*std::move(volume), table});
    }
    return cases;
}

/// Returns the solid voxels that are hidden although shown voxels enclose them from all four sides of their slice, as a
/// fraction of the body: the rule would have taken them out of the patient.
double shareLostInside(const Case& one) {
    const ivec3 size = one.volume.size();
    const std::int16_t *before = one.volume.voxels().data(), *after = one.table.body->voxels().data();
    std::int64_t lost = 0, solid = 0;
    std::vector<int> first(std::size_t(size.x)), last(std::size_t(size.x));  // solid in a column of the slice
    for (int z = 0; z < size.z; ++z) {
        const std::size_t slice = std::size_t(z) * size.x * size.y;
        const auto shown = [&](int x, int y) { return after[slice + std::size_t(y) * size.x + x] > -300; };
        for (int x = 0; x < size.x; ++x) {
            first[std::size_t(x)] = size.y;
            last[std::size_t(x)] = -1;
            for (int y = 0; y < size.y; ++y)
                if (shown(x, y)) {
                    first[std::size_t(x)] = std::min(first[std::size_t(x)], y);
                    last[std::size_t(x)] = y;
                }
        }
        for (int y = 0; y < size.y; ++y) {
            int left = size.x, right = -1;
            for (int x = 0; x < size.x; ++x)
                if (shown(x, y)) {
                    left = std::min(left, x);
                    right = x;
                }
            for (int x = 0; x < size.x; ++x) {
                const bool hidden = before[slice + std::size_t(y) * size.x + x] > -300 && !shown(x, y);
                solid += shown(x, y);
                lost += hidden && x > left && x < right && y > first[std::size_t(x)] && y < last[std::size_t(x)];
            }
        }
    }
    return double(lost) / double(solid);
}

bool within(double value, double expected, double share) {
    return std::abs(value - expected) <= share * expected;
}

}  // namespace

class RealTablesTest : public QObject {
    Q_OBJECT

  private slots:
    /// The expected millilitres were measured with another program (Python, the same rule).
    void aChestLosesItsTable() {
        PDR_NEEDS_SHARED_CT();
        const std::vector<Case> cases = casesIn("chest_contrast");
        QCOMPARE(cases.size(), std::size_t(1));
        const HiddenTable& table = cases[0].table;
        QVERIFY2(within(table.hiddenMl, 884, 0.02), qPrintable(QString::number(table.hiddenMl)));
        QVERIFY2(within(table.cutMl, 34, 0.1), qPrintable(QString::number(table.cutMl)));
        QVERIFY2(within(table.bodyMl, 16800, 0.02), qPrintable(QString::number(table.bodyMl)));
        QCOMPARE(table.parts, 1);
        QVERIFY2(shareLostInside(cases[0]) < 0.005, qPrintable(QString::number(shareLostInside(cases[0]))));
        const auto dense = [](const Volume& volume) {
            return std::count_if(volume.voxels().begin(), volume.voxels().end(), [](int hu) { return hu > 800; });
        };
        QVERIFY(dense(cases[0].volume) > 50000);
        QCOMPARE(dense(*table.body),
                 dense(cases[0].volume));  // no compact bone is lost: this table has nothing so dense
    }

    void aHeadLosesItsHolder() {
        const std::filesystem::path file = std::filesystem::path(PDR_SOURCE_DIR) / "build/example/matrix.dat";
        if (!std::filesystem::exists(file))
            PDR_SKIP_FOR_WANT_OF_DATA("the example's voxels are not there: ./bootstrap test unpacks them");
        Result<Volume> head = loadRaw({file, RawFile::Type::int16, {256, 256, 108}, {0.9570312, 0.9570312, 1.5}, {}});
        QVERIFY(head);
        const HiddenTable table = *segment::hideTable(*head, noProgress);
        QVERIFY2(within(table.hiddenMl, 98, 0.02), qPrintable(QString::number(table.hiddenMl)));
        QCOMPARE(table.cutMl, 0.0);
        QVERIFY2(within(table.bodyMl, 3200, 0.02), qPrintable(QString::number(table.bodyMl)));
        QVERIFY(shareLostInside({*std::move(head), table}) < 0.005);
    }

    void hiddenTwiceIsHiddenOnce() {
        PDR_NEEDS_SHARED_CT();
        const std::vector<Case> cases = casesIn("chest_contrast");
        QCOMPARE(cases.size(), std::size_t(1));
        const HiddenTable again = *segment::hideTable(*cases[0].table.body, noProgress);
        QVERIFY2(again.hiddenMl < 5, qPrintable(QString::number(again.hiddenMl)));
    }

    /// A few slices, thick slices, phantoms: no error, and no patient is lost where there is nothing to hide.
    void everySeriesIsDecidedOrSaysWhyNot() {
        PDR_NEEDS_SHARED_CT();
        int loaded = 0;
        for (const char* folder : {"duplicates", "rescale_per_slice", "ct_plus_rtstruct", "enhanced_ct_le",
                                   "reformat_mixed_orient", "truncated/series"})
            for (const Case& one : casesIn(folder)) {
                ++loaded;
                QVERIFY(!one.table.undecided.empty() || one.table.bodyMl > 0);
                if (one.table.body)
                    QVERIFY2(one.table.hiddenMl < 0.1 * one.table.bodyMl && shareLostInside(one) < 0.005, folder);
            }
        QVERIFY(loaded > 0);
    }
};

QTEST_APPLESS_MAIN(RealTablesTest)
#include "real_tables_test.moc"
