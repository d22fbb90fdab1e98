#include "tests/support/dicom/damaged_streams.h"

#include <QTest>

#include <algorithm>

#include "dicom/import.h"
#include "tests/support/dicom/slice_folder.h"

using namespace pdr;
using namespace pdr::dicom;
using test::SliceFile;

namespace {

/// Returns the text of the note with this code; empty if there is none.
std::string noteOf(const std::vector<Note>& notes, const std::string& code) {
    const auto found = std::find_if(notes.begin(), notes.end(), [&](const Note& note) { return note.code == code; });
    return found == notes.end() ? "" : found->text;
}

int loadable(const ScanResult& scan) {
    return int(
        std::count_if(scan.series.begin(), scan.series.end(), [](const Series& s) { return s.verdict.loadable(); }));
}

void putSpacing(SliceFile& slice, const char* spacing) {
    slice.change = [spacing](DcmDataset& data) { data.putAndInsertString(DCM_PixelSpacing, spacing); };
}

void putNumber(SliceFile& slice, int number) {
    slice.change = [number](DcmDataset& data) {
        data.putAndInsertString(DCM_InstanceNumber, std::to_string(number).c_str());
    };
}

}  // namespace

class NotesTest : public QObject {
    Q_OBJECT

  private slots:
    void huBeyondSixteenBitsIsSaidWithItsCount() {
        test::SliceFolder folder;
        folder.addStack(2, {.size = {4, 3}}, "", [](int, SliceFile& slice) {
            slice.raw = {20000, 20000, 100};
            slice.change = [](DcmDataset& data) { data.putAndInsertString(DCM_RescaleSlope, "4"); };
        });
        std::vector<Note> notes;
        const auto volume = loadSeries(folder.scan().series.front(), Padding::maskAsAir, noProgress, &notes);
        QVERIFY(bool(volume));
        QVERIFY2(noteOf(notes, "clipped").starts_with("4 voxels lie beyond"), noteOf(notes, "clipped").c_str());
        QCOMPARE(volume->remarks(), std::string("clipped"));
    }

    void paddingBeyondSixteenBitsIsNotSaid() {
        test::SliceFolder folder;
        folder.addStack(2, {.size = {4, 3}}, "", [](int, SliceFile& slice) {
            slice.raw = {0x8000, 0x8000, 100};
            slice.change = [](DcmDataset& data) {
                data.putAndInsertString(DCM_RescaleIntercept, "-1024");
                data.putAndInsertSint16(DCM_PixelPaddingValue, -32768);
            };
        });
        std::vector<Note> notes;
        const auto volume = loadSeries(folder.scan().series.front(), Padding::maskAsAir, noProgress, &notes);
        QVERIFY(bool(volume));
        QCOMPARE(volume->paddingCount(), std::size_t(4));
        QCOMPARE(noteOf(notes, "clipped"), std::string());
    }

    void lossyCodingIsSaid() {
        test::SliceFolder folder;
        for (int k = 0; k < 2; ++k) {
            SliceFile slice = test::tissueSlice({64, 64}, unsigned(k));
            slice.position.z = k;
            QVERIFY(test::writeCompressedSlice(folder.path() / std::to_string(k), slice, EXS_JPEGProcess2_4));
        }
        const ScanResult scan = folder.scan();
        const std::string note = noteOf(scan.series.front().verdict.notes, "lossy");
        QVERIFY2(note.find("2 slices were compressed with loss (JPEG Extended") == 0, note.c_str());
        QVERIFY2(note.find(":1)") != std::string::npos, note.c_str());
        const auto volume = loadSeries(scan.series.front(), Padding::maskAsAir, noProgress);
        QVERIFY(bool(volume));
        QCOMPARE(volume->remarks(), std::string("lossy"));
    }

    void lossOfAnEarlierCodingIsSaid() {
        test::SliceFolder folder;
        folder.addStack(3, {.size = {4, 3}}, "", [](int, SliceFile& slice) {
            slice.change = [](DcmDataset& data) {
                data.putAndInsertString(DCM_LossyImageCompression, "01");
                data.putAndInsertString(DCM_LossyImageCompressionRatio, "10");
            };
        });
        const std::string note = noteOf(folder.scan().series.front().verdict.notes, "lossy");
        QVERIFY2(note.find("an earlier coding, 10:1") != std::string::npos, note.c_str());
    }

