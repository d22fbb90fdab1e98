/// The grey window that files ask for.

#include <QTest>

#include <string>

#include "dicom/import.h"
#include "tests/support/dicom/slice_folder.h"

using namespace pdr;
using namespace pdr::dicom;
using test::SliceFile;

namespace {

struct Stated {
    std::string centre, width, function = "";
};

void state(SliceFile& slice, const Stated& stated) {
    slice.change = [stated](DcmDataset& data) {
        if (!stated.centre.empty())
            data.putAndInsertString(DCM_WindowCenter, stated.centre.c_str());
        if (!stated.width.empty())
            data.putAndInsertString(DCM_WindowWidth, stated.width.c_str());
        if (!stated.function.empty())
            data.putAndInsertString(DCM_VOILUTFunction, stated.function.c_str());
    };
}

/// Returns the only series of a folder whose slices state what `of` returns for their number.
Series seriesStating(int slices, const std::function<Stated(int)>& of) {
    test::SliceFolder folder;
    folder.addStack(slices, {}, "s", [&](int k, SliceFile& slice) { state(slice, of(k)); });
    const ScanResult scan = folder.scan();
    return scan.series.size() == 1 ? scan.series.front() : Series{};
}

StatedWindow windowOf(const Stated& stated) {
    return seriesStating(3, [&](int) { return stated; }).window;
}

bool operator==(const StatedWindow& stated, const GreyWindow& expected) {
    return stated.ignored.empty() && stated.window == expected;
}

}  // namespace

class StatedWindowTest : public QObject {
    Q_OBJECT

  private slots:
    void theWindowIsReadWithItsFunction() {
        QVERIFY(windowOf({"40", "400"}) == GreyWindow({40, 400}));
        QVERIFY(windowOf({"-600.5 ", "1.5e3", "LINEAR"}) == GreyWindow({-600.5, 1500}));
        QVERIFY(windowOf({"40", "0.5", "LINEAR_EXACT"}) == GreyWindow({40, 0.5, VoiFunction::linearExact}));
        QVERIFY(windowOf({"40", "80", "SIGMOID"}) == GreyWindow({40, 80, VoiFunction::sigmoid}));
    }

    void ofSeveralTheFirstCounts() { QVERIFY(windowOf({"40\\-600", "400\\1500"}) == GreyWindow({40, 400})); }

    void withoutOneThereIsNothingToSay() {
        const StatedWindow none = windowOf({"", ""});
        QVERIFY(!none.window && none.ignored.empty());
    }

    void oneThatCannotBeUsedIsLeftOutAndSaid() {
        for (const Stated& wrong :
             {Stated{"40", ""}, Stated{"", "400"}, Stated{"40", "0"}, Stated{"40", "-5"}, Stated{"40", "0.5"},
              Stated{"4,0", "400"}, Stated{"40", "wide"}, Stated{"40", "0", "SIGMOID"}, Stated{"40", "400", "CUBIC"}}) {
            const StatedWindow stated = windowOf(wrong);
            QVERIFY(!stated.window);
            QVERIFY2(stated.ignored.starts_with("the grey window in the files is left out: "), stated.ignored.c_str());
        }
        QVERIFY(windowOf({"40", "400", "CUBIC"}).ignored.find("CUBIC") != std::string::npos);
    }

    void slicesThatDifferAreSeenThroughTheWindowOfTheMiddleOne() {
        const auto own = [](int k) { return Stated{std::to_string(10 * k), "400"}; };
        QVERIFY(seriesStating(5, own).window == GreyWindow({20, 400}));
        const auto middleWithout = [&](int k) { return k == 2 ? Stated{"x", "400"} : own(k + 1); };
        QVERIFY(seriesStating(5, middleWithout).window == GreyWindow({10, 400}));
    }

    /// A window is a way to look: HU, notes and remarks on images stay as they are.
    void theVolumeDoesNotKnowIt() {
        test::SliceFolder with, without;
        with.addStack(3, {}, "s", [](int, SliceFile& slice) { state(slice, {"40", "0"}); });
        without.addStack(3);
        const Series a = with.scan().series.front(), b = without.scan().series.front();
        QVERIFY(!a.window.ignored.empty());
        QCOMPARE(a.verdict.notes.size(), b.verdict.notes.size());
        const auto seen = loadSeries(a, Padding::maskAsAir, noProgress),
                   plain = loadSeries(b, Padding::maskAsAir, noProgress);
        QVERIFY(std::ranges::equal(seen->voxels(), plain->voxels()));
        QCOMPARE(seen->remarks(), plain->remarks());
    }
};

QTEST_APPLESS_MAIN(StatedWindowTest)
#include "stated_window_test.moc"
