#include <QProcess>
#include <QRegularExpression>
#include <QTest>

#include "dicom/import.h"
#include "dicom/reference.h"
#include "tests/support/dicom/slice_folder.h"
#include "tests/support/patience.h"
#include "tests/support/test_tool.h"

using namespace pdr;
using namespace pdr::dicom;

namespace fs = std::filesystem;

/// Identities of slices and series, as other objects may cite them.
class ReferenceTest : public QObject {
    Q_OBJECT

    /// Returns the reference to a stack of three, slice k changed by `change(k, data)`.
    static SeriesReference ofStack(const std::function<void(int, DcmDataset&)>& change) {
        const test::SliceFolder folder;
        folder.addStack(3, {}, "s", [&](int k, test::SliceFile& slice) {
            slice.change = [&change, k](DcmDataset& data) {
                data.putAndInsertString(DCM_SOPInstanceUID, ("1.2.3.4." + std::to_string(k)).c_str());
                data.putAndInsertString(DCM_FrameOfReferenceUID, "1.2.3.9");
                change(k, data);
            };
        });
        const ScanResult scan = folder.scan();
        return scan.series.empty() ? SeriesReference{} : referenceTo(scan.series.front());
    }
    /// Returns the reference to such a stack whose slices all state `value` for `tag`.
    static SeriesReference stating(const DcmTagKey& tag, const std::string& value) {
        return ofStack([&](int, DcmDataset& data) { data.putAndInsertString(tag, value.c_str()); });
    }

    /// Returns the value of an element as DCMTK's dcmdump prints it.
    static QString dumped(const fs::path& file, const char* element) {
        QProcess process;
        process.start("dcmdump", {"-Un", "+P", element, QString::fromStdString(file.string())});
        process.waitForFinished(test::kPatience);
        const QString line = QString::fromLocal8Bit(process.readAllStandardOutput()).section('\n', 0, 0);
        return QRegularExpression("\\[([^\\]]*)\\]").match(line).captured(1);
    }

  private slots:
    void aSliceIsItsClassItsInstanceAndItsFrame() {
        const SeriesReference reference = ofStack([](int, DcmDataset&) {});
        QCOMPARE(reference.studyUid, std::string("1.2.3"));
        QCOMPARE(reference.seriesUid, std::string("1.2.3.1"));
        QCOMPARE(reference.frameOfReferenceUid, std::string("1.2.3.9"));
        QCOMPARE(reference.images.size(), std::size_t(3));
        for (std::size_t k = 0; k < 3; ++k) {
            QCOMPARE(reference.images[k].classUid, std::string(UID_CTImageStorage));
            QCOMPARE(reference.images[k].instanceUid, "1.2.3.4." + std::to_string(k));
            QCOMPARE(reference.images[k].frame, 1);
            QVERIFY(reference.images[k].isComplete());
        }
    }

    /// References follow the slices, which are sorted by position, not by file name.
    void referencesAreInTheOrderOfTheSlices() {
        const SeriesReference reference = ofStack([](int k, DcmDataset& data) {
            data.putAndInsertString(DCM_ImagePositionPatient, ("0\\0\\" + std::to_string(10 - 2 * k)).c_str());
        });
        QCOMPARE(reference.images.at(0).instanceUid, std::string("1.2.3.4.2"));
        QCOMPARE(reference.images.at(2).instanceUid, std::string("1.2.3.4.0"));
    }

    void malformedUidsAreLeftOut_data() {
        QTest::addColumn<std::string>("uid");
        QTest::addColumn<bool>("isWellFormed");
        const auto row = [](const char* name, const std::string& uid, bool ok) { QTest::newRow(name) << uid << ok; };
        row("plain", "1.2.840.10008", true);
        row("64 characters", "1." + std::string(62, '2'), true);
        row("leading zero, as archives hold them", "1.2.03", true);
        row("absent", "", false);
        row("65 characters", "1." + std::string(63, '2'), false);
        row("letters", "1.2.anonymous", false);
        row("a path", "../../etc", false);
        row("two dots", "1..2", false);
        row("dot in front", ".1.2", false);
        row("dot behind", "1.2.", false);
        row("two values", "1.2\\1.3", false);
    }
    void malformedUidsAreLeftOut() {
        QFETCH(std::string, uid);
        QFETCH(bool, isWellFormed);
        const std::string expected = isWellFormed ? uid : std::string();
        QCOMPARE(stating(DCM_StudyInstanceUID, uid).studyUid, expected);
        QCOMPARE(stating(DCM_SeriesInstanceUID, uid).seriesUid, expected);
        QCOMPARE(stating(DCM_FrameOfReferenceUID, uid).frameOfReferenceUid, expected);
        QCOMPARE(stating(DCM_SOPClassUID, uid).images.at(1).classUid, expected);
        const auto one = [&](int k, DcmDataset& data) {
            if (k == 1)
                data.putAndInsertString(DCM_SOPInstanceUID, uid.c_str());
        };
        const SeriesReference reference = ofStack(one);
        QCOMPARE(reference.images.at(1).instanceUid, expected);
        QCOMPARE(reference.images.at(1).isComplete(), isWellFormed);
        QVERIFY(reference.images.at(0).isComplete() && reference.images.at(2).isComplete());
    }