    void spacingThatChangesALittleStaysOneVolume() {
        test::SliceFolder folder;
        folder.addStack(24, {.size = {512, 4}}, "",
                        [](int k, SliceFile& slice) { putSpacing(slice, k < 12 ? "0.7\\0.7" : "0.7\\0.7001"); });
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(1));
        QVERIFY(scan.series.front().geometry.size == ivec3(512, 4, 24));
        const std::string note = noteOf(scan.series.front().verdict.notes, "grid");
        QVERIFY2(note.find("up to 0.051 mm") != std::string::npos, note.c_str());
    }

    void directionThatChangesALittleStaysOneVolume() {
        test::SliceFolder folder;
        folder.addStack(24, {.size = {128, 4}}, "", [](int k, SliceFile& slice) {
            const char* directions = k < 12 ? "1\\0\\0\\0\\1\\0" : "1\\0.0003\\0\\-0.0003\\1\\0";
            slice.change = [=](DcmDataset& data) { data.putAndInsertString(DCM_ImageOrientationPatient, directions); };
        });
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(1));
        QVERIFY(scan.series.front().verdict.loadable());
        const std::string note = noteOf(scan.series.front().verdict.notes, "grid");
        QVERIFY2(note.find("up to 0.038 mm") != std::string::npos, note.c_str());
    }

    void halvesOfAPatientAreNoVolumes_data() {
        QTest::addColumn<QString>("spacing");
        QTest::addColumn<bool>("alternate");
        QTest::newRow("a third of a millimetre at the corner") << "0.7\\0.7007" << false;
        QTest::newRow("another spacing") << "0.8\\0.8" << false;
        QTest::newRow("every other slice") << "0.8\\0.8" << true;
    }
    void halvesOfAPatientAreNoVolumes() {
        QFETCH(QString, spacing);
        QFETCH(bool, alternate);
        test::SliceFolder folder;
        const std::string other = spacing.toStdString();
        folder.addStack(24, {.size = {512, 4}}, "", [&](int k, SliceFile& slice) {
            putSpacing(slice, (alternate ? k % 2 == 0 : k < 12) ? "0.7\\0.7" : other.c_str());
        });
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(2));
        QCOMPARE(loadable(scan), 0);
        for (const Series& piece : scan.series) {
            QCOMPARE(piece.verdict.stack, Stack::mixedSize);
            QVERIFY2(piece.verdict.reason.find("00 and so on") != std::string::npos, piece.verdict.reason.c_str());
            QVERIFY(!loadSeries(piece, Padding::maskAsAir, noProgress));
        }
    }

    void partsOfASeriesHaveIdsOfTheirOwn() {
        test::SliceFolder folder;
        folder.addStack(6, {.size = {4, 3}}, "", [](int k, SliceFile& slice) {
            slice.position.z = 2.0 * (k / 2);
            if (k % 2 == 1)
                slice.change = [&, k](DcmDataset& data) {
                    data.putAndInsertString(DCM_ImageOrientationPatient, "1\\0\\0\\0\\0\\-1");
                    data.putAndInsertString(DCM_ImagePositionPatient, ("0\\" + std::to_string(k) + "\\0").c_str());
                };
        });
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(2));
        QCOMPARE(loadable(scan), 2);
        QCOMPARE(scan.series[0].series.id(), std::string("1.2.3.1"));
        QCOMPARE(scan.series[1].series.id(), std::string("1.2.3.1#2"));
    }

    void numbersFromAHundredAreAHabit() {
        test::SliceFolder folder;
        folder.addStack(110, {}, "", [](int k, SliceFile& slice) {
            slice.change = [k](DcmDataset& data) {
                data.putAndInsertString(DCM_InstanceNumber, std::to_string(100 + k).c_str());
            };
        });
        QCOMPARE(noteOf(folder.scan().series.front().verdict.notes, "incomplete"), std::string());
    }

    /// Some de-identifiers give every file a study of its own.
    void aStudyForEachSliceIsOneSeries() {
        test::SliceFolder folder;
        folder.addStack(12, {}, "", [](int k, SliceFile& slice) {
            slice.change = [k](DcmDataset& data) {
                data.putAndInsertString(DCM_StudyInstanceUID, ("1.2.3." + std::to_string(k)).c_str());
            };
        });
        const ScanResult scan = folder.scan();
        QCOMPARE(scan.series.size(), std::size_t(1));
        QVERIFY(scan.series.front().verdict.loadable() && scan.series.front().geometry.size.z == 12);
        const std::string note = noteOf(scan.series.front().verdict.notes, "studies");
        QVERIFY2(note.find("12 studies") != std::string::npos, note.c_str());
    }

    /// One series UID in two examinations: each is a volume of its own, and so are those of two patients.
    void studiesThatAreNoStackTogetherStayApart() {
        for (const DcmTagKey& tag : {DCM_StudyInstanceUID, DCM_PatientID}) {
            test::SliceFolder folder;
            folder.addStack(12, {}, "", [&](int k, SliceFile& slice) {
                if (tag == DCM_StudyInstanceUID)
                    slice.position.z = 2.0 * (k / 2);
                slice.change = [&, k](DcmDataset& data) { data.putAndInsertString(tag, k % 2 ? "1.2.4" : "1.2.5"); };
            });
            const ScanResult scan = folder.scan();
            QCOMPARE(scan.series.size(), std::size_t(2));
            QCOMPARE(loadable(scan), 2);
            for (const Series& series : scan.series)
                QVERIFY(series.geometry.size.z == 6 && noteOf(series.verdict.notes, "studies").empty());
        }
    }

    void twoImagesOfOnePlaceAreBothVolumes() {
        test::SliceFolder folder;
        folder.addStack(12, {.size = {512, 4}}, "", [](int k, SliceFile& slice) {
            slice.position.z = 2.0 * (k / 2);
            putSpacing(slice, k % 2 == 0 ? "0.7\\0.7" : "0.4\\0.4");
        });
        QCOMPARE(loadable(folder.scan()), 2);
    }

    void missingEndShowsInTheNumbers_data() {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("step");
        QTest::addColumn<QString>("words");
        QTest::newRow("complete") << 1 << 1 << "";
        QTest::newRow("complete, from the head down") << 10 << -1 << "";
        QTest::newRow("two missing at the start") << 3 << 1 << "2 slices may be missing";
        QTest::newRow("one missing at the end, from the head down") << 11 << -1 << "1 slice may be missing";
        QTest::newRow("numbered from a thousand") << 1001 << 1 << "";
        QTest::newRow("numbered by tens") << 10 << 10 << "";
    }
    void missingEndShowsInTheNumbers() {
        QFETCH(int, first);
        QFETCH(int, step);
        QFETCH(QString, words);
        test::SliceFolder folder;
        folder.addStack(10, {.size = {4, 3}}, "", [&](int k, SliceFile& slice) { putNumber(slice, first + step * k); });
        const std::string note = noteOf(folder.scan().series.front().verdict.notes, "incomplete");
        QVERIFY2(words.isEmpty() ? note.empty() : note.find(words.toStdString()) == 0, note.c_str());
    }

    /// What the acquisition made is there: then none is missing, whatever the numbers. A few that are not there may be
    /// missing at the end, where numbers cannot show it; many are of another reconstruction.
    void acquisitionsSayHowManyImagesTheyMade_data() {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("stated");
        QTest::addColumn<bool>("alternate");
        QTest::addColumn<QString>("words");
        QTest::newRow("complete, from 3 on") << 3 << 20 << false << "";
        QTest::newRow("not stated, from 3 on") << 3 << 0 << false << "2 slices may be missing";
        QTest::newRow("another number, from 3 on") << 3 << 22 << false << "2 slices may be missing";
        QTest::newRow("one more") << 1 << 21 << false
                                  << "1 slice may be missing: the files state that their acquisition";
        QTest::newRow("two more") << 1 << 22 << false << "2 slices may be missing: the files state that their";
        QTest::newRow("twice as many") << 1 << 40 << false << "";
        QTest::newRow("fewer") << 1 << 10 << false << "";
        QTest::newRow("one more, two acquisitions") << 1 << 21 << true << "";
    }
    void acquisitionsSayHowManyImagesTheyMade() {
        QFETCH(int, first);
        QFETCH(int, stated);
        QFETCH(bool, alternate);
        QFETCH(QString, words);
        test::SliceFolder folder;
        folder.addStack(20, {.size = {4, 3}}, "", [&](int k, SliceFile& slice) {
            slice.change = [=](DcmDataset& data) {
                data.putAndInsertString(DCM_InstanceNumber, std::to_string(first + k).c_str());
                data.putAndInsertString(DCM_AcquisitionNumber, alternate && k > 9 ? "2" : "1");
                if (stated > 0)
                    data.putAndInsertString(DCM_ImagesInAcquisition, std::to_string(stated).c_str());
            };
        });
        const std::string note = noteOf(folder.scan().series.front().verdict.notes, "incomplete");
        QVERIFY2(words.isEmpty() ? note.empty() : note.find(words.toStdString()) == 0, note.c_str());
    }

    void scoutsCountAmongTheNumbers() {
        test::SliceFolder folder;
        folder.addStack(10, {.size = {4, 3}}, "", [&](int k, SliceFile& slice) { putNumber(slice, k + 2); });
        SliceFile scout{.size = {8, 8}};
        scout.change = [](DcmDataset& data) {
            data.putAndInsertString(DCM_InstanceNumber, "1");
            data.putAndInsertString(DCM_ImageType, "ORIGINAL\\PRIMARY\\LOCALIZER");
        };
        test::writeSliceFile(folder.path() / "scout", scout);
        QCOMPARE(noteOf(folder.scan().series.front().verdict.notes, "incomplete"), std::string());
    }
};

QTEST_APPLESS_MAIN(NotesTest)
#include "notes_test.moc"
