/// The slices that `pdrender-cli slice` writes, and what it says.

#include <QtTest>

#include <QImage>

#include <cmath>
#include <fstream>

#include "render/slice/grey_window.h"
#include "tests/support/dicom/slice_folder.h"
#include "tests/support/exr_channels.h"
#include "tests/support/program_run.h"
#include "tests/support/scenes/made_volume.h"

using namespace pdr;
using test::ProgramRun;

namespace {

constexpr ivec3 kSize(90, 70, 8);

/// Slices of a patient with a name, through a window of their own.
void writeFolder(const test::SliceFolder& folder, const std::string& window = "40\\100") {
    folder.addStack(kSize.z, {.size = ivec2(kSize)}, "s", [&](int k, test::SliceFile& slice) {
        for (int j = 0; j < kSize.y; ++j)
            for (int i = 0; i < kSize.x; ++i)
                slice.raw.push_back(std::uint16_t(test::madeHu(i, j, k)));
        slice.change = [&window](DcmDataset& data) {
            data.putAndInsertString(DCM_PatientName, "Secret^Agnes");
            data.putAndInsertString(DCM_PatientID, "Key4711");
            data.putAndInsertString(DCM_SeriesDescription, "Secretive");
            data.putAndInsertString(DCM_WindowCenter, window.substr(0, window.find('\\')).c_str());
            data.putAndInsertString(DCM_WindowWidth, window.substr(window.find('\\') + 1).c_str());
        };
    });
}

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class SliceCommandTest : public QObject {
    Q_OBJECT

    QTemporaryDir out_;
    test::SliceFolder folder_;

    QString at(const QString& name) const { return out_.filePath(name); }
    QString folder() const { return QString::fromStdString(folder_.path().string()); }
    static ProgramRun slice(const QStringList& arguments) {
        return test::runProgram("pdrender-cli", QStringList("slice") + arguments);
    }
    /// Slices the folder into the file `name`.
    ProgramRun sliced(const QString& name, const QStringList& options) const {
        return slice(QStringList{folder(), "-o", at(name)} + options);
    }

  private slots:
    void initTestCase() { writeFolder(folder_); }

    /// Axial slice 5 is the fifth from the feet, and row 0 of it is anterior: the voxels, bit by bit.
    void openExrHoldsTheHu() {
        const ProgramRun run = sliced("a.exr", {"--plane", "axial", "--index", "5"});
        QVERIFY2(run.code == 0, run.err.constData());
        const std::vector<float> hu = test::exrChannel(at("a.exr").toStdString(), "HU");
        QCOMPARE(hu.size(), std::size_t(kSize.x * kSize.y));
        for (int j = 0; j < kSize.y; ++j)
            for (int i = 0; i < kSize.x; ++i)
                QCOMPARE(hu[std::size_t(j * kSize.x + i)], float(test::madeHu(i, j, 5)));
        QVERIFY2(run.out.contains("axial slice 5, z = 10.00 mm: 90 x 70 pixels of 1 mm"), run.out.constData());
        QVERIFY(run.out.contains("a.exr"));
    }

    /// Seen from the left the front is on the left, and the head is above: slices are 2 mm apart, pixels 1 mm.
    void aPlaceBetweenSlicesIsInterpolated() {
        QCOMPARE(sliced("s.exr", {"--plane", "sagittal", "--at", "33.5"}).code, 0);
        const std::vector<float> hu = test::exrChannel(at("s.exr").toStdString(), "HU");
        QCOMPARE(hu.size(), std::size_t(kSize.y * 17));  // 14 mm between the outer centres, a pixel above and below
        for (int j = 0; j < kSize.y; ++j)
            for (int k = 0; k < kSize.z; ++k) {
                const double mean = (test::madeHu(33, j, k) + test::madeHu(34, j, k)) / 2.0;
                QCOMPARE(double(hu[std::size_t((15 - 2 * k) * kSize.y + j)]), mean);
            }
    }

    void pngIsSeenThroughTheWindow() {
        const auto greyOf = [&](const QStringList& window, const GreyWindow& expected) {
            const ProgramRun run =
                sliced("w.png", QStringList{"--plane", "axial", "--index", "3", "--annotations", "none"} + window);
            const QImage image(at("w.png"));
            bool same = run.code == 0 && image.size() == QSize(kSize.x, kSize.y);
            for (int j = 0; same && j < kSize.y; ++j)
                for (int i = 0; same && i < kSize.x; ++i)
                    same = qGreen(image.pixel(i, j)) == greyLevel(expected, test::madeHu(i, j, 3));
            return same;
        };
        QVERIFY(greyOf({}, {40, 100}));
        QVERIFY(greyOf({"--window", "file"}, {40, 100}));
        QVERIFY(greyOf({"--window", "500.5/1000"}, {500.5, 1000}));
        QVERIFY(greyOf({"--window", "Temporal bone"}, {700, 4000}));
        QCOMPARE(QImage(at("w.png")).text("pdrender/window"), QString("700/4000"));
        QVERIFY(!greyOf({"--window", "whole"}, {700, 4000}));
    }

    /// What an image must say wherever it goes.
    void pngSaysWhatItShowsAndNeverWhoItIs() {
        QCOMPARE(sliced("n.png", {"--plane", "coronal", "--annotations", "none"}).code, 0);
        QCOMPARE(sliced("n.exr", {"--plane", "coronal"}).code, 0);
        const QImage bare(at("n.png"));
        QCOMPARE(bare.text("Comment"), QString("Not for diagnostic use."));
        QCOMPARE(bare.text("pdrender/slice"), QString("coronal"));
        QCOMPARE(bare.text("pdrender/down"), QString("0 0 -1"));
        QCOMPARE(sliced("l.png", {"--plane", "axial"}).code, 0);
        QCOMPARE(sliced("b.png", {"--plane", "axial", "--annotations", "none"}).code, 0);
        const QImage letters(at("l.png")), plain(at("b.png"));
        const auto marked = [&](const QRect& part) { return letters.copy(part) != plain.copy(part); };
        QVERIFY(marked({0, 25, 20, 20}) && marked({70, 25, 20, 20}) && marked({35, 0, 20, 20}));
        for (const char* file : {"n.png", "n.exr", "l.png"})
            for (const char* secret : {"Secret", "Agnes", "Key4711", "1.2.3.1"})
                QVERIFY2(!contents(at(file)).contains(secret), secret);
        QVERIFY(QFile::permissions(at("n.exr")).testFlag(QFile::ReadOwner));
        QVERIFY(!QFile::permissions(at("n.exr")).testFlag(QFile::ReadGroup));
    }

    void wrongUsageIsTwo_data() {
        QTest::addColumn<QStringList>("options");
        QTest::addColumn<QByteArray>("named");
        const auto row = [](const char* name, const QStringList& options, const char* named) {
            QTest::newRow(name) << options << QByteArray(named);
        };
        row("no plane", {"-o", "a.png"}, "--plane: says which slice");
        row("no such plane", {"-o", "a.png", "--plane", "oblique"}, "axial, coronal or sagittal");
        row("no output", {"--plane", "axial"}, "-o: says where");
        row("unknown ending", {"--plane", "axial", "-o", "a.tif"}, "must end in .png or .exr, not be a.tif");
        row("index", {"--plane", "axial", "-o", "a.png", "--index", "-1"}, "--index");
        row("both", {"--plane", "axial", "-o", "a.png", "--index", "1", "--at", "2"}, "Leave one of them out");
        row("window", {"--plane", "axial", "-o", "a.png", "--window", "liver"}, "There are: soft tissue");
        row("window of no width", {"--plane", "axial", "-o", "a.png", "--window", "40/0"}, "at least 1 HU");
        row("two inputs", {"b", "--plane", "axial", "-o", "a.png"}, "needs one folder");
    }

    void wrongUsageIsTwo() {
        QFETCH(QStringList, options);
        QFETCH(QByteArray, named);
        const ProgramRun run = slice(QStringList("a") + options);
        QCOMPARE(run.code, 2);
        QVERIFY2(run.err.contains(named), run.err.constData());
    }

    void aSliceThatIsNotThereIsSaidWithTheRange() {
        const ProgramRun index = sliced("x.png", {"--plane", "axial", "--index", "8"});
        QCOMPARE(index.code, 1);
        QVERIFY2(index.err.contains("--index: must be from 0 to 7: the scan has 8 axial slices"),
                 index.err.constData());
        const ProgramRun place = sliced("x.png", {"--plane", "coronal", "--at", "70"});
        QCOMPARE(place.code, 1);
        QVERIFY2(place.err.contains("--at: must be from -0.50 to 69.50 mm"), place.err.constData());
        QVERIFY(!QFile::exists(at("x.png")));
    }

    void ofSeveralSeriesTheFirstIsTakenAndTheOthersAreSaid() {
        const test::SliceFolder two;
        writeFolder(two);
        two.addStack(5, {.size = {20, 20}, .seriesUid = "1.2.3.2"}, "other");
        const QString path = QString::fromStdString(two.path().string());
        const ProgramRun first = slice({path, "--plane", "axial", "-o", at("t.exr")});
        QCOMPARE(first.code, 0);
        QVERIFY2(first.err.contains("there are 2 series here, and this is the first; --series"), first.err.constData());
        const ProgramRun other = slice({path, "--plane", "axial", "-o", at("t.exr"), "--series", "1.2.3.2"});
        QVERIFY(other.out.contains("20 x 20 pixels") && !other.err.contains("2 series"));
    }

    void aWindowThatCannotBeUsedIsSaid() {
        const test::SliceFolder wrong;
        writeFolder(wrong, "40\\0");
        const QString path = QString::fromStdString(wrong.path().string());
        const ProgramRun usual = slice({path, "--plane", "axial", "-o", at("u.png")});
        QCOMPARE(usual.code, 0);
        QVERIFY2(usual.err.contains("no window is 0 wide"), usual.err.constData());
        QCOMPARE(QImage(at("u.png")).text("pdrender/window"), QString("50/350"));
        QCOMPARE(slice({path, "--plane", "axial", "-o", at("u.png"), "--window", "file"}).code, 1);
    }

    /// Measured is what was read: a scene's clamp and its interpolation are left out.
    void aSceneFileNamesTheScanOnly() {
        std::ofstream raw(at("v.raw").toStdString(), std::ios::binary);
        for (int n = 0; n < 16 * 16 * 4; ++n) {
            const std::int16_t hu = test::madeHu(n % 16, n / 16 % 16, n / 256);
            raw.write(reinterpret_cast<const char*>(&hu), 2);
        }
        raw.close();
        std::ofstream(at("v.json").toStdString()) << R"({ "format": "pdrender-scene", "version": 1,
                    "volume": { "raw": "v.raw", "size": [16, 16, 4], "spacingMm": [1, 1, 3], "clampHu": [0, 10] },
                    "transferFunction": { "extinctionPerMm": 0.5, "nodes": [ { "hu": 0, "opacity": 0 }, { "hu": 9, "opacity": 1 } ] },
                    "camera": { "eyeMm": [8, -80, 6], "targetMm": [8, 8, 6], "fovDegrees": 25 },
                    "film": { "width": 48, "height": 40 } })";
        const ProgramRun run = slice({at("v.json"), "--plane", "axial", "--index", "2", "-o", at("v.exr")});
        QVERIFY2(run.code == 0, run.err.constData());
        const std::vector<float> hu = test::exrChannel(at("v.exr").toStdString(), "HU");
        for (int n = 0; n < 16 * 16; ++n)
            QCOMPARE(hu[std::size_t(n)], float(test::madeHu(n % 16, n / 16, 2)));
        const ProgramRun who = slice({at("v.json"), "--plane", "axial", "-o", at("v.png"), "--annotations", "patient"});
        QCOMPARE(who.code, 1);
        QVERIFY(who.err.contains("a raw file knows no patient"));
    }
};

QTEST_GUILESS_MAIN(SliceCommandTest)
#include "slice_command_test.moc"
