/// Uneven series that are shown with even slices if that is asked for.

#include <QTest>

#include <algorithm>

#include "dicom/import.h"
#include "render/volume/holes.h"
#include "tests/support/dicom/slice_folder.h"

using namespace pdr;
using namespace pdr::dicom;
using test::SliceFile;

namespace {

constexpr ivec2 kSize{4, 3};
constexpr int kPixels = 12;
constexpr std::int16_t kPadding = 7;

/// Writes slices at those heights [mm], of which pixel i of slice k stores 1000 + 100 k + i.
void addSlices(const test::SliceFolder& folder, const std::vector<double>& heightsMm, dvec2 driftPerMm = dvec2(0)) {
    folder.addStack(int(heightsMm.size()), {.size = kSize}, "s", [&](int k, SliceFile& slice) {
        const double z = heightsMm[std::size_t(k)];
        slice.position = dvec3(driftPerMm * (z - heightsMm.front()), z);
        slice.raw.clear();
        for (int i = 0; i < kPixels; ++i)
            slice.raw.push_back(std::uint16_t(1000 + 100 * k + i));
    });
}

int huAt(const Volume& volume, int k, int i) {
    return volume.voxels()[std::size_t(k * kPixels + i)];
}

}  // namespace

class ResampledSeriesTest : public QObject {
    Q_OBJECT

  private slots:
    /// It is an entry of its own, behind all that are shown unasked, and says what was done. The refusal stays.
    void anUnevenSeriesIsOfferedResampled() {
        test::SliceFolder folder;
        addSlices(folder, {0, 2, 4, 8, 10});
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(2));
        const Series &made = scan.series[0], &uneven = scan.series[1];
        QVERIFY(made.series.resampled && made.verdict.loadable() && !uneven.series.resampled);
        QCOMPARE(uneven.verdict.stack, Stack::gap);
        QCOMPARE(made.series.id(), uneven.series.id() + "#resampled");
        QCOMPARE(made.geometry.size, ivec3(kSize, 6));
        QCOMPARE(made.verdict.notes.front().code, std::string("resampled"));
        const std::string note = made.verdict.notes.front().text;
        for (const char* said : {"5 slices, 2 to 4 mm apart", "6 every 2 mm", "up to 2 mm from where"})
            QVERIFY2(note.find(said) != std::string::npos, note.c_str());
        QCOMPARE(made.verdict.notes.back().code, std::string("holes:4.00-8.00"));
        QVERIFY(made.verdict.notes.back().text.find("a hole from 4 to 8 mm above the lowest") != std::string::npos);
    }

    void measuredSlicesStayAndMissingOnesAreBetween() {
        test::SliceFolder folder;
        addSlices(folder, {0, 2, 4, 8, 10});
        const Series series = folder.scan().series.front();
        const auto volume = loadSeries(series, Padding::maskAsAir, noProgress);
        QVERIFY2(bool(volume), volume ? "" : volume.error().text().c_str());
        QVERIFY(volume->geometry().patientFromIndex == series.geometry.patientFromIndex);
        QVERIFY(volume->remarks().find("resampled") != std::string::npos);
        QVERIFY(holesOf(*volume) == (std::vector<Hole>{{{0, 0, 1}, 4, 8}}));
        for (int i = 0; i < kPixels; ++i)
            for (const auto& [k, stored] : {std::pair(0, 1000), {1, 1100}, {2, 1200}, {3, 1250}, {4, 1300}, {5, 1400}})
                QCOMPARE(huAt(*volume, k, i), stored + i);
    }

    /// Air behind a patient is measured; what is only half measured is not.
    void whatLiesBesidePaddingIsPadding() {
        test::SliceFolder folder;
        folder.addStack(4, {.size = kSize}, "s", [](int k, SliceFile& slice) {
            slice.position = {0, 0, k < 2 ? 2.0 * k : 2.0 * k + 2};
            slice.raw.assign(kPixels, std::uint16_t(k == 1 ? 1100 : 1300));
            if (k == 1)
                slice.raw[5] = kPadding;
            slice.change = [](DcmDataset& data) { data.putAndInsertSint16(DCM_PixelPaddingValue, kPadding); };
        });
        const ScanResult scan = folder.scan();
        QVERIFY(scan.series.front().series.resampled);
        const auto volume = loadSeries(scan.series.front(), Padding::maskAsAir, noProgress);
        QVERIFY(volume && volume->size().z == 5);
        QCOMPARE(huAt(*volume, 2, 4), 1200);
        for (const int k : {1, 2}) {
            QCOMPARE(volume->voxels()[std::size_t(k * kPixels + 5)], Volume::kAirHu);
            QVERIFY(volume->isPadding(std::size_t(k * kPixels + 5)));
        }
        QVERIFY(!volume->isPadding(2 * kPixels + 4) && !volume->isPadding(3 * kPixels + 5));
    }

    /// Slices drift by 0.25 mm along rows and -0.5 mm along columns for each mm.
    void aTiltedSeriesIsResampledAlongItsDrift() {
        test::SliceFolder folder;
        addSlices(folder, {0, 2, 4, 8, 10}, {0.25, -0.5});
        const Series series = folder.scan().series.front();
        QVERIFY(series.series.resampled);
        QVERIFY(glm::distance(dvec3(series.geometry.patientFromIndex[2]), dvec3(0.5, -1, 2)) < 1e-9);
        QCOMPARE(series.verdict.notes[1].code, std::string("tilt"));
        const auto volume = loadSeries(series, Padding::maskAsAir, noProgress);
        QVERIFY(bool(volume));
        QCOMPARE(huAt(*volume, 3, 4), 1254);
    }

    /// A scan with a hole that nobody would look across is refused and no more.
    void wideHolesAreNotOffered() {
        test::SliceFolder folder;
        addSlices(folder, {0, 2, 4, 36, 38});
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(1));
        QCOMPARE(scan.series[0].verdict.stack, Stack::gap);
    }
};

QTEST_GUILESS_MAIN(ResampledSeriesTest)
#include "resampled_series_test.moc"