    /// What cannot be cited can still be seen.
    void withoutIdentityAStackLoadsAsBefore() {
        const test::SliceFolder folder;
        folder.addStack(3);
        for (const char* name : {"s00", "s01", "s02"}) {
            DcmFileFormat content;
            QVERIFY(content.loadFile((folder.path() / name).c_str()).good());
            for (const DcmTagKey& tag :
                 {DCM_SOPClassUID, DCM_SOPInstanceUID, DCM_StudyInstanceUID, DCM_SeriesInstanceUID})
                delete content.getDataset()->remove(tag);
            QVERIFY(content.getDataset()->saveFile((folder.path() / name).c_str(), EXS_LittleEndianExplicit).good());
        }
        const ScanResult scan = folder.scan();
        QVERIFY(bool(loadSeries(scan.series.at(0), Padding::maskAsAir, noProgress)));
        const SeriesReference reference = referenceTo(scan.series.at(0));
        QVERIFY(reference.studyUid.empty() && reference.seriesUid.empty() && reference.frameOfReferenceUid.empty());
        QCOMPARE(reference.images.size(), std::size_t(3));
        for (const ImageReference& image : reference.images)
            QVERIFY(!image.isComplete());
    }

    /// Two images under one UID load, as before, but a reference to either would be a guess.
    void anInstanceUidOfTwoSlicesNamesNone() {
        const SeriesReference reference = ofStack([](int k, DcmDataset& data) {
            if (k > 0)
                data.putAndInsertString(DCM_SOPInstanceUID, "1.2.3.4.7");
        });
        QCOMPARE(reference.images.size(), std::size_t(3));
        QVERIFY(reference.images[0].isComplete());
        QVERIFY(reference.images[1].instanceUid.empty() && reference.images[2].instanceUid.empty());
    }

    /// De-identified series have one frame of reference per slice: they load, with a note, but share no coordinates.
    void severalFramesOfReferenceAreNone() {
        const auto change = [](int k, DcmDataset& data) {
            data.putAndInsertString(DCM_FrameOfReferenceUID, k == 2 ? "1.2.3.8" : "1.2.3.9");
        };
        const SeriesReference reference = ofStack(change);
        QCOMPARE(reference.images.size(), std::size_t(3));
        QVERIFY(reference.frameOfReferenceUid.empty());
        const auto absent = [](int k, DcmDataset& data) {
            if (k == 2)
                data.findAndDeleteElement(DCM_FrameOfReferenceUID);
        };
        QVERIFY(ofStack(absent).frameOfReferenceUid.empty());
    }

    void framesOfOneInstanceAreToldApart() {
        Series series;
        for (int frame = 0; frame < 3; ++frame) {
            SliceRef slice{"enhanced.dcm", frame};
            slice.identity.sopClassUid = UID_EnhancedCTImageStorage;
            slice.identity.sopInstanceUid = "1.2.3.4";
            series.slices.push_back(slice);
        }
        const SeriesReference reference = referenceTo(series);
        for (int frame = 0; frame < 3; ++frame) {
            QVERIFY(reference.images.at(std::size_t(frame)).isComplete());
            QCOMPARE(reference.images.at(std::size_t(frame)).frame, frame + 1);
        }
    }

    /// Every reference of the real series is what DCMTK's dcmdump reads in the file.
    void realReferencesAreThoseOfAnotherReader() {
        PDR_NEEDS_SHARED_CT();
        PDR_NEEDS_TOOL("dcmdump", "dcmtk");
        int complete = 0;
        for (const char* folder : {"tilt_siemens4", "tiny_ct", "rescale_per_slice", "duplicates", "chest_contrast"}) {
            const auto scan = scanFolder(test::sharedCt() / folder, noProgress);
            QVERIFY(bool(scan));
            for (const Series& series : scan->series) {
                const SeriesReference reference = referenceTo(series);
                for (std::size_t k = 0; k < series.slices.size(); k += 9) {
                    const auto read = [&](const char* element) {
                        return dumped(series.slices[k].file, element).toStdString();
                    };
                    QCOMPARE(reference.studyUid, read("0020,000d"));
                    QCOMPARE(reference.seriesUid, read("0020,000e"));
                    if (!reference.frameOfReferenceUid.empty())
                        QCOMPARE(reference.frameOfReferenceUid, read("0020,0052"));
                    if (!reference.images[k].isComplete())
                        continue;
                    QCOMPARE(reference.images[k].classUid, read("0008,0016"));
                    QCOMPARE(reference.images[k].instanceUid, read("0008,0018"));
                    ++complete;
                }
            }
        }
        QVERIFY2(complete >= 10, std::to_string(complete).c_str());
    }
};

QTEST_APPLESS_MAIN(ReferenceTest)
#include "reference_test.moc"
