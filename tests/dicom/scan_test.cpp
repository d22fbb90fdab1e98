#include "tests/support/dicom/slice_file.h"

#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "dicom/import.h"
#include "tests/support/dicom/slice_folder.h"

using namespace pdr;
using namespace pdr::dicom;
using test::SliceFile;

namespace fs = std::filesystem;

namespace {

/// Drops root's rights during its lifetime.
class Nobody {
  public:
    Nobody() : wasRoot_(geteuid() == 0) {
        if (wasRoot_ && seteuid(65534) != 0)
            qWarning("root's rights could not be put down");
    }
    ~Nobody() {
        if (wasRoot_ && seteuid(0) != 0)
            qWarning("root's rights could not be taken up again");
    }

  private:
    bool wasRoot_;
};

}  // namespace

class ScanTest : public QObject {
    Q_OBJECT

    /// Returns the note on files that may be slices of `series`.
    static std::string unreadOf(const Series& series) {
        for (const Note& note : series.verdict.notes)
            if (note.code == "unread")
                return note.text;
        return {};
    }

  private slots:
    void anyNameAtAnyDepthIsFound() {
        test::SliceFolder folder;
        fs::create_directories(folder.path() / "a" / "b c");
        test::writeSliceFile(folder.path() / "a" / "b c" / "no extension", {});
        test::writeSliceFile(folder.path() / "upper.TXT", {.position = {0, 0, 1}});
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.filesSeen, 2);
        QCOMPARE(scan.series.size(), std::size_t(1));
        QVERIFY(scan.series.front().verdict.loadable());
    }

    /// Values that a table gives are no HU without it, and numbers of another kind are an image all the same.
    void whatCannotBeReadIsNamed() {
        const auto reasonOf = [](const std::function<void(DcmDataset&)>& change) {
            test::SliceFolder folder;
            folder.addStack(3, {.change = change});
            const ScanResult scan = folder.scan();
            return scan.series.size() == 1 && !scan.series[0].verdict.loadable()
                       ? QString::fromStdString(scan.series[0].verdict.reason)
                       : QString("not refused");
        };
        const QString byTable = reasonOf([](DcmDataset& data) {
            DcmItem* table = nullptr;
            data.findOrCreateSequenceItem(DCM_ModalityLUTSequence, table);
            table->putAndInsertString(DCM_ModalityLUTType, "US");
        });
        QVERIFY2(byTable.contains("Modality LUT Sequence"), qPrintable(byTable));
        const QString floats = reasonOf([](DcmDataset& data) {
            auto* pixels = new DcmFloatingPointSingle(DCM_FloatPixelData);
            const std::vector<Float32> values(12, 40.0f);
            pixels->putFloat32Array(values.data(), 12);
            data.insert(pixels);
        });
        QVERIFY2(floats.contains("holds pixels twice"), qPrintable(floats));
    }

    void foreignFilesAreCountedAndForgotten() {
        test::SliceFolder folder;
        folder.addStack(3);
        folder.addText("notes.txt", "The patient was well.");
        folder.addText("README", "The patient was well.");
        folder.addText("long.bin", std::string(100000, 'x'));
        folder.addText(".hidden", "");
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.filesSeen, 7);
        QCOMPARE(scan.notDicom, 4);
        QVERIFY(scan.problems.empty());
        QCOMPARE(scan.series.size(), std::size_t(1));
    }

    void loadableSeriesComeFirstAndLargerBeforeSmaller() {
        test::SliceFolder folder;
        folder.addStack(1, {.seriesUid = "1.2.3.9"}, "single");
        folder.addStack(2, {.seriesUid = "1.2.3.2"}, "two");
        folder.addStack(5, {.seriesUid = "1.2.3.3"}, "five");
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(3));
        QCOMPARE(scan.series[0].slices.size(), std::size_t(5));
        QCOMPARE(scan.series[1].slices.size(), std::size_t(2));
        QVERIFY(!scan.series[2].verdict.loadable());
    }

    void slicesComeInTheOrderOfTheNormal() {
        test::SliceFolder folder;
        for (int k = 0; k < 4; ++k)
            test::writeSliceFile(folder.path() / std::to_string(k), {.position = {0, 0, -3.0 * k}});
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series[0].slices.front().file.filename().string(), std::string("3"));
        QCOMPARE(scan.series[0].slices.back().file.filename().string(), std::string("0"));
    }

    void pixelSpacingNamesTheRowsFirst() {
        test::SliceFolder folder;
        for (int k = 0; k < 2; ++k) {
            SliceFile slice{.position = {0, 0, 3.0 * k}};
            slice.change = [](DcmDataset& data) { data.putAndInsertString(DCM_PixelSpacing, "2\\0.5"); };
            test::writeSliceFile(folder.path() / std::to_string(k), slice);
        }
        QVERIFY(glm::distance(folder.scan().series[0].geometry.spacingMm(), dvec3(0.5, 2, 3)) < 1e-12);
    }

    void samePlaceWithOtherPixelsIsAConflict() {
        test::SliceFolder folder;
        folder.addStack(3);
        test::writeSliceFile(folder.path() / "other", {.position = {0, 0, 2}, .raw = {99}});
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series[0].verdict.stack, Stack::doubled);
        QVERIFY(scan.series[0].verdict.reason.find("other") != std::string::npos);
        QVERIFY(scan.series[0].verdict.reason.find("s01") != std::string::npos);
    }

    void seriesThatLiesThereTwiceLoadsOnce() {
        test::SliceFolder folder;
        folder.addStack(5);
        for (int k = 0; k < 5; ++k)
            fs::copy_file(folder.path() / ("s0" + std::to_string(k)),
                          folder.path() / std::string("again").append(std::to_string(k)));
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(1));
        QVERIFY(scan.series[0].verdict.loadable());
        QCOMPARE(scan.series[0].slices.size(), std::size_t(5));
        QVERIFY(scan.series[0].verdict.notes[0].text.find("5 copies of slices left out") != std::string::npos);
    }

    void localizerWithinTheSeriesDoesNotSpoilIt() {
        test::SliceFolder folder;
        folder.addStack(3);
        SliceFile scout{.size = {8, 8}, .position = {5, 5, 5}};
        scout.change = [](DcmDataset& data) { data.putAndInsertString(DCM_ImageType, "ORIGINAL\\PRIMARY\\LOCALIZER"); };
        test::writeSliceFile(folder.path() / "scout", scout);
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(2));
        QVERIFY(scan.series[0].verdict.loadable());
        QCOMPARE(scan.series[1].verdict.stack, Stack::notCt);
    }

    void textWithoutItsCharacterSetStaysPrintable() {
        test::SliceFolder folder;
        SliceFile slice;
        slice.change = [](DcmDataset& data) {
            data.putAndInsertString(DCM_SpecificCharacterSet, "NO SUCH SET");
            data.putAndInsertString(DCM_PatientName, "M\xfcller");
        };
        test::writeSliceFile(folder.path() / "a", slice);
        QCOMPARE(folder.scan().series[0].patient.name, std::string("M?ller"));
    }

    void linksAreFollowed() {
        test::SliceFolder files, folder;
        files.addStack(4);
        fs::create_directory(folder.path() / "there");
        fs::create_symlink(files.path() / "s00", folder.path() / "a file");
        fs::create_directory_symlink(files.path(), folder.path() / "there" / "a folder");
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.filesSeen, 4);
        QVERIFY(!scan.series.empty() && scan.series.front().verdict.loadable());
        QVERIFY(scan.series.front().verdict.notes.empty());
    }

    void linksInCirclesAndUpwardsReadNothingTwice() {
        test::SliceFolder folder;
        folder.addStack(2);
        fs::create_directories(folder.path() / "a" / "b");
        fs::create_directory_symlink(folder.path(), folder.path() / "round");
        fs::create_directory_symlink(folder.path() / "a", folder.path() / "a" / "b" / "up");
        fs::create_directory_symlink(folder.path().parent_path(), folder.path() / "out");
        fs::create_directory_symlink("/", folder.path() / "everything");
        fs::create_symlink(folder.path() / "s00", folder.path() / "again");
        QCOMPARE(folder.scan().filesSeen, 2);
    }

    void linkToNowhereIsAProblem() {
        test::SliceFolder folder;
        folder.addStack(2);
        fs::create_symlink("gone", folder.path() / "link");
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.problems.size(), std::size_t(1));
        QCOMPARE(scan.problems[0].reason, std::string("the link leads nowhere"));
    }

    void wrongPlacesGetASentence_data() {
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("word");
        QTest::newRow("missing") << "missing"
                                 << "no such folder";
        QTest::newRow("file") << "file"
                              << "not a folder";
        QTest::newRow("empty") << "empty"
                               << "empty";
        QTest::newRow("text") << "text"
                              << "the only file is not a DICOM image";
    }
    void wrongPlacesGetASentence() {
        QFETCH(QString, place);
        QFETCH(QString, word);
        test::SliceFolder folder;
        folder.addText("file", "text");
        fs::create_directories(folder.path() / "empty");
        fs::create_directories(folder.path() / "text");
        folder.addText("text/note", "text");
        const auto scan = scanFolder(folder.path() / place.toStdString(), noProgress);
        QVERIFY(!scan);
        QVERIFY2(scan.error().what.find(word.toStdString()) != std::string::npos, scan.error().what.c_str());
        QVERIFY(!scan.error().hint.empty());
        QCOMPARE(scan.error().where, (folder.path() / place.toStdString()).string());
    }

    void lockedFolderGetsASentence() {
        test::SliceFolder folder;
        folder.addStack(2);
        chmod(folder.path().c_str(), 0);
        {
            const Nobody nobody;
            const auto scan = scanFolder(folder.path(), noProgress);
            QVERIFY(!scan);
            QVERIFY2(scan.error().what.find("ermission") != std::string::npos, scan.error().text().c_str());
        }
        chmod(folder.path().c_str(), 0700);
    }

    void lockedFileIsAProblemOfItsOwn() {
        test::SliceFolder folder;
        folder.addStack(3);
        chmod(folder.path().c_str(), 0755);
        chmod((folder.path() / "s02").c_str(), 0);
        const Nobody nobody;
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.problems.size(), std::size_t(1));
        QCOMPARE(scan.problems[0].file.filename().string(), std::string("s02"));
        QCOMPARE(scan.problems[0].reason, std::string("the file cannot be read (Permission denied)"));
        QCOMPARE(scan.series[0].slices.size(), std::size_t(2));
        QVERIFY2(unreadOf(scan.series[0]).find("s02") != std::string::npos, unreadOf(scan.series[0]).c_str());
    }

    /// A stack is even without its last slice: only a note shows that there was one.
    void endSliceThatCannotBeReadIsNamed_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("left");
        QTest::newRow("empty") << "s04" << QByteArray();
        QTest::newRow("empty, of any name") << "anything" << QByteArray();
        QTest::newRow("100 bytes") << "s04" << QByteArray(100, '\0');
        QTest::newRow("garbage") << "s04" << QByteArray(20000, 'x');
        QTest::newRow("cut in its header") << "s04" << QByteArray(128, '\0') + "DICM" + QByteArray(8, '\2');
    }
    void endSliceThatCannotBeReadIsNamed() {
        QFETCH(QString, name);
        QFETCH(QByteArray, left);
        test::SliceFolder folder;
        folder.addStack(4);
        folder.addText(name.toStdString(), left.toStdString());
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(1));
        QVERIFY(scan.series[0].verdict.loadable());
        QCOMPARE(scan.problems.size(), std::size_t(1));
        QCOMPARE(scan.notDicom, 0);
        const std::string note = unreadOf(scan.series[0]);
        QVERIFY2(note.starts_with("1 file could not be read, and slices of this series may be missing (" +
                                  name.toStdString() + ")"),
                 note.c_str());
    }

    void garbageThatEndsAsTheSlicesDoIsNamed() {
        test::SliceFolder folder;
        for (int k = 0; k < 3; ++k)
            test::writeSliceFile(folder.path() / ("a" + std::to_string(k) + ".dcm"), {.position = {0, 0, 2.0 * k}});
        folder.addText("f3c.DCM", "garbage");
        QVERIFY(!unreadOf(folder.scan().series[0]).empty());
    }

    /// Damaged files elsewhere are not noted on a series, unless they may belong to any series.
    void damageIsNamedWhereItMayBelong() {
        test::SliceFolder folder;
        for (const char* name : {"one", "two", "three"})
            fs::create_directory(folder.path() / name);
        folder.addStack(3, {.seriesUid = "1.2.3.1"}, "one/s");
        folder.addStack(2, {.seriesUid = "1.2.3.2"}, "two/s");
        folder.addText("two/s02", "");
        const auto notes = [](const ScanResult& scan) {
            return std::pair(unreadOf(scan.series.at(0)), unreadOf(scan.series.at(1)));
        };
        QCOMPARE(notes(folder.scan()).first, std::string());
        QVERIFY(notes(folder.scan()).second.find("two/s02") != std::string::npos);
        fs::remove(folder.path() / "two" / "s02");
        folder.addText("three/s02", std::string(128, '\0').append("DICM"));
        QVERIFY(notes(folder.scan()).first.find("three/s02") != std::string::npos);
        QVERIFY(notes(folder.scan()).second.find("three/s02") != std::string::npos);
    }

    void cancelEndsEachStepSoon() {
        test::SliceFolder folder;
        folder.addStack(20);
        const Progress never = [](double, std::string_view) { return false; };
        const auto cancelled = scanFolder(folder.path(), never);
        QVERIFY(!cancelled);
        QVERIFY(cancelled.error().kind == ErrorKind::cancelled);
        const ScanResult scan = folder.scan();
        const auto volume = loadSeries(scan.series[0], Padding::maskAsAir, never);
        QVERIFY(!volume);
        QVERIFY(volume.error().kind == ErrorKind::cancelled);
    }

    void progressRunsFromZeroToOne() {
        test::SliceFolder folder;
        folder.addStack(20);
        std::vector<double> fractions;
        const Progress note = [&](double fraction, std::string_view) {
            fractions.push_back(fraction);
            return true;
        };
        QVERIFY(bool(loadSeries(folder.scan().series[0], Padding::maskAsAir, note)));
        QCOMPARE(fractions.front(), 0.0);
        QCOMPARE(fractions.back(), 1.0);
        QVERIFY(std::is_sorted(fractions.begin(), fractions.end()));
    }

    void vanishedFileIsNamed() {
        test::SliceFolder folder;
        folder.addStack(3);
        const ScanResult scan = folder.scan();
        fs::remove(folder.path() / "s01");
        const auto volume = loadSeries(scan.series[0], Padding::maskAsAir, noProgress);
        QVERIFY(!volume);
        QVERIFY(volume.error().where.find("s01") != std::string::npos);
    }

    void changedFileIsNamed() {
        test::SliceFolder folder;
        folder.addStack(3);
        const ScanResult scan = folder.scan();
        test::writeSliceFile(folder.path() / "s01", {.size = {9, 9}});
        const auto volume = loadSeries(scan.series[0], Padding::maskAsAir, noProgress);
        QVERIFY(!volume);
        QVERIFY(volume.error().where.find("s01") != std::string::npos);
        QVERIFY(volume.error().what.find("changed") != std::string::npos);
    }

    void volumeLargerThanMemoryIsRefusedWithFigures() {
        test::SliceFolder folder;
        folder.addStack(2);
        Series series = folder.scan().series[0];
        series.geometry.size = {2'000'000, 2'000'000, 2};
        const auto volume = loadSeries(series, Padding::maskAsAir, noProgress);
        QVERIFY(!volume);
        QVERIFY2(volume.error().what.find("17000.0 GB") != std::string::npos, volume.error().what.c_str());
        QVERIFY(volume.error().what.find("free") != std::string::npos);
    }
};

QTEST_APPLESS_MAIN(ScanTest)
#include "scan_test.moc"
